"""Your own robot: any object with these methods. All of them are quick: they start something and return.

This one only prints what it is told; the executor does the timing, here on a virtual clock.

It prints::

    drive at 0.5 m/s and 0.0 rad/s
    stop
    turn at 0.0 m/s and 0.5 rad/s
    stop
    pick up the box: rejected, this robot cannot pick
"""

from intent_engine import Capability, Executor, IntentEngine, Pose
from intent_engine.execution.clock import VirtualClock


class PrintingRobot:
    """A base without an arm and without a map: what it cannot do is refused with the reason."""

    capabilities = frozenset({Capability.MOVE, Capability.TURN})

    def __init__(self) -> None:
        self._last = (0.0, 0.0)

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        """Called at a fixed rate while it moves. A base must stop by itself ``valid_for`` s after the last call."""
        if (linear, angular) != self._last:
            self._last = (linear, angular)
            word = "drive" if linear else "turn" if angular else "stand"
            print("stop" if word == "stand" else f"{word} at {linear:.1f} m/s and {angular:.1f} rad/s")

    def stop(self) -> None:
        self.velocity(0.0, 0.0, 0.0)

    def pose(self) -> Pose | None:
        return None  # it cannot tell where it is

    def close(self) -> None:
        self.stop()

    # Never called, as it has none of these capabilities.
    def navigate(self, goal: Pose): ...
    def pick(self, object_name: str): ...
    def place(self, object_name: str | None, location: str | None): ...
    def cancel(self, task) -> None: ...


engine = IntentEngine.from_files("grammars/en.yaml")
clock = VirtualClock()

with Executor(PrintingRobot(), clock=clock) as executor:
    for text in ("go forward one meter", "turn left"):
        executor.submit(engine.parse(text).actions)[-1].result()
    (goal,) = executor.submit(engine.parse("pick up the box").actions)
    print(f"pick up the box: {goal.state}, {goal.detail}")
