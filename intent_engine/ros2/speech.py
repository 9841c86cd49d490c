"""The node ``speech``: sound in, text out.

Out: ``voice_commands/text`` (std_msgs/String), what was said; ``voice_commands/amended_text`` (std_msgs/String), the
last text and what was said right after it, as one; ``voice_commands/hold`` (std_msgs/Bool), that a stop word may be
being said, or was none; ``voice_commands/stop`` (std_msgs/Empty), that the robot must stand whatever is said, because
hearing failed or ended. In: ``voice_commands/current_state`` (std_msgs/String), the states that the node
``intent_engine`` says the robot is in. All names are relative and can be remapped.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError, IntentEngineError
from intent_engine.execution.events import Event, EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.robot import Capability, Pose, Task
from intent_engine.execution.robots.ros2_support import acknowledge
from intent_engine.grammar_states import meant_in_some_state
from intent_engine.interpretation import Interpretation, Status
from intent_engine.pauses import avoid_pauses
from intent_engine.ros2.latched import HearLatched
from intent_engine.ros2.parameters import Parameters
from intent_engine.ros2.process import EXIT_FAULT, run_script
from intent_engine.ros2.robot_states import in_one_line, state_names
from intent_engine.runtime.amending import in_a_row
from intent_engine.runtime.judgement import Judge

if TYPE_CHECKING:
    from intent_engine.actions import Action
    from intent_engine.execution.handlers import HandlerContext
    from intent_engine.runtime.heard import Heard
    from intent_engine.speech.audio import AudioSource
    from intent_engine.speech.recognizer import Recognizer, Transcript
    from intent_engine.speech.reflex import Reflex

__all__ = ["Speech", "main", "worth_saying"]

TASK = 3.0
"""s that what is not a drive or a turn is taken to last: longer than words are waited for that may put it right."""


def worth_saying(
    engine: IntentEngine,
    found: Interpretation,
    state: Collection[str] = (),
    transcript: Transcript | None = None,
    asked: Interpretation | None = None,
) -> bool:
    """Whether an utterance may be passed on as text.

    What the runtime did not believe, because it sounded too different from its words or because the wake word was
    missing, must not come back as a command: the text alone would be understood, and nobody after this could know.

    Args:
        engine: understands as whoever is given the text.
        found: what the runtime made of it.
        state: states that the robot is in, as far as they are known here.
        transcript: what was heard; None: it was clear.
        asked: what the text before asks back of whoever is given this one; None: nothing.
    """
    if not found.text.strip():
        return False
    if found.status is Status.ACCEPTED:
        return True
    if engine.parse(found.text, state=state, heard=True).status is Status.ACCEPTED:
        return False
    if asked is not None and (answer := engine.answer(asked, found.text, state=state, heard=True)) is not None:
        return answer.text == found.text  # else it was no answer to the runtime, and may be a sentence there
    # Whoever is given it may know of a state that is not known here: that the robot moves, or one of a moment ago.
    if meant_in_some_state(engine, found.text).status is not Status.ACCEPTED:
        return True
    meant = meant_in_some_state(engine, found.text, spoken=True)
    heard = transcript is None or not Judge(engine).unsure(transcript, meant)
    return meant.status is Status.ACCEPTED and heard


class _Elsewhere:
    """Stands for the robot that another node drives, and does nothing itself.

    The runtime carries out on it what was said, so as to know what may still be put right.
    """

    capabilities = frozenset({Capability.MOVE, Capability.TURN})

    def velocity(self, linear: float, angular: float, valid_for: float) -> None: ...

    def stop(self) -> None: ...

    def navigate(self, goal: Pose) -> Task:
        raise NotImplementedError

    def pick(self, object_name: str) -> Task:
        raise NotImplementedError

    def place(self, object_name: str | None, location: str | None) -> Task:
        raise NotImplementedError

    def cancel(self, task: Task) -> None: ...

    def pose(self) -> Pose | None:
        return None

    def close(self) -> None: ...


def _busy(action: Action, context: HandlerContext) -> None:
    """As long as another node may be busy with it."""
    context.cancelled.wait(TASK)


@dataclass(frozen=True, slots=True)
class SpeechParameters:
    """What the node ``speech`` was told."""

    grammar: tuple[Path, ...]
    locations: tuple[Path, ...]
    model: str
    """Of Whisper: a name or a folder; empty: tiny.en for English, base for other languages."""
    second_model: str
    """For what the first is not sure of; empty: base, if it is installed; "none": none."""
    device: str
    """Microphone: its number, name or a part of the name; empty: the system's."""
    file: str
    """A recording that is played instead; empty: none."""
    reflex: bool
    """Hold the robot while a stop word is being said."""
    free: bool
    """Decode without the help of the grammar."""


def read_parameters(node: Any) -> SpeechParameters:
    """Declare the parameters of the node ``speech`` and read them.

    Raises:
        ConfigError: with everything that is wrong.
    """
    declared = Parameters(node)
    grammar, locations = declared.language()
    parameters = SpeechParameters(
        grammar=grammar,
        locations=locations,
        model=declared.text("model", "", "Whisper model: a name or a folder; empty: the usual of the language"),
        second_model=declared.text("second_model", "", "For what the first is unsure of; empty: base, if installed"),
        device=declared.text("device", "", "Microphone: number, name or part of it; empty: the system's"),
        file=declared.text("file", "", "Recording to play instead of the microphone"),
        reflex=declared.truth("reflex", True, "Hold the robot while a stop word is being said"),
        free=declared.truth("free", False, "Decode without the help of the grammar"),
    )
    declared.check()
    return parameters


