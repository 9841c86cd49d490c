"""Words that were heard and that a sentence leaves out, and words of a sentence that nobody heard.

A sentence is taken for what was said by how likely it is as a whole, and a word more or less weighs little there. Where
it begins, and where it ends, such a word makes another meaning of it: "do you go", "go ... at six miles per hour".
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

from rapidfuzz.distance import Levenshtein

from intent_engine.language.thing_words import ARTICLES
from intent_engine.speech.evidence import letters_apart

__all__ = ["begin_left_out", "begins_like", "end_left_out", "ends_unheard", "goes_on"]

UNHEARD_LETTERS = 6
"""Letters of the last words of a sentence, from which it is asked whether they were heard: a "milk" may be missed;"""
LEFT_OUT_LETTERS = 4
"""and of the last words that were heard, from which they are not left out."""
BEYOND = 0.75
"""The share of the letters of such words by which the rest is nearer to the other. By words that nobody heard none of
333 commands is lost that were right in doubt, and one wrong one is not done; by words left out one of 516, and two of
29 wrong ones."""
ALIKE_LETTERS = 8
"""Letters of last words that all models heard alike, from which they are not left out either,"""
BEYOND_ALIKE = 0.35
"""where the rest is nearer by this share of them: "said the nurse" is a little like "three"."""
ENDINGS = ("s", "es", "ed", "ing")
"""Of the forms in which the first word of a command is told by somebody of something."""
BEGIN_LETTERS = 2
"""Letters by which what stands before a command differs from what was heard there, from which it began otherwise."""

MISHEARD = 0.6
"""Share of its letters by which the beginning of a command differs at most from what was heard in its place: "making"
and "make me", but not "who ordered" and "I want"."""


def goes_on(words: Sequence[str], heard: Iterable[Sequence[str]]) -> bool:
    """Whether a sentence goes on from all the words that one model heard, with such as none heard: they were not
    said.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
    """
    said = list(words)
    heard = [list(one) for one in heard]
    return said not in heard and any(said[: len(one)] == one for one in heard)


def ends_unheard(words: Sequence[str], heard: Sequence[Sequence[str]]) -> bool:
    """Whether a sentence ends with words that are like nothing that several models heard.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
    """
    return bool(_end_beyond(words, heard, UNHEARD_LETTERS))


def end_left_out(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Sequence[str]:
    """The last words that were heard, where a sentence ends before them for each of several models: "at six miles per
    hour" was said, whoever drives on without it. Empty: it leaves out nothing.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
    """
    left_out = [_end_beyond(one, [words], LEFT_OUT_LETTERS) for one in heard]
    return left_out[0] if left_out and all(left_out) else _end_alike(words, heard)


def _end_alike(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Sequence[str]:
    """The last words that several models heard alike, where a sentence has none of them."""
    if len(heard) < 2:
        return ()
    pairs = zip(*(reversed(one) for one in heard), strict=False)
    alike = sum(1 for _ in itertools.takewhile(lambda ends: len(set(ends)) == 1 and ends[0] not in words, pairs))
    end = heard[0][len(heard[0]) - alike :]
    letters = sum(map(len, end))
    if letters < ALIKE_LETTERS or alike >= min(map(len, heard)):
        return ()
    nearer = [letters_apart(words, one) - letters_apart(words, one[:-alike]) for one in heard]
    return end if min(nearer) >= BEYOND_ALIKE * letters else ()


def _end_beyond(words: Sequence[str], others: Sequence[Sequence[str]], least: int) -> Sequence[str]:
    """The last words, without which the words are nearer to each of some others by nearly as many letters as these
    have; not all."""
    whole = [letters_apart(words, one) for one in others]
    for count in range(1, len(words)):
        end = words[-count:]
        letters = sum(map(len, end))
        nearer = [before - letters_apart(words[:-count], one) for before, one in zip(whole, others, strict=True)]
        if letters >= least and min(nearer, default=0.0) >= BEYOND * letters:
            return end
    return ()


def begin_left_out(words: Sequence[str], lead: int, heard: Iterable[tuple[Sequence[str], int]]) -> Sequence[str]:
    """The first words that were heard, where a sentence begins otherwise, and all models that heard how the command
    goes on heard the same: of "do you go to the kitchen" it is no "go to the kitchen", of "I want to go" no "I want
    you to go". Empty: it begins as they heard it, or they heard its beginning each in another way, or not at all.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning ("please", "can you").
        heard: the words that each model heard, and how many of these say nothing.
    """
    first = next((word for word in words[lead:] if word not in ARTICLES), None)
    if first is None:
        return ()
    heard = list(heard)
    forms = (first, *(first + ending for ending in ENDINGS))
    return _begin_before(forms[:1], words[:lead], heard) or _begin_before(forms, words[:lead], heard)


def begins_like(words: Sequence[str], other: Sequence[str], heard: Sequence[str]) -> bool:
    """Whether what a sentence has before the words that it ends with as another does is like what was heard there.

    Args:
        words: of the sentence.
        other: words of the other.
        heard: words that were heard before that one.
    """
    pairs = zip(reversed(words), reversed(other), strict=False)
    same = sum(1 for _ in itertools.takewhile(lambda pair: pair[0] == pair[1], pairs))
    own, before = ([word for word in part if word not in ARTICLES] for part in (words[: len(words) - same], heard))
    return letters_apart(own, before) <= MISHEARD * max(sum(map(len, own)), sum(map(len, before)))


def _begin_before(
    forms: Sequence[str], begins: Sequence[str], heard: Iterable[tuple[Sequence[str], int]]
) -> Sequence[str]:
    """The words that all models which heard a word in one of its forms heard before it, if these are not those with
    which the sentence begins."""
    places = (
        (one, nothing, next((list(one).index(form) for form in forms if form in one), None)) for one, nothing in heard
    )
    begun = {(tuple(one[:place]), nothing) for one, nothing, place in places if place is not None}
    if len({_letters(begin) for begin, _ in begun}) != 1:
        return ()
    begin, nothing = min(begun)
    apart = min(_apart(begin, begins), _apart(begin[nothing:], ()))
    return begin if apart >= BEGIN_LETTERS else ()


def _apart(one: Iterable[str], other: Iterable[str]) -> int:
    return Levenshtein.distance(_letters(one), _letters(other))


def _letters(words: Iterable[str]) -> str:
    return "".join(word for word in words if word not in ARTICLES)
