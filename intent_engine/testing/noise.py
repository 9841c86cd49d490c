"""What people and recognisers do to a sentence, with what it means then.

Each function takes the words of a sample apart and puts them together otherwise; none asks the parser.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum

from intent_engine.actions import Stop
from intent_engine.language.context.done_again import said_by_itself
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, Grammar, Slot
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.numbers.spelled import in_digits, in_words
from intent_engine.language.sampler import Choices, Piece, Sample, Sampler
from intent_engine.language.sampling.spoken_quantities import spoken_forms
from intent_engine.language.templates.spellings import own_words, spellings
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.verb_forms import told_forms_of

__all__ = ["Noise", "corrected", "misheard", "negated", "spelled", "with_fillers"]


class Noise(StrEnum):
    """Kinds of noise for :func:`~intent_engine.testing.sentences`."""

    FILLERS = "fillers"
    """Up to three of the grammar's fillers between the parts of a sentence. The meaning stays."""
    SPELLING = "spelling"
    """What recognisers write: capitals, punctuation, hyphens, digits for words, the grammar's sound-alikes. The
    meaning stays."""
    NEGATION = "negation"
    """A word that negates, before or in the sentence. Nothing may move."""
    CORRECTION = "correction"
    """A value said again, or a command of another intent, after "no" or "I mean". The last word counts."""


CONTRACTED = {("do", "not"): "don't", ("should", "not"): "shouldn't", ("can", "not"): "can't"}
MOST_FILLERS = 3
_VALUES = frozenset((*QUANTITY_KINDS, "choice", "boolean", "location"))
"""Slots whose value can be corrected by saying it alone; for words of free text nobody knows what they replace."""
MOST_SPELLINGS = 50
"""Ways to say one value of a slot that are looked at."""


def with_fillers(pieces: Sequence[Piece], grammar: Grammar, choices: Choices) -> list[Piece]:
    """The pieces with fillers between them, never inside a number or what was said for a slot.

    A sentence with a filler of its own ("wait for me") gets only such as no sentence needs.
    """
    said = list(pieces)
    operators = grammar.operators
    special = (
        PhraseSet(grammar.fillers),
        PhraseSet((*operators.negation, *operators.correction, *operators.cancel, *operators.stop)),
    )
    own = own_words(grammar) if special[0].find(_words(said)) is not None else frozenset()
    everywhere = (filler for filler in grammar.fillers if filler not in grammar.wording.fillers_apart)
    usable = [filler for filler in everywhere if not own.issuperset(filler)]
    choosing = (node for slot in grammar.slots.values() for _, node in slot.values)
    alone = {
        words[0] for node in choosing for words in spellings(node, grammar.phrases, MOST_SPELLINGS) if len(words) == 1
    }
    places = len(said) - 1 if _dictated(said) else len(said) + 1
    for _ in range(choices.below(MOST_FILLERS + 1) if usable and places > 0 else 0):
        filler = usable[choices.below(len(usable))]
        # "right then, turn left": elsewhere, and without the pause, it joins two commands. And whether "turn right away
        # ninety degrees" is to the right nobody knows.
        opens = any((word,) in operators.sequence or (len(filler) > 1 and word in alone) for word in filler)
        # In the midst a greeting begins a name: "play hey jude".
        place = 0 if opens or filler in grammar.wording.greetings else choices.below(places)
        while 0 < place < len(said) and _belong_together(said[place - 1], said[place], grammar):
            place += 1
        if _dictated(said) and place > len(said) - 2:
            continue  # "print a", "label" + what is dictated
        if 0 < place < len(said) and _is_any_name(said[place]):
            continue  # "play" + "could you" + a name, which may begin so
        if 0 < place < len(said) and _describes(filler, said[place - 1], said[place], grammar):
            continue  # "find the" + "good" + a thing, which may be called so
        longer = [*said[:place], Piece(" ".join(filler) + "," * opens), *said[place:]]
        if all(_found(one, _words(longer)) == _found(one, _words(said)) + _found(one, filler) for one in special):
            said = longer  # else it makes something else with the words beside it: "forget" + "about" + "it"
            places += 1
    return said


def _dictated(pieces: Sequence[Piece]) -> bool:
    """Whether the last of the pieces is a dictated text: all that is said right before it, in it and after it belongs
    to it."""
    return bool(pieces) and pieces[-1].slot is not None and pieces[-1].slot.dictation


