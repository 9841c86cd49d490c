"""Sound to a moving robot: the runtime wires source, voice detector, recogniser, engine and executor.

``FileSource`` plays the session of the demo; a microphone is another source, and nothing else changes.

It prints::

    move
    turn
    navigate to the kitchen
    pick
    talk that is no command
    navigate to the living room
    place
    move
    navigate to the bedroom
    stop
    the robot stopped on its way, at (6.1, 5.3)
"""

from intent_engine import Executor, IntentEngine, Navigate, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.sources.file import FileSource


def tell(event: Heard) -> None:
    """Called with everything that happens, in order."""
    if event.kind is HeardKind.INTERPRETATION:
        for action in event.interpretation.actions:
            print(f"navigate to the {action.location}" if isinstance(action, Navigate) else action.type)
        if not event.interpretation.actions:
            print("talk that is no command")


engine = IntentEngine.from_files("grammars/en.yaml", locations="locations/home.yaml")
clock = VirtualClock()
robot = SimulatedRobot(clock)

with Executor(robot, clock=clock) as executor:
    Runtime(engine, executor, on_event=tell).run(FileSource("examples/demo.flac"))
    pose = robot.pose()
    print(f"the robot stopped on its way, at ({pose.x:.1f}, {pose.y:.1f})")
