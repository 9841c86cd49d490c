"""What a transcript means for a robot: nothing, where the sound was not clearly a command.

Text is understood by the engine alone. A transcript also says how well the sentence explains the sound, and a robot
that acts on a guess does what was not said.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

from intent_engine.actions import Move, Turn
from intent_engine.amending import can_be_amended
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import Grammar, Intent
from intent_engine.language.likeness import sound
from intent_engine.language.numbers.english import ALIKE
from intent_engine.language.references import Before
from intent_engine.language.utterance import PhraseSet, plain
from intent_engine.prefix import PrefixStatus
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.hypotheses.corrections import as_meant
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import (
    SURE_ENOUGH,
    SURE_ENOUGH_OF_SEVERAL,
    SURE_ENOUGH_TO_STOP,
    WORTH_ASKING,
    enough_to_stop,
)

__all__ = ["Judge"]

SURE_BESIDE_A_STOP = 0.9
"""The same for a word or two that may have been a stop: of 42 "go" at 10 dB two were less sure."""
FAR_BEHIND = 6.5
"""nats by which a stop may be less likely and still be what was said. Of 58 "stop" in two kitchen noises at 10 and 6 dB
ten were "go" from 0.6 to 0.9; the stop was behind by 5.2 at most. Any single word of a grammar is compared with any
short sound: of "louder" or "start recording" a stop is among the next likeliest, but behind by 8 and more."""
OTHER_WAY = 3.0
"""nats by which the same motion the other way must be less likely than what is done: one in twenty. Of 344 commands,
clean, and 172 at 10 dB, "going forward" for "going rearward" was ahead by 2.6, and what was right by 3.1 and more."""
HARDLY_A_WORD = -1.5
"""Mean log probability of the words heard, below which they tell nothing of what was said: "Oh" and "That" were heard
for "stop" at 10 dB. Most other words that hold the robot are heard better (docs/decisions/speech-held-robot.md)."""

SURE_THOUGH_HELD = 0.95
"""Confidence in another short command, from which it is done though a stop was heard in its sound: at 10 dB and less
"stop" is "go", "let's go" and "just go", of which the models were sure by 0.78 to 0.90; of a true "go" by 0.98."""

HARDLY_A_SENTENCE = 2
"""Words heard, above which more was said than a stop: hardly any stop phrase is longer. At 10 dB a sentence is often
heard as hardly a word, and some of them hold the robot: "Please now take one" was "move backward one meter"."""

CLEARLY = -0.35
"""Mean log probability of the words heard, below which quiet ones beside a pause may be lost: of what is heard in doubt
of orders of coffee four of ten are below it in quiet, and six of ten at 6 dB."""

CORRECTED_CLEARLY = -0.9
"""The same of a correction, which at least stops what is being done: a "no, right" of two words is seldom heard as
clearly as a sentence."""

_HELD = "a stop was heard before the word had ended, and nothing else was heard clearly"


class Judge:
    """Judges what was heard by the grammar of an engine, which may be reloaded at any time.

    Args:
        engine: understands.
        continuing: whether a motion can be put right while it is done. It may be changed at any time.
    """

    def __init__(self, engine: IntentEngine, *, continuing: bool = False) -> None:
        self.engine = engine
        self.continuing = continuing

    def outlook(
        self, transcript: Transcript, state: Collection[str], last: Before
    ) -> tuple[Interpretation | None, Outlook]:
        """What the words so far mean, and whether more can be expected."""
        if not transcript.text:
            return None, Outlook.OTHER
        meaning = self.meaning(transcript, state, last)
        if meaning.status is Status.REJECTED and self.unsure(transcript):
            begun = self.engine.prefix(transcript.free_text, language=self._language(transcript))
            return meaning, Outlook.INCOMPLETE if begun.status is PrefixStatus.INCOMPLETE else Outlook.OTHER
        prefix = self.engine.prefix(transcript.text, language=self._language(transcript), spoken=True)
        if meaning.status is Status.ACCEPTED:
            if meaning.stops:
                return meaning, Outlook.COMPLETE
            amended = self.continuing and can_be_amended(meaning)
            if not prefix.settled or (prefix.resting and not amended):
                waits = [Outlook.AMENDABLE, Outlook.EXTENDABLE, Outlook.DOUBTFUL]
                return meaning, waits[1 - amended + _hardly_heard(transcript)]
            # "Take up", before a "picture", is like "take off", which nothing can follow.
            over = prefix.status is PrefixStatus.COMPLETE and transcript.word_by_word
            return meaning, Outlook.COMPLETE if over or amended else Outlook.SETTLED
        return meaning, Outlook.INCOMPLETE if prefix.status is PrefixStatus.INCOMPLETE else Outlook.OTHER

    def begins_nothing(self, transcript: Transcript) -> bool:
        """Whether no command begins with what was heard so far of words under way, of which the last may be half a
        word."""
        *words, _ = transcript.free_text.split() or [""]
        if not words:
            return False
        begun = self.engine.prefix(" ".join(words), language=self._language(transcript))
        return begun.status is PrefixStatus.IMPOSSIBLE

    def wait(self, transcript: Transcript, meaning: Interpretation | None) -> float | None:
        """s of silence that end it where it could go on: the longest that its intents ask for; None: they do not."""
        if meaning is None or meaning.status is not Status.ACCEPTED:
            return None
        return max((one.wait for one in self._intents(transcript, meaning) if one.wait is not None), default=None)

    def _language(self, transcript: Transcript) -> str | None:
        """The grammar for a transcript: that of the language spoken, where there is one."""
        return transcript.language if transcript.language in self.engine.languages else None

    def _grammar(self, transcript: Transcript) -> Grammar:
        return self.engine.matcher(self._language(transcript)).grammar

    def meaning(self, transcript: Transcript, state: Collection[str], last: Before) -> Interpretation:
        """What a transcript means; nothing, where it is too unlike what was heard."""
        language = self._language(transcript)
        meaning = self.engine.parse(transcript.text, state=state, language=language, spoken=True, last=last)
        if meaning.status is Status.ACCEPTED and not meaning.stops and (why := _unheard(transcript)):
            return Interpretation(transcript.text, Status.REJECTED, reason=why, alternatives=(transcript.text,))
        if meaning.status is Status.ACCEPTED and self.unsure(transcript, meaning):
            near = Interpretation(
                transcript.free_text,
                Status.REJECTED,
                reason=_why_unsure(transcript),
                alternatives=(transcript.text,),
            )
            return near if transcript.sureness >= WORTH_ASKING else self._with_reason(near, transcript, state, last)
        turned = self._other_way(transcript, meaning, state)
        if (other := turned or self._run_together(transcript, meaning, state)) is not None:
            why = f"{transcript.text!r} or {other!r}{', the other way' if turned else ''}? say it again"
            either = (transcript.text, other)
            return Interpretation(transcript.free_text, Status.REJECTED, reason=why, alternatives=either)
        if meaning.status is Status.REJECTED and not meaning.refuses and self.unsure(transcript):
            return self._with_reason(meaning, transcript, state, last)
        return meaning

    def _with_reason(
        self, refused: Interpretation, transcript: Transcript, state: Collection[str], last: Before
    ) -> Interpretation:
        """What is refused, for the reason that the words heard have when they are typed, if they clearly name a place
        that is not on the map: of "go to the moon" the nearest command tells nothing. It stays refused."""
        if transcript.score < CLEARLY:
            return refused
        language = self._language(transcript)
        typed = self.engine.parse(transcript.free_text, state=state, language=language, spoken=True, last=last)
        if not typed.unknown_place:
            return refused
        return Interpretation(
            transcript.free_text, Status.REJECTED, reason=typed.reason, alternatives=typed.alternatives
        )

    def together(self, before: str, transcript: Transcript, state: Collection[str]) -> Interpretation | None:
        """What words that were heard clearly mean after those before, if both are a command word by word. Numbers that
        sound like another are left to the models."""
        clearly = CORRECTED_CLEARLY if self.corrects(transcript) else CLEARLY
        if transcript.score < clearly or ALIKE.keys() & set(plain(transcript.free_text)):
            return None
        meaning = self.text(f"{before}, {transcript.free_text}", transcript, state)
        return meaning if meaning.status is Status.ACCEPTED and meaning.confidence == 1.0 else None

    def text(self, text: str, transcript: Transcript, state: Collection[str]) -> Interpretation:
        """What a text means in the language of a transcript."""
        return self.engine.parse(text, state=state, language=self._language(transcript), spoken=True)

    def stop_going_on(self, stop: str, transcript: Transcript, state: Collection[str]) -> Interpretation | None:
        """A stop with the words after it, if both are one sentence that stops: "stop" and "going forward", but not
        "stop" and "go back"; None: they are not."""
        matcher = self.engine.matcher(self._language(transcript))
        words = [*plain(stop), *plain(transcript.text)]
        for begin in range(len(plain(stop))):
            readings = matcher.read(words[begin:])
            if any(one.intent.action.type == "stop" and not one.problem for one in readings):
                return self.text(f"{stop}, {transcript.text}", transcript, state)
        return None

    def one_sentence(self, before: str, transcript: Transcript, state: Collection[str]) -> Interpretation | None:
        """What the words of a command and those after it mean, if the grammar has both as one sentence: "too loud" and
        "turn it down"; None: it has not."""
        matcher = self.engine.matcher(self._language(transcript))
        readings = matcher.read([*plain(before), *plain(transcript.text)])
        if all(one.problem for one in readings):
            return None
        meaning = self.text(f"{before} {transcript.text}", transcript, state)
        return meaning if meaning.status is Status.ACCEPTED else None

    def comes_after(self, transcript: Transcript) -> bool:
        """Whether it begins with "and then", or the like."""
        sequence = PhraseSet(self._grammar(transcript).operators.sequence)
        return sequence.at(plain(transcript.free_text), 0) > 0

    def comes_later(self, transcript: Transcript) -> bool:
        """Whether it says by itself that something else is done first: "then", "when you get there", not "and"."""
        return self.engine.comes_later(transcript.free_text, language=self._language(transcript))

    def corrects(self, transcript: Transcript) -> bool:
        """Whether it begins with "no", "I mean", or the like, and was heard well enough to be a word."""
        corrections, words = self._corrections(transcript)
        return corrections.at(words, 0) > 0

    def only_corrects(self, transcript: Transcript) -> bool:
        """Whether it is nothing but "no, wait", or the like, and was heard well enough."""
        corrections, words = self._corrections(transcript)
        return bool(words) and corrections.cover(words)

    def ends_in_correction(self, transcript: Transcript) -> bool:
        """Whether it ends with "no", or the like, and was heard well enough."""
        corrections, words = self._corrections(transcript)
        return corrections.ends(words) > 0

    def _corrections(self, transcript: Transcript) -> tuple[PhraseSet, list[str]]:
        """What takes back what was said, and the words that were heard; none, if they were hardly words."""
        grammar = self._grammar(transcript)
        corrections = PhraseSet(grammar.operators.correction)
        heard = plain(transcript.free_text) if transcript.score > HARDLY_A_WORD else []
        return corrections, as_meant(heard, corrections, grammar.sound_alikes)

    def held(self, transcript: Transcript, meaning: Interpretation) -> Interpretation:
        """What a transcript means while a robot is held, since a stop was heard in its sound before that had ended.

        That is a stop, unless something else was heard clearly, or more words than a stop has. To go on would pass over
        a stop; to stand costs a word.

        Args:
            transcript: what was heard.
            meaning: what it means by itself.
        """
        # "Moving of moving" are more words than "moving on" has: of "stop moving" no more was heard.
        found = transcript.text if meaning.status is Status.ACCEPTED else transcript.free_text
        fewest = min(len(text.split()) for text in (transcript.free_text, found))
        if meaning.stops or fewest > HARDLY_A_SENTENCE:
            return meaning
        if meaning.status is Status.ACCEPTED and transcript.confidence is not None:
            clearly = transcript.sureness >= SURE_THOUGH_HELD
        else:
            clearly = transcript.score > HARDLY_A_WORD
        if clearly:
            return meaning
        phrase = next(iter(self._grammar(transcript).operators.stop))
        stop = self.engine.parse(" ".join(phrase), language=self._language(transcript))
        return replace(stop, confidence=SURE_ENOUGH_TO_STOP, reason=_HELD)

    def unsure(self, transcript: Transcript, meaning: Interpretation | None = None) -> bool:
        """Whether the sentence of the grammar that was found is too unlikely to have been said.

        Args:
            transcript: what was heard.
            meaning: what it would mean; None: nothing that is done.
        """
        if transcript.confidence is None:
            return False
        return transcript.confidence < self._enough(meaning, transcript)

    def _enough(self, meaning: Interpretation | None, transcript: Transcript) -> float:
        """Confidence from which a meaning of a transcript is acted on."""
        if meaning is None:
            return SURE_ENOUGH
        several = len(meaning.actions) > 1
        asked = (intent.min_confidence for intent in self._intents(transcript, meaning))
        enough = max((SURE_ENOUGH if one is None else one for one in asked), default=SURE_ENOUGH)
        if meaning.stops:
            return min(enough, enough_to_stop(transcript))
        if several:
            return max(enough, SURE_ENOUGH_OF_SEVERAL)
        return max(enough, SURE_BESIDE_A_STOP) if self._beside_a_stop(transcript) else enough

    def _beside_a_stop(self, transcript: Transcript) -> bool:
        """Whether a word or two may as well have been a stop: of "go", "move" and "stop", the last is the one that must
        never be missed."""
        if len(transcript.free_text.split()) > HARDLY_A_SENTENCE:
            return False
        language = self._language(transcript)
        behind = transcript.behind or itertools.repeat(0.0)
        near = (other for other, nats in zip(transcript.alternatives, behind, strict=False) if nats < FAR_BEHIND)
        return any(self.engine.parse(other, language=language).stops for other in near)

    def _other_way(self, transcript: Transcript, meaning: Interpretation, state: Collection[str]) -> str | None:
        """What may have been said as well and drives or turns the other way; None: nothing."""
        if meaning.status is not Status.ACCEPTED or transcript.word_by_word:
            return None
        language, ways = self._language(transcript), _ways(meaning)
        for other, nats in zip(transcript.alternatives, transcript.behind, strict=False):
            if nats < OTHER_WAY and any(ways):
                others = _ways(self.engine.parse(other, state=state, language=language))
                if others != ways and list(map(abs, others)) == list(map(abs, ways)):
                    return other
        return None

    def _run_together(self, transcript: Transcript, meaning: Interpretation, state: Collection[str]) -> str | None:
        """What may have been said as well, if a joint is the beginning of the word after it: "unload it", of which "and
        load it" is heard, or "turn anticlockwise", of which "turn and clockwise" is; None: nothing that does anything
        else. However sure the models are of an "and", little speaks for one that joins nothing, and less for two
        commands where the same sound is one."""
        words = plain(transcript.text)
        if meaning.status is not Status.ACCEPTED:
            return None
        language = self._language(transcript)
        joints = self._grammar(transcript).operators.sequence
        for place, (joint, begun) in enumerate(pairwise(words)):
            if (joint,) not in joints:
                continue
            for word in self._words_after(words[:place], language):
                if word.endswith(begun) and _sounds_like_begun(joint, word.removesuffix(begun)):
                    other = " ".join((*words[:place], word, *words[place + 2 :]))
                    found = self.engine.parse(other, state=state, language=language)
                    fewer = len(found.actions) < len(meaning.actions)
                    if found.actions and (fewer if place else found.actions != meaning.actions):
                        return other
        return None

    def _words_after(self, words: Sequence[str], language: str | None) -> list[str]:
        """The words of the grammar with which a sentence may go on that begins so."""
        strict = self.engine.matcher(language).strict
        known, reached = strict.walk(words)
        return sorted(strict.next_words(reached)) if reached is not None and known == len(words) else []

    def _intents(self, transcript: Transcript, meaning: Interpretation) -> list[Intent]:
        """What was said, one intent for each kind of command."""
        said = {step["intent"] for step in meaning.slots["steps"]} if meaning.intent == "compound" else {meaning.intent}
        intents = self._grammar(transcript).intents
        return [intent for name, intent in intents.items() if name in said]


def _sounds_like_begun(joint: str, beginning: str) -> bool:
    """Whether a joint sounds like the beginning of a word, up to a last sound that is easily lost: "and", and "un"."""
    shorter, longer = sorted((sound(joint), sound(beginning) if beginning else ""), key=len)
    return len(shorter) > 1 and longer.startswith(shorter)


def _ways(meaning: Interpretation) -> list[int]:
    """Which way each action goes: 1 forward, 2 left, -1 and -2 the other way, 0 for what has none."""
    ways = []
    for action in meaning.actions:
        if isinstance(action, Move):
            ways.append(1 if action.linear_velocity > 0 else -1)
        elif isinstance(action, Turn):
            ways.append(2 if action.angular_velocity > 0 else -2)
        else:
            ways.append(0)
    return ways


def _hardly_heard(transcript: Transcript) -> bool:
    """Whether the words of a command were hardly heard."""
    return not transcript.word_by_word and transcript.score < CLEARLY


def _unheard(transcript: Transcript) -> str:
    """Why words that are a command may not have been said; empty: they may be taken."""
    unclear = dict.fromkeys(transcript.unclear)  # one word may be so for several reasons
    numbers = [f"{word!r} may have been {ALIKE[word]!r}" for word in unclear if word in ALIKE]
    words = [word for word in unclear if word not in ALIKE]
    more = _listed(transcript.left_out)
    told = [
        *numbers,
        *([f"{_listed(words)} {'was' if len(words) == 1 else 'were'} not heard clearly"] if words else []),
        *([f"{more} was said too, and is no part of {transcript.text!r}"] if more else []),
    ]
    return f"{', '.join(told)}; say it again" if told else ""


def _listed(words: Iterable[str]) -> str:
    return " and ".join(map(repr, words))


def _why_unsure(transcript: Transcript) -> str:
    if transcript.sureness >= WORTH_ASKING:
        return f"perhaps {transcript.text!r}, but that was not heard clearly; say it again"
    return "it sounded too different from the nearest command"