def _is_any_name(piece: Piece) -> bool:
    """Whether a piece was said for a slot that takes any words for a name."""
    return piece.slot is not None and piece.slot.type in FREE_KINDS and not piece.slot.known


def _describes(filler: Sequence[str], before: Piece, piece: Piece, grammar: Grammar) -> bool:
    """Whether a filler would be a part of the name that a piece was said for: it stands behind its article."""
    known = thing_words(grammar.language)
    named = piece.slot is not None and piece.slot.type in FREE_KINDS
    return named and known.describing.issuperset(filler) and before.text.split()[-1] in known.articles


def _words(pieces: Sequence[Piece]) -> list[str]:
    return [word.rstrip(",") for piece in pieces for word in piece.text.split()]


def _found(phrases: PhraseSet, words: Sequence[str]) -> Counter[tuple[str, ...]]:
    return Counter(
        tuple(words[position : position + length])
        for position in range(len(words))
        for length in phrases.lengths_at(words, position)
    )


def _belong_together(piece: Piece, after: Piece, grammar: Grammar) -> bool:
    """Whether nothing can be said between two pieces: "one" and "eighty", "never" and "mind", "u" and "turn"."""
    closed = grammar.operators.closed
    letter = len(piece.text) == 1 and piece.text.isalpha()
    numbers = _is_number(piece.text.split()[-1]) and _is_number(after.text.split()[0])
    return letter or numbers or piece.text in closed or after.text in closed


def _is_number(word: str) -> bool:
    return word[0].isdigit() or word in NUMBER_WORDS


def negated(pieces: Sequence[Piece], grammar: Grammar, choices: Choices) -> list[Piece]:
    """The pieces with a negation among them; most often at the beginning."""
    ways = [*grammar.wording.negated, *grammar.operators.negation]
    words = ways[choices.below(len(ways))]
    text = " ".join(words)
    for plain, short in CONTRACTED.items():
        text = text.replace(" ".join(plain), short)
    # "Come rather than back" leaves "come", which may be done.
    first = choices.below(2) == 0 or _dictated(pieces) or words in grammar.wording.excludes
    place = 0 if first else choices.below(len(pieces))
    return [*pieces[:place], Piece(text), *pieces[place:]]


def corrected(first: Sample, sampler: Sampler, choices: Choices) -> tuple[list[Piece], Sample] | None:
    """A sentence that is corrected as it is said, and what it means in the end; None where nobody could tell.

    Either its last value is said again ("turn left, no, right") or a command of another kind follows.
    """
    grammar = sampler.grammar
    operators = grammar.operators
    # "izquierda, no, derecha": in Spanish that may as well negate.
    clear = [words for words in operators.correction if not all((word,) in operators.negation for word in words)]
    if not clear or _holds_operator(first, grammar) or _dictated(first.pieces):
        return None
    again = Piece(" ".join(clear[choices.below(len(clear))]))
    last = first.pieces[-1]
    slots = [piece.slot for piece in first.pieces if piece.slot is not None]
    alike = [slot for slot in slots if last.slot is not None and _kind(slot) == _kind(last.slot)]
    if last.slot is not None and last.slot.type in _VALUES and len(alike) == 1:
        assert last.label is not None
        if choices.below(2) == 0:
            if _may_deny(again, first.pieces[:-1], grammar):
                return None  # "with milk no cream": cream in its place, or none?
            piece = sampler.spoken(last.slot, last.label, choices)
            if _is_bare_number(piece, grammar.language):
                return None  # "a meter and a half, no, two": and a half?
            if last.slot.digits and len(piece.text.split()) < len(last.text.split()):
                return None  # "one eight zero, no, five" may correct the last digit
            meant = sampler.finish(first.intent, first.sentence, [*first.pieces[:-1], piece])
            return None if meant is None else ([*first.pieces, again, piece], meant)
    other = sampler.attempt(choices)
    free = any(slot.type in FREE_KINDS for slot in slots)
    if other is None or other.intent == first.intent or len(other.pieces) < 2 or free:
        return None  # what follows could be a new value of the first, or free text
    if _holds_operator(other, grammar) or said_by_itself(other.actions[0]):
        return None
    return [*first.pieces, again, *other.pieces], other


def _may_deny(again: Piece, before: Sequence[Piece], grammar: Grammar) -> bool:
    """Whether what follows a correction may be what something is to be without: behind "with", and the word for it."""
    known = thing_words(grammar.language)
    words = itertools.dropwhile(known.articles.__contains__, reversed(_words(before)))
    return again.text in grammar.wording.none_of and next(words, None) in known.having


