"""Sentences that a speech model says over and over: what small models make of short sound."""

from __future__ import annotations

from rapidfuzz.distance import Levenshtein

__all__ = ["fold_loop", "goes_round", "stutters"]

LONG_SENTENCE = 4
"""Words of a sentence that nobody says twice in one breath."""
SHORT_SENTENCE = 3
"""Words of a sentence that nobody says three times in one breath."""
MANY_WORDS = 8
"""Words of a sentence that nobody begins again after one that is like it,"""
LIKE = 0.7
"""in this share of its letters, and of which so many are begun once more:"""
HALF_OF_IT = MANY_WORDS // 2
"""or one, if all but the first are the same ("I have a coffee with ... . They have a coffee with ... . They")."""
STUTTER = 4
"""Times that nobody says a word in a row, and"""
STUTTERED = 3
"""several."""


def fold_loop(text: str) -> str:
    """A sentence said over and over, as a speech model does with short input, once.

    These are loops, in which the first sentence is what was said; the last may be cut off:

    - any sentence three times or more;
    - twice, a sentence of four words and more, or one that is seen to be whole ("Right. Right.", "Follow me Follow
      me"). People do say a few words twice, where nothing shows two sentences;
    - a long sentence that begins again;
    - one of three words and more, and then twice the same but for a word ("turn right 120 degrees, turn right 110
      degrees, turn right 110 degrees");
    - one, and then others that are like it and the same as each other ("turn right for 40 5 degrees turn right for 45
      degrees turn right for 45 degrees turn right"); of many words one such and the beginning of another is enough.
    """
    words = text.split()
    plain = [word.strip(".,!?;:\u2026").lower() for word in words]
    for length in range(1, len(words) // 2 + 1):
        unit = plain[:length]
        repeats = _times(unit, plain)
        rest = plain[repeats * length :]
        whole = length >= LONG_SENTENCE or words[length - 1][-1] in ".!?" or _begins_anew(words, length)
        if repeats >= (2 if whole else 3) and _begins(unit, rest):
            return " ".join(words[:length])
        again = plain[length : 2 * length]
        if length >= SHORT_SENTENCE and again == plain[2 * length : 3 * length] and _changed(unit, again) <= 1:
            return " ".join(words[:length])
    end = max(range(len(words) + 1), key=lambda place: _loop_after(plain, place))
    if _loop_after(plain, end):
        return " ".join(words[:end])
    for length in range((len(words) + 1) // 2, len(words) - LONG_SENTENCE):
        if words[length - 1][-1] in ".!?" and _begins(plain[:length], plain[length:]):
            return " ".join(words[:length])
    return text


def _begins_anew(words: list[str], length: int) -> bool:
    """Whether a sentence of several words begins once more with a capital, after other words that have none."""
    return words[length][:1].isupper() and any(word[:1].islower() for word in words[1:length])


def goes_round(text: str) -> bool:
    """Whether a model that wrote this so far is in a loop, so that the rest need not be waited for: a sentence that
    nobody says twice (or three times) has been, and begins once more. Of a word or two nobody can tell ("no no no
    stop")."""
    words = text.split()
    plain = [word.strip(".,!?;:\u2026").lower() for word in words]
    for length in range(SHORT_SENTENCE, len(words) // 2 + 1):
        times = 2 if length >= LONG_SENTENCE else 3
        unit, rest = plain[:length], plain[times * length :]
        if len(rest) >= 2 and plain[: times * length] == unit * times and unit[: len(rest)] == rest:
            return True
    return False


def stutters(text: str) -> bool:
    """Whether a model that wrote this came to a place where it could not go on: "a mocha with milk and sugar with milk
    and sugar with milk and sugar", "a single shot, aint aint aint aint mocha". Words that go round are likely ones,
    whatever was said, so that they tell nothing of how clearly it was heard."""
    plain = [word.strip(".,!?;:\u2026").lower() for word in text.split()]
    return any(
        _times(plain[start : start + length], plain[start:]) >= (STUTTERED if length > 1 else STUTTER)
        for length in range(1, len(plain) // STUTTERED + 1)
        for start in range(len(plain) - STUTTERED * length + 1)
    )


def _loop_after(words: list[str], start: int) -> float:
    """How like a sentence before a place is to others that follow it and are the same, two, or one of many words, and
    the beginning of one more; 0: it is none that is followed by such."""
    before, rest = " ".join(words[:start]), words[start:]
    for length in range(SHORT_SENTENCE, len(rest)):
        unit = rest[:length]
        repeats = 1 if length >= MANY_WORDS else 2
        more = len(rest) - repeats * length
        if more < 1 or not _begins(unit, rest[_times(unit, rest) * length :]):
            continue
        alike = Levenshtein.normalized_similarity(before, " ".join(unit))
        same = unit[1:] == words[start - length + 1 : start]
        begun = 2 if length < MANY_WORDS else 1 if same else HALF_OF_IT
        if alike >= LIKE and more >= begun:
            return alike
    return 0.0


def _times(unit: list[str], words: list[str]) -> int:
    """How often some words begin with others."""
    length, times = len(unit), 0
    while unit and words[times * length : (times + 1) * length] == unit:
        times += 1
    return times


def _changed(unit: list[str], again: list[str]) -> int:
    """Words that differ between two sentences of the same length."""
    return sum(one != other for one, other in zip(unit, again, strict=True))


def _begins(unit: list[str], rest: list[str]) -> bool:
    """Whether the rest is the unit cut off somewhere, perhaps within a word; or begun again and again ("stir. stir.
    stir")."""
    places = [0]  # of the rest, up to which it is made of beginnings of the unit
    for place in places:
        last = rest[place:]
        if not last or (unit[: len(last) - 1] == last[:-1] and unit[len(last) - 1].startswith(last[-1])):
            return True
        begun = next((at for at, (one, other) in enumerate(zip(unit, last, strict=False)) if one != other), len(unit))
        places += (place + length for length in range(1, begun + 1) if place + length not in places)
    return False
