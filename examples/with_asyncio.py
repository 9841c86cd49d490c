"""In an asyncio program: goals can be awaited, and a stop comes from anywhere.

This one uses the machine's own clock and takes as long as the robot does: half a second.

It prints::

    creeping ...
    creeping: succeeded
    driving ...
    driving: canceled (stop)
"""

import asyncio

from intent_engine import Executor, IntentEngine, SimulatedRobot


async def main() -> None:
    engine = IntentEngine.from_files("grammars/en.yaml")
    with Executor(SimulatedRobot()) as executor:
        print("creeping ...")
        (goal,) = executor.submit(engine.parse("go forward ten centimeters").actions)
        await goal
        print(f"creeping: {goal.state}")

        print("driving ...")
        (goal,) = executor.submit(engine.parse("go forward ten meters").actions)
        asyncio.get_running_loop().call_later(0.2, executor.stop)  # from another task, thread or signal as well
        await goal
        print(f"driving: {goal.state} ({goal.reason})")


asyncio.run(main())
