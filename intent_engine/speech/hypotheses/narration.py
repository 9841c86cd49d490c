"""Who tells something gives no command: "when you go to the kitchen", "we go to the kitchen".

A recogniser that is led along a grammar would leave such words out. Those that it heard clearly were said, and a
command that has no place for them was not.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from rapidfuzz.distance import Levenshtein

from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.words.homophones import LETTERS_BY_SOUND
from intent_engine.language.words.likeness import sound
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.speech.hypotheses.evidence import letters_apart

if TYPE_CHECKING:
    from intent_engine.language.grammar import Grammar

__all__ = [
    "NARRATING",
    "SUBJECTS",
    "SUBJECTS_IN",
    "asks_politely",
    "asks_whether",
    "leaves_out",
    "lets_another",
    "misheard",
    "narrating",
    "told",
    "verbless",
]

NARRATING = frozenset(
    {"when", "why", "how", "what", "where", "who", "which", "if", "unless", "until", "because", "did", "didnt", "was"}
    | {"were", "had", "has", "should", "he", "she", "they", "not", "never", "no", "dont", "cannot", "cant", "wont"}
    | {"without", "except", "neither", "nor", "nobody", "nothing", "nowhere"}
)
"""English words with which a sentence is no command, wherever they stand."""
SUBJECTS: Mapping[str, str] = {
    **dict.fromkeys(("i", "im", "id", "ive", "ill"), "i"),
    **dict.fromkeys(("you", "youre", "youd", "youve", "youll"), "you"),
    **dict.fromkeys(("we", "weve"), "we"),
    "it": "it",
}
"""Words with which a statement begins, each with the person that it stands for: "I'd like" may be heard as "I like". A
command may have them elsewhere ("can you put it down"). "It's" is none of them: "spin" is heard so in noise."""
SUBJECTS_IN: Mapping[str, Mapping[str, str]] = {
    "en": SUBJECTS,
    "de": {word: word for word in ("ich", "du", "er", "sie", "es", "wir", "ihr", "man")},
}
"""The same by language."""
TELLING = frozenset(
    {"is", "isnt", "are", "arent", "am", "was", "wasnt", "has", "hasnt", "does", "doesnt", "goes", "went"}
)
"""Words that tell or ask something, wherever they stand."""
ASKING = frozenset(("who", "whose", "what", "which", "where", "when", "why", "how"))
"""Words with which a question begins. A command that is one ("where are you") may begin with another of them than was
heard."""
DOING = frozenset(("do", "does", "did"))
"""With a subject they ask whether somebody does something."""
MAY = frozenset(("can", "could", "will", "would"))
"""With "you" they ask for something to be done."""
OTHERS = frozenset(("he", "she", "they"))
"""Subjects that no command begins with, whoever is meant."""
LET = frozenset(("me", "him", "her", "them"))
"""Whom somebody lets do what is no command then: "let me open the door", where "let us" says nothing."""
MOST_VERB = 2
"""Words of a verb, before the article of what something is done to: "pick up the ..."."""
MISHEARD = 0.4
"""Share of the letters in which a word of a command differs at most from such a word that was heard in its place."""

PART_OF_A_WORD = 0.25
"""Share of the letters of a subject that was heard, by which what was heard is nearer with it to a sentence that begins
so: at least 0.27 for 14 of 20 that recognisers wrote of verbs such as "weed", and less for 19 of 24 statements."""


def narrating(grammar: Grammar) -> frozenset[str]:
    """Words with which a sentence is no command, wherever they stand: of other languages than English those that no
    free slot takes ("nicht", "wenn"), but for such as commands are joined and corrected with, and stopped."""
    if grammar.language == "en":
        return NARRATING
    operators = grammar.operators
    joining = (*operators.sequence, *operators.contrast, *operators.correction, *operators.cancel, *operators.stop)
    elsewhere = (*joining, *operators.pronoun, *grammar.fillers, *grammar.wake)
    return operators.closed.difference(words[0] for words in elsewhere if len(words) == 1)


def leaves_out(words: Sequence[str], story: Iterable[str], heard: Sequence[Sequence[str]]) -> bool:
    """Whether a sentence has no place for one of the words that tell a story.

    Args:
        words: of the sentence.
        story: words of :func:`narrating` that were heard, and one of :data:`SUBJECTS_IN` with which it began.
        heard: all words that each model heard: no other was heard in place of one of these.
    """
    persons = {SUBJECTS[word] for word in words if word in SUBJECTS}
    unheard = [word for word in words if not any(word in one for one in heard)]
    return any(
        word not in words
        and SUBJECTS.get(word) not in persons
        and not _stands_for(word, unheard)
        and not any(_begins_a_word(word, words, one) for one in heard)
        for word in story
    )


def told(words: Sequence[str], heard: Sequence[Sequence[str]], lead: int = 0) -> Sequence[str]:
    """The first words that all models heard alike, up to one with which something is told or asked, where a
    sentence has no place for that: "she" of "she goes back", "all of us went", "who moved the cup" for "remove the
    cup". In noise one model alone hears anything, and two the same only if it was said: of 1,296 commands of
    synthetic voices that were done in doubt, clean and at 10 dB, one is lost by it.

    Args:
        words: of the sentence.
        heard: the words that each model heard.
        lead: how many of them say nothing ("please", "can you").

    Returns:
        The words; empty: nothing is told.
    """
    first = next(iter(heard), ())
    for place, word in enumerate(first):
        if any(one[place : place + 1] != first[place : place + 1] for one in heard):
            break
        asks = word in ASKING and ASKING.isdisjoint(words)
        tells = word in TELLING or (place == lead and (word in SUBJECTS or word in OTHERS or asks))
        if tells and leaves_out(words, [word], heard):
            return first[: place + 1]
    return ()


def lets_another(words: Sequence[str], lead: int, heard: Iterable[tuple[Sequence[str], int]]) -> Sequence[str]:
    """The first words that one of several models heard, where somebody else is let do what the verb of a sentence says:
    "let me open the door" for "let us open the door". Empty: none heard such.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard, and how many of these say nothing.
    """
    for one, nothing in heard:
        first = one[nothing : nothing + 3]
        if len(first) == 3 and first[0] == "let" and first[1] in LET and [first[2]] == [*words[lead : lead + 1]]:
            return first[:2]
    return ()


def asks_whether(words: Sequence[str], lead: int, heard: Collection[tuple[Sequence[str], int]]) -> Sequence[str]:
    """The first words that one of several models heard, where they ask whether somebody does what a sentence says, and
    each of the others heard something before the verb too: "do you go to the kitchen", of which one heard "bee go".
    Empty: none heard such.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard, and how many of these say nothing.
    """
    verb = words[lead : lead + 1]
    begins = [one[nothing : one.index(verb[0])] for one, nothing in heard if verb and verb[0] in one[nothing + 1 :]]
    if len(begins) < max(len(heard), 2):
        return ()
    asking = (begin for begin in begins if len(begin) == 2 and begin[0] in DOING and begin[1] in {*SUBJECTS, *OTHERS})
    return next(asking, ())


def asks_politely(words: Sequence[str], lead: int, heard: Iterable[Sequence[str]]) -> Sequence[str]:
    """The first words that one of several models heard, where they ask whether somebody does or did what a sentence
    asks for politely, with a word that none heard: "did you weigh it" is no "can you weigh it". Empty: none heard such.

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard.
    """
    heard = list(heard)
    politely = any(one in MAY and other in SUBJECTS for one, other in pairwise(words[:lead]))
    if not politely or any(word in MAY for one in heard for word in one):
        return ()
    return next((one[:2] for one in heard if one[:1] and one[0] in DOING and one[1:2] and one[1] in SUBJECTS), ())


def verbless(words: Sequence[str], lead: int, heard: Sequence[Sequence[str]]) -> bool:
    """Whether a sentence begins with a verb that no model heard, and what one of them heard begins with the very
    article and noun behind it, and what the others heard too, but for words that tell or ask something before these:
    "the block at ninety degrees" and "did the block at ninety degrees" are no "set the block to ninety degrees". So it
    is with a number that all begin with, and what is counted: "two tablets for bed 7" is no "get two tablets".

    Args:
        words: of the sentence.
        lead: how many of them say nothing at its beginning.
        heard: the words that each model heard, without such.
    """
    own = words[lead:]
    if _counts(own, heard):
        return True
    article = next((at for at, word in enumerate(own) if word in ARTICLES), 0)
    if not 0 < article <= MOST_VERB or article + 1 >= len(own):
        return False
    begun = [_before_named(own[article + 1], one) for one in heard if one]
    return [] in begun and all(one is not None and (NARRATING | TELLING).issuperset(one) for one in begun)


def _counts(own: Sequence[str], heard: Sequence[Sequence[str]]) -> bool:
    """Whether words that count something stand behind the verb, and all that was heard begins with them."""
    begin = next((at for at, word in enumerate(own) if word in NUMBER_WORDS or is_numeral(word)), 0)
    counted = [sound(word) for word in own[begin : begin + 2]]
    if not 0 < begin <= MOST_VERB or len(counted) < 2 or not heard:
        return False
    return all([sound(word) for word in one[:2]] == counted for one in heard)


def _before_named(noun: str, heard: Sequence[str]) -> list[str] | None:
    """What was heard before the first article, where a noun stands behind that; None: it does not."""
    place = next((at for at, word in enumerate(heard) if word in ARTICLES), len(heard))
    named = heard[place + 1 : place + 2]
    return list(heard[:place]) if [sound(word) for word in named] == [sound(noun)] else None


def _begins_a_word(subject: str, words: Sequence[str], heard: Sequence[str]) -> bool:
    """Whether a subject that was heard is the beginning of a word that was not: "I regate" is "irrigate", "we bet six"
    is "weed bed six". With it, what was heard is nearer to the sentence than without; where somebody tells of what is
    done ("she activates the scene"), it is further."""
    if subject not in SUBJECTS or subject not in heard or words[0] in heard:
        return False
    place = heard.index(subject)
    without = [*heard[:place], *heard[place + 1 :]]
    return letters_apart(words, without) - letters_apart(words, heard) >= PART_OF_A_WORD * len(subject)


def misheard(heard: str, word: str) -> bool:
    """Whether a word that was heard may have been another: "had" for "head"."""
    return Levenshtein.normalized_distance(heard, word) <= MISHEARD


def _stands_for(heard: str, words: Sequence[str]) -> bool:
    """Whether a word that was heard may have been one of these, as "you" may be the "u" of "u turn"."""
    letter = LETTERS_BY_SOUND.get(heard)
    return any(word == letter or misheard(heard, word) for word in words)
