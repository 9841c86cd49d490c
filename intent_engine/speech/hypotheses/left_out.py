"""Words that were heard and that a sentence leaves out, and words of a sentence that nobody heard.

A sentence is taken for what was said by how likely it is as a whole, and a word more or less weighs little there. Where
it begins, and where it ends, such a word makes another meaning of it: "do you go", "go ... at six miles per hour".
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from itertools import pairwise

from rapidfuzz.distance import Levenshtein

from intent_engine.language.words.likeness import sound
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.language.words.verb_forms import IRREGULAR, NEARLY_THE_VERB
from intent_engine.speech.hypotheses.evidence import letters_apart

__all__ = [
    "begin_left_out",
    "begins_like",
    "begins_unheard",
    "end_left_out",
    "ends_unheard",
    "goes_on",
    "heard_otherwise",
    "in_place_of",
    "passed_over",
    "tells",
    "told_of",
    "unheard",
]

UNHEARD_LETTERS = 6
"""Letters of the last words of a sentence, from which it is asked whether they were heard: a "milk" may be missed;"""
MOST_UNHEARD = 4
"""Words at most of which that is asked elsewhere;"""
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

OTHERWISE_LETTERS = 6
"""Letters of words that all models heard in the place of others, from which it is asked whether they may be these,"""
OTHERWISE = 0.65
"""and share of the letters by which they differ, from which they are not: "degrees" and "percent", "in the office" and
"immediately"; "palette" and "pallet" are the same."""
OTHERWISE_THAN_NOTHING = 0.4
"""The same of words that say nothing, which would be found for whatever was said: "at once"."""

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


def unheard(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Sequence[str]:
    """Words anywhere in a sentence that are like nothing that several models heard: of "the kitchen lights, nor the
    bedroom lights" it is no "the kitchen lights and turn on the bedroom lights". Empty: there are none.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
    """
    if len(heard) < 2 or not all(heard):
        return ()
    whole = [letters_apart(words, one) for one in heard]
    for begin, count in itertools.product(range(len(words)), range(1, MOST_UNHEARD + 1)):
        part, rest = words[begin : begin + count], [*words[:begin], *words[begin + count :]]
        letters = sum(map(len, part))
        if len(part) < count or letters < UNHEARD_LETTERS or not rest:
            continue
        if all(before - letters_apart(rest, one) >= BEYOND * letters for before, one in zip(whole, heard, strict=True)):
            return part
    return ()


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


def heard_otherwise(
    words: Sequence[str], heard: Sequence[Sequence[str]], nothing: Callable[[Sequence[str]], bool] = lambda _: False
) -> Sequence[str]:
    """The words that several models all heard where a sentence has others that sound otherwise: that was "turn off the
    lights in the office", whoever does it "at once". Empty: there are none.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
        nothing: whether words say nothing ("at once", "please").
    """
    for said, meant, _ in _all_instead(words, heard):
        apart = letters_apart(meant, said) / max(len("".join(meant)), len("".join(said)))
        least = OTHERWISE_THAN_NOTHING if nothing(meant) else OTHERWISE
        if len("".join(said)) >= OTHERWISE_LETTERS and apart >= least:
            return said
    return ()


def passed_over(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Iterator[tuple[Sequence[str], int]]:
    """The words that several models all heard between two that stand next to each other in a sentence: "set it to two
    *more* degrees". Articles are none, nor is what the sentence has beside them: who stammers says it twice.

    Args:
        words: of the sentence.
        heard: the words that each model heard.

    Yields:
        Such words, and the place in the sentence before which they were heard.
    """
    if len(heard) < 2:
        return
    places = [at for at, word in enumerate(words) if word not in ARTICLES]
    own = [words[at] for at in places]
    for said, at in sorted(set.intersection(*(_between(own, one) for one in heard))):
        if not set(said).issubset(own[max(at - len(said), 0) : at + len(said)]):
            yield said, places[at]


def tells(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Sequence[str]:
    """The word that several models all heard where a sentence has another form of it, with which somebody tells what
    they do or did: "turning on the lights". Empty: there is none.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
    """
    for said, meant, after in _all_instead(words, heard):
        if len(meant) == 1 == len(said) and said[0] in _told(meant[0], after):
            return said
    return _told_before(words, heard)


def _told_before(words: Sequence[str], heard: Sequence[Sequence[str]]) -> Sequence[str]:
    """The same, where the models heard what is before it each in another way: "all of us *went* to the lounge", of
    which one heard "Olavas went". Every one heard it before the word that the sentence goes on with."""
    own = [word for word in words if word not in ARTICLES]
    if len(heard) < 2:
        return ()
    each = [set(pairwise(word for word in one if word not in ARTICLES)) for one in heard]
    shared, any_of_them = set.intersection(*each), set.union(*each)
    for verb, after in pairwise(own):
        told = sorted({said for said, next_word in shared if next_word == after}.intersection(_told(verb, [after])))
        if told and (verb, after) not in any_of_them:
            return told[:1]
    return ()


def in_place_of(words: Sequence[str], heard: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Single words that a model heard, each with the one of a sentence in whose place it stands.

    Args:
        words: of the sentence.
        heard: the words that the model heard.
    """
    own = [word for word in words if word not in ARTICLES]
    for said, (begin, end) in sorted(_instead(own, heard)):
        if len(said) == 1 == end - begin:
            yield said[0], own[begin]


