"""The node ``intent_engine``: text in, a moving robot out.

In: ``voice_commands/text``, and ``voice_commands/amended_text`` for the last text with what belongs to it
(std_msgs/String), ``voice_commands/hold`` (std_msgs/Bool), ``voice_commands/stop`` (std_msgs/Empty),
``voice_commands/state`` (std_msgs/String), the services ``stop`` and ``~/reset`` (std_srvs/Trigger). Out:
``voice_commands/command``, ``voice_commands/action``, ``voice_commands/status`` and ``voice_commands/current_state``
(std_msgs/String), ``cmd_vel``, goals for the navigation. All names are relative and can be remapped.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Collection, Sequence
from typing import Any

from intent_engine.actions import Action
from intent_engine.engine import IntentEngine
from intent_engine.errors import IntentEngineError
from intent_engine.execution.events import Event
from intent_engine.execution.executor import Executor
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.journal import Journal
from intent_engine.execution.policy import Policy
from intent_engine.execution.robots.robot import Capability
from intent_engine.execution.robots.ros2 import Ros2Robot
from intent_engine.execution.robots.ros2_support import acknowledge
from intent_engine.execution.robots.ros2_velocity import GUARDIAN_SINK
from intent_engine.interpretation import Cause, Interpretation, Status
from intent_engine.needs import MOVING
from intent_engine.ros2.best_effort import HearAll
from intent_engine.ros2.clock import RosClock, sent_at
from intent_engine.ros2.messages import action_text, command_texts, event_text, interpretation_text, status_text
from intent_engine.ros2.parameters import NodeParameters, read_parameters
from intent_engine.ros2.process import run_script
from intent_engine.ros2.robot_states import States
from intent_engine.ros2.state_keeper import StateKeeper
from intent_engine.runtime.amending import CarriedOut
from intent_engine.runtime.last_asked import LastAsked
from intent_engine.runtime.last_said import LastSaid

__all__ = ["VoiceCommands", "main"]

_DONE_ALREADY = "it goes on from a command that is carried out already, and means the same"
_NO_TIME = "use_sim_time is set, and no time has come on /clock: is the simulator running?"
_TOO_LATE = "it does not go on from what is being done; say all of it again"


class VoiceCommands:
    """What the node does. Callbacks run in the thread that spins it, and none of them waits for a robot.

    Life cycle: made with a node -> the node is spun -> ``close`` while it is still spun: zero velocity, every goal
    cancelled, the last zeros acknowledged.

    Raises:
        ConfigError: a parameter, grammar, map or robot file is wrong.
        RobotError: the velocity's process could not be started, or nav2_msgs is missing and was asked for.
    """

    def __init__(self, node: Any) -> None:
        from std_msgs.msg import Bool, Empty, String

        self._node, self._log = node, node.get_logger()
        self._string = String
        parameters = read_parameters(node)
        self._form = parameters.command_form
        self._done: CarriedOut | None = None
        """The last text that was a command."""
        self._last = LastSaid(lambda: self.engine.grammars)
        self._asked = LastAsked()
        self.engine = IntentEngine.from_files(parameters.grammar, locations=parameters.locations)
        states = States(self.engine.states).with_parameter(parameters.states)
        self._warm_up()
        self._commands = node.create_publisher(String, "voice_commands/command", 10)
        self._actions = node.create_publisher(String, "voice_commands/action", 10)
        self._status = node.create_publisher(String, "voice_commands/status", 50)
        arm = {Capability.PICK, Capability.PLACE} & parameters.robot.capabilities
        self._handed_over = frozenset({"custom", *(each.value for each in arm)})
        """Types of the actions that other nodes do."""
        clock = RosClock(node) if node.get_parameter("use_sim_time").value else None
        self.robot = Ros2Robot(
            node,
            stamped=parameters.stamped,
            frame_id=parameters.frame_id,
            navigation=parameters.navigation,
            navigate_to_pose=parameters.navigate_to_pose,
            capabilities=parameters.robot.capabilities,
            clock=clock,
        )
        try:
            self.executor = self._make_executor(parameters, clock)
        except BaseException:
            self.robot.close()
            raise
        HearAll(node, String, "voice_commands/text", self._heard, self._would_stop)
        HearAll(node, String, "voice_commands/amended_text", self._heard_more, self._would_stop)
        HearAll(node, Bool, "voice_commands/hold", self._held, lambda message: message.data)
        HearAll(node, Empty, "voice_commands/stop", lambda message, info: self._stop())
        self._states = StateKeeper(node, states, self._say)
        self._offer_services()
        self._log.info(self._summary(parameters))

    def close(self) -> None:
        """Zero velocity and the end of every goal. Idempotent."""
        self.executor.close()
        self.robot.close()
        if self._journal is not None:
            self._journal.close()
        acknowledge(self._actions)

    # -- in ------------------------------------------------------------------------------------------------------------

    def _heard(self, message: Any, info: Any) -> None:
        """A text came in, and may answer what the one before asked back."""
        now, age = self.executor.clock.now(), _age(info)
        self._carry_out(message.data, age, self._take, self._asked.at(now - age))

    def _heard_more(self, message: Any, info: Any) -> None:
        """The last text came once more, with what belongs to it."""
        self._carry_out(message.data, _age(info), self._amend)

    def _carry_out(
        self,
        text: str,
        age: float,
        take: Callable[[Interpretation, float], Interpretation],
        asked: Interpretation | None = None,
    ) -> None:
        now = self.executor.clock.now()
        last = self._last.meaning if asked is None else asked
        try:
            found = self.engine.parse(text, state=self._state(), heard=True, last=last)
            if found.actions and not found.stops and self._has_no_time():
                found = Interpretation(text, Status.REJECTED, reason=_NO_TIME)
            found = take(found, now - age)
            self._asked.take(found, self._last.meaning, now - age)
        except Exception as error:
            # Whatever goes wrong with a text, the robot must not go on as if nothing had been said.
            self._stop()
            self._log.error(f"{text[:200]!r}: {type(error).__name__}: {error}; the robot is stopped")
            self._say("error", detail=f"{type(error).__name__}: {error}")
            return
        for command in command_texts(found, self._form):
            self._commands.publish(self._string(data=command))
        self._tell(interpretation_text(found, self._ros_time(now)))

    def _take(self, found: Interpretation, spoken_at: float) -> Interpretation:
        if found.status is Status.ACCEPTED:
            self.executor.deny(found.denied, spoken_at=spoken_at)  # "don't clean the lab, clean the hall"
            later = not found.stops and self.engine.comes_later(found.text)
            policy = Policy.FOLLOW if later else None
            guards = found.guards(self._told)
            goals = self.executor.submit(
                found.actions, spoken_at=spoken_at, policy=policy, text=found.text, guards=guards
            )
            self._done = CarriedOut(found, tuple(goals))
            self._last.take(found)
        elif self.executor.deny(found.denied, spoken_at=spoken_at) or (
            self.engine.takes_back(found.text) and Cause.NONE_MEANT not in found.causes
        ):
            self._last.forget()  # "no, three": whatever was meant, it was not that
        return found

    def _amend(self, found: Interpretation, spoken_at: float) -> Interpretation:
        if found.stops:
            self._stop(spoken_at)
        elif self.executor.deny(found.denied, spoken_at=spoken_at):
            self._last.forget()
        if found.stops or found.status is not Status.ACCEPTED:
            return found
        done = self._done
        if done is not None and done.says_no_more(found):  # whoever carries commands out must not be given it twice
            return Interpretation(found.text, Status.REJECTED, reason=_DONE_ALREADY)
        step = done.step_to(found) if done is not None else None
        if done is None or step is None:
            return Interpretation(found.text, Status.REJECTED, reason=_TOO_LATE)
        goals = self.executor.submit(
            step.actions,
            spoken_at=spoken_at,
            policy=step.policy,
            text=found.text,
            amends=step.amends,
            guards=step.guards_of(found, self._told),
        )
        self._done = done.grown_to(found, tuple(goals))
        self._last.take(found)
        return found

    def _stop(self, spoken_at: float | None = None) -> None:
        """The robot stops, and "again" means nothing until something else was done. ``spoken_at``: s on the executor's
        clock, when its words ended; None: now."""
        self.executor.stop(spoken_at=spoken_at)
        self._last.forget()
        self._asked.forget()

    def _would_stop(self, message: Any) -> bool:
        """Whether a text stops a robot that moves, or may."""
        found = self.engine.parse(message.data, state=self._told() | {MOVING}, heard=True)
        return found.stops or bool(found.denied) or self.engine.takes_back(message.data)

    def _held(self, message: Any, info: Any) -> None:
        """A stop word may have been heard, or it was none after all."""
        if message.data:
            self.executor.hold()
        else:
            self.executor.release()

    def _offer_services(self) -> None:
        try:
            from std_srvs.srv import Trigger
        except ImportError:
            self._log.warning("no services: std_srvs is not installed")
            return

        def stop(request: Any, response: Any) -> Any:
            self._stop()
            response.success, response.message = True, "stopped"
            return response

        def reset(request: Any, response: Any) -> Any:
            try:
                self.executor.reset()
                response.success = True
            except IntentEngineError as error:
                response.success, response.message = False, str(error)
            return response

        self._node.create_service(Trigger, "stop", stop)
        self._node.create_service(Trigger, "~/reset", reset)

    # -- out -----------------------------------------------------------------------------------------------------------

    def _executed(self, event: Event) -> None:
        """An event of the executor, in its own thread."""
        if (work := action_text(event, self._handed_over)) is not None:
            self._actions.publish(self._string(data=work))
        self._asked.happened(event)
        self._tell(event_text(event, self._ros_time(event.time)))

    def _ros_time(self, time: float) -> float:
        """s of the node's clock, of a time on the executor's."""
        return float(self._node.get_clock().now().nanoseconds) * 1e-9 + time - self.executor.clock.now()

    def _hand_over(self, action: Action) -> str:
        """It is an action's turn that other nodes do. They are told of it with its event, since in the executor's
        events it stands before whatever ends it."""
        return "handed over on voice_commands/action"

    def _say(self, event: str, **data: Any) -> None:
        """Something that is neither a text that came in nor an event of the executor."""
        self._tell(status_text(event, self._ros_time(self.executor.clock.now()), **data))

    def _tell(self, text: str) -> None:
        self._status.publish(self._string(data=text))

    # -- inside --------------------------------------------------------------------------------------------------------

    def _make_executor(self, parameters: NodeParameters, clock: RosClock | None) -> Executor:
        robot_file = parameters.robot
        guardian = None
        # A simulated second may take any time; a process that counts real ones would stop too early or too late.
        if clock is None and parameters.guardian:
            guardian = Guardian(
                GUARDIAN_SINK,
                {
                    "topic": self.robot.topic,
                    "stamped": parameters.stamped.value,
                    "frame_id": parameters.frame_id,
                    "node_name": f"{self._node.get_name()}_velocity",
                    "namespace": self._node.get_namespace(),
                },
                limits=robot_file.limits,
                rates=robot_file.rates,
            )
        self._journal = Journal(parameters.journal) if parameters.journal else None
        executor = Executor(
            self.robot,
            clock=clock,
            loop=guardian,
            journal=self._journal,
            on_event=self._executed,
            handle_sigterm=False,
            **robot_file.executor_options(),
        )
        if clock is not None:
            clock.on_reset = executor.stop
        for name in self._handed_over:
            executor.register(name, self._hand_over)
        return executor

    def _warm_up(self) -> None:
        """The automaton is worked out where sentences go for the first time: better now than at the first command."""
        for grammar in self.engine.grammars:
            for intent in grammar.intents.values():
                for example in intent.examples:
                    self.engine.parse(example.text, language=grammar.language)

    def _state(self) -> Collection[str]:
        """Of the robot, as grammars ask for it. That it moves is known here, whatever others say of it."""
        linear, angular = self.executor.loop.written
        return self._told() | ({MOVING} if linear or angular or not self.executor.idle else set())

    def _has_no_time(self) -> bool:
        """Whether what begins would never end."""
        return isinstance(self.executor.clock, RosClock) and not self.executor.clock.runs

    def _told(self) -> frozenset[str]:
        """What others say of the robot. Also asked in the executor's thread."""
        return self._states.held

    def _summary(self, parameters: NodeParameters) -> str:
        kind = "TwistStamped" if self.robot.stamped else "Twist"
        way = self.robot.navigation.way.value if self.robot.navigation is not None else "none"
        if parameters.stamped == "auto":
            kind += ", or what is subscribed to"
        return (
            f"ready: {self._node.resolve_topic_name('voice_commands/text')} -> {self.robot.topic} ({kind}), "
            f"navigation by {way}, at most {parameters.robot.limits.linear_velocity:g} m/s and "
            f"{parameters.robot.limits.angular_velocity:g} rad/s"
        )


def _age(info: Any) -> float:
    """How long ago a message was published, in s.

    A String has no time of its own; the middleware sends the publisher's. Two computers whose clocks differ by more
    than ``expire_after`` therefore do not work together, and the status says why: on the safe side.
    """
    sent = sent_at(info)
    return max((time.time_ns() - sent) * 1e-9, 0.0) if sent > 0 else 0.0


def main(arguments: Sequence[str] | None = None) -> int:
    """What the script ``intent-engine-ros2`` runs."""

    def make(node: Any, end: Callable[[int], None]) -> VoiceCommands:
        return VoiceCommands(node)

    return run_script("intent_engine", make, arguments, __doc__)


if __name__ == "__main__":
    sys.exit(main())
