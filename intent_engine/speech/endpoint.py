"""When an utterance is over: from the probability of speech, and from what the grammar says may still follow.

A fixed pause after the words is either too short for some sentences or too long for all. The grammar knows more: a
sentence that nothing can follow is over in the first silence; one that could go on is given a moment.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from enum import StrEnum

from intent_engine.speech.audio import FRAME_SECONDS
from intent_engine.values import check_number

__all__ = ["Endpointer", "Outlook", "Settings", "Signal"]

LONG_FADED = 0.16
"""s of a fading voice, with the silence after it, in which a quiet word may have been said: 2 to 3 frames are usual in
noise (docs/decisions/speech-fading.md)."""

MOST_FRAMES = 30
"""Frames, a second, after which anybody has begun to speak: a robot that waits for more hears no stop."""
MOST_PRE_ROLL = 10.0
"""s of sound that are kept at most from before anybody speaks."""


class Outlook(StrEnum):
    """What the grammar thinks of the words so far."""

    UNKNOWN = "unknown"
    """Not decoded yet."""
    COMPLETE = "complete"
    """A command that nothing can change."""
    SETTLED = "settled"
    """A command of which further words could change the manner only, as "slowly" would; or that nothing can change, but
    which was only like what was heard."""
    AMENDABLE = "amendable"
    """A motion that further words could change, also while it is done."""
    EXTENDABLE = "extendable"
    """A command that further words could change, and that cannot be taken back."""
    DOUBTFUL = "doubtful"
    """The same, hardly heard: in noise a pause seems longer than it is, since the quiet words beside it are lost."""
    INCOMPLETE = "incomplete"
    """The beginning of a command."""
    CALLED = "called"
    """The wake word, and nothing else."""
    OTHER = "other"
    """No command."""


class Signal(StrEnum):
    """What to do after a frame."""

    NONE = "none"
    STARTED = "started"
    """Speech has begun; keep its sound."""
    FADING = "fading"
    """The voice fades: it may be over, though the detector is not sure of that yet. Look at what was said so far."""
    PAUSED = "paused"
    """The first silent frame: decode now what was said so far, to be ready."""
    RESUMED = "resumed"
    """Speech went on: what was decoded is out of date."""
    ENDED = "ended"
    """The utterance is over: act on it."""
    SHORT = "short"
    """It is over, and was so short that it can be nothing but a stop."""
    CUT = "cut"
    """It is over, since it lasted longer than any command: what is said next may be the rest of it."""


@dataclass(frozen=True, slots=True)
class Settings:
    """Waits and thresholds. Times in s."""

    onset: float = 0.5
    """Probability of speech that begins an utterance, as Silero's authors set it."""
    offset: float = 0.35
    """Probability below which a frame is silent."""
    fading: float = 0.6
    """Probability below which speech may be over. The detector lets go of a voice late, in noise by 100 ms; what is
    clear without them need not wait. Nothing ends by it. 0: there is no glance."""
    onset_frames: int = 2
    """Frames of speech that begin an utterance."""
    min_speech: float = 0.12
    """Speech shorter than this may be a knock: nothing but a stop is taken from it. Of 58 "stop" by as many people the
    detector heard one for 64 ms."""
    wait_complete: float = 0.064
    wait_settled: float = 0.128
    wait_amendable: float = 0.2
    wait_extendable: float = 0.35
    wait_doubtful: float = 0.45
    wait_incomplete: float = 0.7
    wait_called: float = 0.7
    """After the wake word alone."""
    wait_other: float = 0.5
    wait_unknown: float = 0.5
    wait_continued: float = 1.5
    """After the last words of a motion, within which words begin that may belong to it ("ninety degrees"); 0: none do,
    and motions wait as long as other commands."""
    wake_lasts: float = 3.0
    """After the wake word alone, within which a command may begin that is for the robot; 0: none may."""
    question_lasts: float = 10.0
    """After words that were not clear ("go to bay": bay 3 or 13?), within which an answer may begin; 0: none may."""
    pre_roll: float = 0.5
    """Sound kept from before the onset: the detector hears a word 48-80 ms after it begins."""
    max_speech: float = 20.0
    """An utterance longer than any command is ended; what follows at once is not acted on, unless it is a stop."""

    def __post_init__(self) -> None:
        for one in fields(self):
            value = getattr(self, one.name)
            if one.name in ("onset", "offset", "fading"):
                check_number(one.name, value, "probability")
                if value > 1:
                    raise ValueError(f"{one.name} is a probability, at most 1, not {value}")
            else:
                check_number(one.name, value, "frames" if one.name == "onset_frames" else "s")
        if self.onset_frames < 1 or self.onset_frames != int(min(self.onset_frames, MOST_FRAMES)):
            raise ValueError(f"onset_frames is a whole number from 1 to {MOST_FRAMES}, not {self.onset_frames}")
        if self.pre_roll > MOST_PRE_ROLL:
            raise ValueError(f"pre_roll is at most {MOST_PRE_ROLL:g} s, not {self.pre_roll}")

    def wait(self, outlook: Outlook, asked: float | None = None) -> float:
        """Silence after which an utterance with this outlook is over.

        Args:
            outlook: what the grammar thinks of it.
            asked: s that its intent waits where it could go on; None: it says nothing. Hardly heard it waits as much
                longer as any other.
        """
        if asked is not None and outlook in (Outlook.AMENDABLE, Outlook.EXTENDABLE):
            return asked
        if asked is not None and outlook is Outlook.DOUBTFUL:
            return asked + self.wait_doubtful - self.wait_extendable
        return {
            Outlook.COMPLETE: self.wait_complete,
            Outlook.SETTLED: self.wait_settled,
            Outlook.AMENDABLE: self.wait_amendable,
            Outlook.EXTENDABLE: self.wait_extendable,
            Outlook.DOUBTFUL: self.wait_doubtful,
            Outlook.INCOMPLETE: self.wait_incomplete,
            Outlook.CALLED: self.wait_called,
            Outlook.OTHER: self.wait_other,
            Outlook.UNKNOWN: self.wait_unknown,
        }[outlook]