class Speech:
    """What the node does: a runtime whose robot is somewhere else.

    Life cycle: made with a node -> a thread listens; a recording may end, a microphone that fails ends the process ->
    ``close``.

    Raises:
        ConfigError: a parameter, grammar or map is wrong.
        AudioError, DeviceError, WeightsError: no sound or no model.
    """

    def __init__(self, node: Any, end: Callable[[int], None]) -> None:
        from std_msgs.msg import Bool, Empty, String

        from intent_engine.runtime.runtime import Runtime

        self._node, self._log, self._end = node, node.get_logger(), end
        self._messages = {"hold": Bool, "stop": Empty, "text": String, "amended_text": String}
        self._said: Interpretation | None = None
        """The last command that was passed on, with all that belongs to it."""
        self._asked: Interpretation | None = None
        """What the last text asks back of whoever was given it."""
        self._states: frozenset[str] = frozenset()
        """Of the robot. What is understood here must be what is understood there, or what is not believed here would be
        done there."""
        parameters = read_parameters(node)
        self._engine = IntentEngine.from_files(parameters.grammar, locations=parameters.locations)
        source = self._source(parameters)
        recognizer, reflex = self._ears(parameters)
        self._publishers = {
            name: node.create_publisher(kind, f"voice_commands/{name}", 10) for name, kind in self._messages.items()
        }
        self._executor = Executor(_Elsewhere(), on_event=self._executed, handle_sigterm=False)
        for other in ("navigate", "pick", "place", "custom"):
            self._executor.register(other, _busy)
        self._reflex = reflex
        self._runtime = Runtime(
            self._engine,
            self._executor,
            recognizer,
            reflex=reflex,
            on_event=self._heard,
            state=lambda: self._states,
        )
        HearLatched(node, "voice_commands/current_state", self._robot_is)
        avoid_pauses()
        self._thread = threading.Thread(target=self._listen, args=(source,), name="listening", daemon=True)
        self._thread.start()
        self._log.info(f"ready: {parameters.file or 'microphone'} -> {self._publishers['text'].topic_name}")

    def close(self) -> None:
        """Hear no more; the robot is stopped, as it would not hear a stop."""
        self._runtime.close()
        self._thread.join(2.0)
        self._executor.close()
        if self._reflex is not None:
            self._reflex.close()
        acknowledge(self._publishers["stop"])

    def _listen(self, source: AudioSource) -> None:
        try:
            summary = self._runtime.run(source)
        except Exception as error:
            self._publish("stop")
            self._log.error(f"{error}; the robot is stopped")
            self._end(error.exit_code if isinstance(error, IntentEngineError) else EXIT_FAULT)
        else:
            self._log.info(f"the sound has ended: {summary.utterances} sentences, {summary.accepted} understood")

    def _heard(self, event: Heard) -> None:
        from intent_engine.runtime.heard import HeardKind

        if event.kind is HeardKind.SPEECH:
            # Who takes texts alone, as a parser of somebody's own does, could not put right what was begun too early.
            self._runtime.join_sentences(self._publishers["amended_text"].get_subscription_count() > 0)
        elif event.kind is HeardKind.INTERPRETATION and event.interpretation is not None:
            self._pass_on(event.interpretation, event)
        elif event.kind is HeardKind.ERROR:
            self._log.error(f"{event.detail}; the robot is stopped")

    def _pass_on(self, found: Interpretation, event: Heard) -> None:
        said, states = self._said, self._states
        self._said = found if found.status is Status.ACCEPTED else None
        parse = partial(self._engine.parse, state=states)
        if event.goes_on:
            self._publish("amended_text", data=found.text)
        elif not worth_saying(self._engine, found, states, event.transcript, self._asked):
            self._log.info(f"not passed on: {found.text!r}: {found.reason}")
        elif event.in_turn and said is not None and (both := in_a_row(parse, said, found)) is not None:
            self._said = both
            self._publish("amended_text", data=both.text)
        else:
            self._asked = parse(found.text, heard=True, last=self._asked)
            self._publish("text", data=found.text)

    def _robot_is(self, text: str) -> None:
        """The states of the robot came, in the thread that spins the node."""
        try:
            self._states = state_names(text, "voice_commands/current_state")
        except ConfigError as error:
            self._log.error(in_one_line(error))

    def _executed(self, event: Event) -> None:
        if event.kind in (EventKind.HOLD, EventKind.RELEASE):
            self._publish("hold", data=event.kind is EventKind.HOLD)
        elif event.kind is EventKind.STOP:
            self._publish("stop")

    def _publish(self, name: str, **fields: Any) -> None:
        self._publishers[name].publish(self._messages[name](**fields))

    def _source(self, parameters: SpeechParameters) -> AudioSource:
        if parameters.file:
            from intent_engine.speech.sources.file import FileSource

            return FileSource(parameters.file, realtime=True)
        from intent_engine.speech.sources.microphone import Microphone

        device = parameters.device
        return Microphone(int(device) if device.isdigit() else device or None)

    def _ears(self, parameters: SpeechParameters) -> tuple[Recognizer, Reflex | None]:
        from intent_engine.speech.free import free_recognizer
        from intent_engine.speech.models import recognizer_for
        from intent_engine.speech.reflex import reflex_for

        recognizer: Recognizer
        model = parameters.model or None
        if parameters.free:
            recognizer = free_recognizer(model, language=self._engine.languages[0], tell=self._log.info)
        else:
            second = parameters.second_model or None
            recognizer = recognizer_for(self._engine, model, second=second, tell=self._log.info)
        return recognizer, reflex_for(self._engine, beside=recognizer) if parameters.reflex else None


def main(arguments: Sequence[str] | None = None) -> int:
    """What the script ``intent-engine-ros2-speech`` runs."""
    return run_script("speech", Speech, arguments, __doc__)


if __name__ == "__main__":
    sys.exit(main())
