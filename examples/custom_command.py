"""A command of your own: a few lines of YAML, and a function that does it.

The grammar is custom_command.yaml, beside this file.

It prints::

    hey robot, could you wave at the camera
      *waves at camera, 2 times*
      succeeded
    wave at my sister five times
      *waves at sister, 5 times*
      succeeded
    wave at the ghost
      aborted: ghosts cannot see it
    don't wave
      rejected
"""

from pathlib import Path

from intent_engine import Custom, Executor, IntentEngine, RobotError, SimulatedRobot
from intent_engine.execution.clock import VirtualClock


def wave(action: Custom) -> None:
    """Called with the slots of the sentence. What it raises ends this goal and nothing else: a ``RobotError`` says why
    it cannot be done, and anything else is a fault, which is logged."""
    person = action.slots.get("person") or "everybody"
    if person == "ghost":
        raise RobotError("ghosts cannot see it")
    print(f"  *waves at {person}, {action.slots['times']:.0f} times*")


engine = IntentEngine.from_files(Path(__file__).with_suffix(".yaml"))
clock = VirtualClock()

with Executor(SimulatedRobot(clock), clock=clock, handlers={"wave": wave}) as executor:
    for text in (
        "hey robot, could you wave at the camera",
        "wave at my sister five times",
        "wave at the ghost",
        "don't wave",
    ):
        print(text)
        found = engine.parse(text)
        for goal in executor.submit(found.actions):
            goal.result()
            print(f"  {goal.state}" + (f": {goal.detail}" if goal.detail else ""))
        if not found.actions:
            print(f"  {found.status}")