class Endpointer:
    """Frames in, signals out; holds no sound and knows no clock but the frames' own length."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = settings or Settings()
        self.reset()

    def reset(self) -> None:
        """Wait for the next utterance."""
        self._voiced = 0
        self._speaking = False
        self._spoken = 0.0
        self._silent = 0.0
        self._faded = 0.0
        """s since the voice began to fade, the silence after it included."""
        self._low = False
        """Whether the last frame could not begin another utterance."""
        self._whole = 0.0
        self.judge(Outlook.UNKNOWN)

    @property
    def speaking(self) -> bool:
        """Whether an utterance has begun and not ended."""
        return self._speaking

    @property
    def silence(self) -> float:
        """s of silence at the end of the utterance so far."""
        return self._silent

    @property
    def short(self) -> bool:
        """Whether so little of the utterance so far is speech that it can be nothing but a stop."""
        return self._spoken < self.settings.min_speech

    @property
    def faded_long(self) -> bool:
        """Whether the voice has been fading for so long that a quiet word may have been said since."""
        return self._faded > LONG_FADED

    def judge(self, outlook: Outlook, asked: float | None = None) -> None:
        """What the grammar thinks of the words that were decoded at the last pause, and how long their intent waits."""
        self._outlook = outlook
        self._asked = asked

    def frame(self, probability: float) -> Signal:
        """Take one frame's probability of speech.

        Raises:
            ValueError: it is none. Whoever took it for silence would hear nobody say stop.
        """
        try:
            given = 0 <= probability <= 1
        except TypeError:
            given = False
        if not given:
            raise ValueError(f"a voice detector gives each frame a probability from 0 to 1, not {probability!r}")
        settings = self.settings
        if not self._speaking:
            self._voiced = self._voiced + 1 if probability >= settings.onset else 0
            if self._voiced < settings.onset_frames:
                return Signal.NONE
            self._speaking = True
            self._spoken = self._whole = self._voiced * FRAME_SECONDS
            self._silent = self._faded = 0.0
            self.judge(Outlook.UNKNOWN)
            return Signal.STARTED
        self._low = probability < settings.onset
        self._whole += FRAME_SECONDS
        if self._whole >= settings.max_speech:
            self.reset()
            return Signal.CUT
        if probability >= (settings.onset if self._silent else settings.offset):
            return self._voice(probability)
        first = self._silent == 0
        self._silent += FRAME_SECONDS
        self._faded += FRAME_SECONDS
        return Signal.PAUSED if first else self.due()

    def due(self) -> Signal:
        """Whether the utterance is over by what is known now: it may have been judged since the last frame."""
        # What nothing can change need not be waited for until the detector is sure that the voice is gone.
        quiet = self._faded if self._outlook is Outlook.COMPLETE and self._low else self._silent
        # Half a frame of tolerance: sums of 32 ms are not exact in floating point.
        if not quiet or quiet + FRAME_SECONDS / 2 < self.settings.wait(self._outlook, self._asked):
            return Signal.NONE
        short = self.short
        self.reset()
        return Signal.SHORT if short else Signal.ENDED

    def _voice(self, probability: float) -> Signal:
        """Take a frame of speech."""
        self._spoken += FRAME_SECONDS
        fading = not self._silent and probability < self.settings.fading
        if fading:
            self._faded += FRAME_SECONDS
            return Signal.FADING if self._faded == FRAME_SECONDS else self.due()
        resumed = self._faded > 0
        self._silent = self._faded = 0.0
        if resumed:
            self.judge(Outlook.UNKNOWN)
            return Signal.RESUMED
        return Signal.NONE