def told_of(
    words: Sequence[str], lead: int, heard: Sequence[tuple[Sequence[str], int]], persons: Collection[str]
) -> Sequence[str]:
    """The first words that one of several models heard, where they are a person or a question word and the form in
    which somebody tells what the verb of a sentence says: "who opened", "I lowered". A word more is easily heard in
    noise, and not with the form that fits it. Empty: none heard such.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard, and how many of these say nothing.
        persons: words that stand before a verb that tells something.
    """
    if lead >= len(words):
        return ()
    forms = _forms(words[lead], ENDINGS)
    for one, nothing in heard:
        first = one[nothing : nothing + 2]
        if len(first) == 2 and first[0] in persons and first[1] in forms:
            return first
    return ()


def _all_instead(
    words: Sequence[str], heard: Sequence[Sequence[str]]
) -> Iterator[tuple[Sequence[str], Sequence[str], Sequence[str]]]:
    """What several models all heard in the place of which words of a sentence, and the word after these."""
    if len(heard) < 2:
        return
    own = [word for word in words if word not in ARTICLES]
    for said, (begin, end) in sorted(set.intersection(*(_instead(own, one) for one in heard))):
        yield said, own[begin:end], own[end : end + 1]


def _instead(own: Sequence[str], heard: Sequence[str]) -> set[tuple[tuple[str, ...], tuple[int, int]]]:
    """What was heard, articles aside, in the place of which words of a sentence."""
    other = [word for word in heard if word not in ARTICLES]
    changes = SequenceMatcher(None, other, own, autojunk=False).get_opcodes()
    return {(tuple(other[begin:end]), (at, to)) for what, begin, end, at, to in changes if what == "replace"}


def _between(own: Sequence[str], heard: Sequence[str]) -> set[tuple[tuple[str, ...], int]]:
    """What was heard, articles aside, before which word that is not the first, where nothing else differs."""
    other = [word for word in heard if word not in ARTICLES]
    changes = SequenceMatcher(None, other, own, autojunk=False).get_opcodes()
    return {
        (tuple(other[begin:end]), at) for what, begin, end, at, _ in changes if what == "delete" and 0 < at < len(own)
    }


def _told(verb: str, after: Sequence[str]) -> Iterable[str]:
    """The forms of a verb in which somebody tells what they do or did. The end of the past is heard before vowels:
    "turned on", while "turn left" may be written "turned left", and "send two" may be "sent two"; "took two" was heard
    wherever it stands."""
    heard = bool(after) and after[0][0] in "aeiou"
    nearly = [form for form, its in NEARLY_THE_VERB.items() if its == verb and heard]
    return [*_forms(verb, ("ing", "ed") if heard else ("ing",)), *nearly]


def _forms(verb: str, endings: Sequence[str]) -> list[str]:
    """A verb with some endings, and its irregular forms."""
    stems = (verb, verb.removesuffix("e"), verb + verb[-1])
    return [*(stem + ending for stem in stems for ending in endings), *IRREGULAR.get(verb, ())]


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


def begin_left_out(
    words: Sequence[str], lead: int, heard: Iterable[tuple[Sequence[str], int]], least: int = BEGIN_LETTERS
) -> Sequence[str]:
    """The first words that were heard, where a sentence begins otherwise, and all models that heard how the command
    goes on heard the same: of "do you go to the kitchen" it is no "go to the kitchen", of "I want to go" no "I want
    you to go". Empty: it begins as they heard it, or they heard its beginning each in another way, or not at all.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning ("please", "can you").
        heard: the words that each model heard, and how many of these say nothing.
        least: letters by which it begins otherwise, if by so many.
    """
    first = next((word for word in words[lead:] if word not in ARTICLES), None)
    if first is None:
        return ()
    heard = list(heard)
    forms = (first, *(first + ending for ending in ENDINGS))
    as_it_is = _begin_before(forms[:1], words[:lead], heard, least)
    return as_it_is or _begin_before(forms, words[:lead], heard, least)


def begins_unheard(words: Sequence[str], lead: int, heard: Sequence[Sequence[str]]) -> bool:
    """Whether a sentence begins with a word that no model heard, and all that each heard is what follows it: who says
    "for three seconds" goes on from something, and said no "go for three seconds".

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard.
    """
    rest, whole = (_sounds(part) for part in (words[lead + 1 :], (*words[:lead], *words[lead + 1 :])))
    return bool(rest) and bool(heard) and all(_sounds(one) in (rest, whole) for one in heard)


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
    forms: Sequence[str], begins: Sequence[str], heard: Iterable[tuple[Sequence[str], int]], least: int
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
    return begin if apart >= least else ()


def _apart(one: Iterable[str], other: Iterable[str]) -> int:
    return Levenshtein.distance(_letters(one), _letters(other))


def _sounds(words: Iterable[str]) -> str:
    return "".join(sound(word) for word in words if word not in ARTICLES)


def _letters(words: Iterable[str]) -> str:
    return "".join(word for word in words if word not in ARTICLES)