def _kind(slot: Slot) -> str:
    """What a value must be to stand in a slot: "from bay one to bay two, no, three" could be either."""
    return slot.name if slot.type == "choice" else slot.type


def _holds_operator(sample: Sample, grammar: Grammar) -> bool:
    """Whether a sentence has words of its own that correct, take back, stop or mean nothing ("wait for me")."""
    words = tuple(sample.text.split())
    if words in grammar.operators.cancel or PhraseSet(grammar.fillers).find(words) is not None:
        return True  # "drop it"; "turn about", where "about" is a filler as well
    return not grammar.operators.closed.isdisjoint(words) or isinstance(sample.actions[0], Stop)


def _is_bare_number(piece: Piece, language: str) -> bool:
    """Whether it may take the unit over that was said before: "two crates, no, three"."""
    if piece.slot is None or (piece.slot.unit is None and not piece.slot.units):
        return False
    numbers = spoken_forms("number", language, None, None, None)
    return any(piece.text == spoken.text for form in numbers for spoken in form)


def misheard(pieces: Sequence[Piece], grammar: Grammar, choices: Choices) -> Sequence[Piece]:
    """One word in place of which recognisers write another, where nothing else could be meant by it.

    Not in a sentence with free text, which any word could be part of; not beside an operator's word, where the engine
    takes no guess; and nothing that is a number, or tells what somebody did where it was typed ("turned left").
    """
    words = [piece.text.split() for piece in pieces]
    plain = all(piece.slot is None or piece.slot.type not in FREE_KINDS for piece in pieces)
    own = PhraseSet(grammar.fillers).find(_words(pieces)) is not None  # "turn about", where "about" is a filler too
    if own or not plain or any(not grammar.operators.closed.isdisjoint(said) for said in words):
        return pieces
    if choices.below(3) != 2:
        return pieces
    found = [
        (place, number, heard)
        for place, piece in enumerate(pieces)
        if piece.slot is None
        for number, word in enumerate(words[place])
        for heard, meant in grammar.sound_alikes.items()
        if meant == (word,) and heard not in NUMBER_WORDS and word not in told_forms_of(heard, grammar.language)
    ]
    if not found:
        return pieces
    place, number, heard = found[choices.below(len(found))]
    words[place][number] = heard
    return [*pieces[:place], replace(pieces[place], text=" ".join(words[place])), *pieces[place + 1 :]]


def spelled(pieces: Sequence[Piece], choices: Choices, *, whole: bool = True) -> str:
    """The pieces as a recogniser might write them.

    Args:
        pieces: of the sentence.
        choices: see :class:`~intent_engine.language.sampler.Choices`.
        whole: whether the pieces are one plain command, so that a pause among them means nothing.
    """
    texts = [_written(piece, choices).text for piece in pieces]
    if _dictated(pieces):  # kept as it is written
        begin = " ".join(texts[:-1])
        return (begin, begin.title(), f"{begin},")[choices.below(3)] + f" {texts[-1]}" + ("", ".")[choices.below(2)]
    if whole and len(texts) > 1 and choices.below(4) == 3:
        place = choices.below(len(texts) - 1)
        texts[place] += ","
    text = " ".join(texts)
    written = (text, text[:1].upper() + text[1:], text.upper(), text.title())[choices.below(4)]
    if written.lower() == text.lower():  # not so with "ß", of which capitals make "SS"
        text = written
    return text + ("", ".", "!", "...", " .")[choices.below(5)]


def _written(piece: Piece, choices: Choices) -> Piece:
    """A value with digits for its number words, or words for its digits, or with a hyphen."""
    kind = piece.slot.type if piece.slot is not None else None
    if kind == "location":  # "bay 3" or "bay three"
        words = piece.text.split()
        return replace(piece, text=" ".join((words, in_words(words), in_digits(words))[choices.below(3)]))
    if kind not in QUANTITY_KINDS or kind == "ordinal":
        return piece
    words = piece.text.split()
    style = choices.below(3)
    if style == 1 and NUMBER_WORDS.intersection(words) and "point" not in words:
        return replace(piece, text=" ".join(in_digits(words)))
    if style == 2 and len(words) > 1 and words[0].isalpha() and words[1].isalpha():
        return replace(piece, text="-".join(words[:2]) + "".join(f" {word}" for word in words[2:]))
    return piece
