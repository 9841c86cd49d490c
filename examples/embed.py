"""Text to a moving robot, and waiting until it has done what it was told.

On a virtual clock a minute of driving takes a moment. Leave the clock out, and it is the machine's own.

It prints::

    go forward two meters: succeeded, at (2.0, 0.0)
    turn left ninety degrees then go to the kitchen: succeeded, at (5.0, 2.0)
    don't move: rejected (negated: 'not')
"""

from intent_engine import Executor, IntentEngine, SimulatedRobot
from intent_engine.execution.clock import VirtualClock

engine = IntentEngine.from_files("grammars/en.yaml", locations="locations/home.yaml")
clock = VirtualClock()
robot = SimulatedRobot(clock)

with Executor(robot, clock=clock) as executor:
    for text in ("go forward two meters", "turn left ninety degrees then go to the kitchen", "don't move"):
        found = engine.parse(text)
        if not found.actions:
            print(f"{text}: {found.status} ({found.reason})")
            continue
        goals = executor.submit(found.actions)
        last = goals[-1].result()
        pose = robot.pose()
        print(f"{text}: {last.state}, at ({pose.x:.1f}, {pose.y:.1f})")
