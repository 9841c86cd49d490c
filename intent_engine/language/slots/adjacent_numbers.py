"""Two quantities one after the other: where one ends is in nothing but the words of their numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

from intent_engine.language import quantities
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.numbers.digit_by_digit import digit_of, said_together
from intent_engine.language.numbers.english_words import HALVES, NUMBER_WORDS
from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading, SlotReading

__all__ = [
    "amounts_apart",
    "cuts_digits",
    "is_number",
    "leaves_one_of_two",
    "may_hold",
    "number_said_apart",
    "numbers_apart",
    "parted_at_joint",
    "row_in_pieces",
]

_COUNTED = frozenset(QUANTITY_KINDS)
LEAST_OF_A_ROW = 3
"""Digits, each behind a pause, that are surely one number: "1, 2" may be two."""


def numbers_apart(slots: Sequence[SlotReading], words: Sequence[str], language: str) -> list[SlotReading]:
    """Slots of one sentence, of which none holds a part of a number: "right seventy five dps" is no angle of seventy
    and a speed of five, and "four meters and half a meter per second" are no four and a half meters at one meter per
    second. What could be one number or two has no value.

    Args:
        slots: as they were read, in order.
        words: of the sentence.
        language: of the words.
    """
    found = list(slots)
    for place, (slot, after) in enumerate(pairwise(slots)):
        if slot.end != after.start or slot.problem or not {slot.slot.type, after.slot.type} <= _COUNTED:
            continue
        if _is_cut(words[slot.end - 1], words[after.start], language) and not _surely_two(slot, after, words, language):
            problem = f"{' '.join(words[slot.start : after.end])!r} could be one number or two"
            found[place] = replace(slot, value=None, status="unknown", problem=problem)
    return found


def parted_at_joint(
    slots: Sequence[SlotReading], words: Sequence[str], read: Callable[[SlotReading, int, int], SlotReading]
) -> list[SlotReading]:
    """Slots of one sentence, with the word between two quantities where it belongs, if a number may hold that word too:
    "between 0.5 and one and a half". What can be parted in several places has no value: "between 100 and two and a
    half" may be 100 and 2.5, or 102 and a half.

    Args:
        slots: as they were read, in order.
        words: of the sentence.
        read: a slot again, with the words from one place to another.
    """
    found = list(slots)
    for place in range(len(found) - 1):
        slot, after = found[place : place + 2]
        if after.start - slot.end != 1 or not {slot.slot.type, after.slot.type} <= _COUNTED:
            continue
        start, end, joint = slot.start, after.end, words[slot.end]
        if words[start:end].count(joint) < 2:
            continue
        cuts = (cut for cut in range(start + 1, end - 1) if words[cut] == joint)
        ways = [(read(slot, start, cut), read(after, cut + 1, end)) for cut in cuts]
        ways = [(one, other) for one, other in ways if not (one.problem or other.problem)]
        if len(ways) == 1:
            found[place : place + 2] = ways[0]
        elif ways:
            problem = f"where the first number ends in {' '.join(words[start:end])!r} is not clear"
            found[place] = replace(slot, value=None, status="unknown", problem=problem)
    return found


def amounts_apart(
    slots: Sequence[SlotReading],
    words: Sequence[str],
    read: Callable[[SlotReading, int, int], SlotReading],
    language: str,
) -> list[SlotReading]:
    """Slots of one sentence, of which none holds an amount that may as well be a part of the next one of its kind: "one
    hour ten minutes five seconds" may be an hour, and ten minutes and five seconds. The arguments are those of
    :func:`parted_at_joint` and of :func:`numbers_apart`."""
    found = list(slots)
    table = units(language)
    joints = table.words["and"] if table is not None else frozenset[str]()
    for place, (slot, after) in enumerate(pairwise(slots)):
        alike = slot.slot.type == after.slot.type and slot.slot.type in _COUNTED
        bare = slot.slot.type == "number" and not (slot.slot.units and after.slot.units)
        if slot.end != after.start or not alike or bare or slot.problem or after.problem:
            continue
        cuts = range(slot.start + 1, after.end)
        others = [(cut, cut) for cut in cuts if cut != slot.end]
        others += [(cut, cut + 1) for cut in cuts[:-1] if words[cut] in joints]
        if any(not (read(slot, slot.start, end).problem or read(after, at, after.end).problem) for end, at in others):
            problem = f"where the first amount ends in {' '.join(words[slot.start : after.end])!r} is not clear"
            found[place] = replace(slot, value=None, status="unknown", problem=problem)
    return found


def number_said_apart(reading: Reading, breaks: Sequence[bool | None], language: str) -> Sequence[str]:
    """The number without a unit that ends a quantity, behind its unit and a pause or a filler: "two meters, three" may
    be 2.03 m, or three, and so may "two meters, maybe three". Or one said digit by digit, in pieces: "14, 15". Empty:
    there is none.

    Args:
        reading: of the words.
        breaks: what stands before each of them, as in an utterance.
        language: of the words.
    """
    words = reading.words
    for slot in reading.slots:
        if slot.slot.type in QUANTITY_KINDS:
            if slot.slot.digits and True in breaks and row_in_pieces(slot, words, breaks, language):
                return words[slot.start : slot.end]
            for place in range(slot.start + 1, slot.end):
                if breaks[place] is False or is_number(words[place - 1], language):  # "one thousand, five hundred"
                    continue
                if _is_bare_number(words[place : slot.end], language):
                    return words[place : slot.end]
    return ()


def row_in_pieces(slot: SlotReading, words: Sequence[str], pauses: Sequence[bool | None], language: str) -> bool:
    """Whether what was said digit by digit for a slot may be several numbers, for the pauses in it: "14, 15", "1, 2".

    It is one where a pause stands between all of three digits or more ("1, 8, 0"), where the first piece could be none
    of that slot ("20, 19", of years), and where the words are a number in any slot: "two thousand, nineteen".

    Args:
        slot: as it was read.
        words: of the sentence.
        pauses: where it is true, a pause stands before that word, or a dash.
        language: of the words.
    """
    end = slot.start
    while end < slot.end and is_number(words[end], language):
        end += 1
    row = words[slot.start : end]
    apart = [at for at in range(1, len(row)) if pauses[slot.start + at]]
    if not apart or quantities.evaluate(row, "number", language) is not None:
        return False
    if len(row) > LEAST_OF_A_ROW - 1 and len(apart) == len(row) - 1:
        return not all(digit_of(word, language) for word in row)
    return may_hold(slot, row[: apart[0]], language)


def _leaves_a_row(old: Reading, new: Reading, language: str) -> bool:
    """Whether fewer digits are said again than were said one by one: four may be four, or 124."""
    before = {slot.label: slot for slot in old.slots}
    for slot in new.slots:
        was = before.get(slot.label)
        if was is None or not slot.slot.digits or was.value == slot.value:
            continue
        said, meant = (_digits(one.words[at.start : at.end], language) for one, at in ((old, was), (new, slot)))
        if 0 < meant < said:
            return True
    return False


def _digits(words: Sequence[str], language: str) -> int:
    """How many digits are said one by one, by a number that begins so; 0: none are."""
    return next((at for at, word in enumerate(words) if not digit_of(word, language)), len(words))


def cuts_digits(said: Sequence[str], reading: Reading, language: str) -> bool:
    """Whether a digit was taken for another word that sounds like it, before others that are said one by one: "steer
    two seven zero" is no "steer to seven zero".

    Args:
        said: the words.
        reading: what they were taken for.
        language: of the words.
    """
    for slot in reading.slots:
        before, digits = slot.start - 1, reading.words[slot.start : slot.start + 2]
        if not slot.slot.digits or before < 0 or said[before] == reading.words[before]:
            continue
        if digit_of(said[before], language) and len(digits) > 1 and all(digit_of(word, language) for word in digits):
            return True
    return False


def leaves_one_of_two(
    said: list[str],
    corrected: list[str],
    meant: Sequence[str],
    read: Callable[[list[str]], Sequence[Reading]],
    language: str,
) -> bool:
    """Whether a correction says one again of two numbers that belong together, and it is not clear which, or whether
    the other one stays: "seven thirty, no, eight" may be eight, half past eight or eight past seven. So may some of the
    digits that were said one by one: "one two three, no, four".

    Args:
        said: the words.
        corrected: the same, corrected.
        meant: the words of the correction.
        read: all ways to understand words, the best first.
        language: of the words.
    """
    old, new = (next(iter(read(words)), None) for words in (said, corrected))
    if old is None or new is None:
        return False
    if _leaves_a_row(old, new, language):
        return True
    before = {slot.label: slot.value for slot in old.slots}
    for one, other in pairwise(new.slots):
        between = new.words[one.end : other.start]
        together = one.slot.type == other.slot.type == "number" and len(between) < 2
        if not together or not {one.label, other.label} <= before.keys():
            continue
        if f" {' '.join(new.words[one.start : other.end])} " in f" {' '.join(meant)} ":
            continue  # both are said again
        first, second = (before[slot.label] != slot.value for slot in (one, other))
        kept = not between or meant[-1] == between[0]  # "seven o'clock thirty, no, eight o'clock"
        if not second and kept and (first or old.values() == new.values()):
            return True
        bare = not between or len(meant) == other.end - other.start
        if second and not first and bare and one.slot.beyond(other.value or 0.0) is None:
            # "Seven two times, no, three times": what follows a number is the second one's, unless it may be either's.
            rest = new.words[other.end :]
            told = not between and rest and tuple(meant[-len(rest) :]) == rest and len(meant) > len(rest)
            if not told or any(not way.problem for way in read([*new.words[: one.start], *meant])):
                return True
    return False


def is_number(word: str, language: str) -> bool:
    """Whether a word is a numeral or a word of a number."""
    return quantities.is_numeral(word) or (
        word in NUMBER_WORDS if language == "en" else quantities.is_number_word(word, language)
    )


def _is_bare_number(words: Sequence[str], language: str) -> bool:
    """Whether words are a number, or words of one, without a unit: "three", "two and a half"."""
    return all(is_number(word, language) for word in words) or (
        is_number(words[0], language) and quantities.evaluate(words, "number", language) is not None
    )


def _is_cut(last: str, first: str, language: str) -> bool:
    """Whether the last word of one quantity and the first of the next could be of one number."""
    part_of = language == "en" and last in HALVES and first in ("a", "an")
    return part_of or (is_number(last, language) and is_number(first, language))


def _surely_two(slot: SlotReading, after: SlotReading, words: Sequence[str], language: str) -> bool:
    """Whether the number words around the end of a quantity are two numbers, and can only be cut there: "ten fifteen"
    is none, and "six thirty" is more than an hour can be; but 100 and 200 may be 102 and 100. Nor is "twenty five" ever
    twenty and five, however little the slot takes."""
    start, end = slot.end - 1, after.start + 1
    while start > slot.start and is_number(words[start - 1], language):
        start -= 1
    if words[slot.end - 1] in HALVES or _are_one(words[start : slot.end], words[after.start], language):
        return False
    while end < after.end and is_number(words[end], language):
        end += 1
    if may_hold(slot, words[start:end], language):
        return False
    cuts = (
        cut
        for cut in range(start + 1, end)
        if may_hold(slot, words[start:cut], language) and may_hold(after, words[cut:end], language)
    )
    return list(cuts) == [slot.end]


def _are_one(said: Sequence[str], next_: str, language: str) -> bool:
    """Whether a number counts the next one, as in "one hundred" and "quatre vingt", or goes on to it, as in "twenty
    five" and "one hundred five": said in words, they are one."""
    if any(map(quantities.is_numeral, (*said[-1:], next_))):
        return False
    values = (quantities.evaluate(words, "number", language) for words in (said, said[-1:], [next_], [*said, next_]))
    whole, last, other, both = (value if isinstance(value, float) else None for value in values)
    if whole is None or other is None or both is None:
        return False
    counts = last is not None and last >= 1 and other > 1 and both == whole - last + last * other
    return counts or (whole > other >= 1 and both == whole + other)


def may_hold(slot: SlotReading, words: Sequence[str], language: str) -> bool:
    """Whether words are one number, of which a slot that has no unit can be as much."""
    said = said_together(words, language) if slot.slot.digits else words
    value = quantities.evaluate(said, "number", language)
    return isinstance(value, float) and (slot.slot.type != "number" or slot.slot.beyond(value) is None)
