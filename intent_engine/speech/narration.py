"""Who tells something gives no command: "when you go to the kitchen", "we go to the kitchen".

A recogniser that is led along a grammar would leave such words out. Those that it heard clearly were said, and a
command that has no place for them was not. English words only.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from rapidfuzz.distance import Levenshtein

__all__ = ["NARRATING", "SUBJECTS", "leaves_out"]

NARRATING = frozenset(
    {"when", "why", "how", "what", "where", "who", "which", "if", "unless", "until", "because", "did", "didnt", "was"}
    | {"were", "had", "has", "should", "he", "she", "they", "not", "never", "no", "dont", "cannot", "cant", "wont"}
    | {"without", "except", "neither", "nor", "nobody", "nothing", "nowhere"}
)
"""Words with which a sentence is no command, wherever they stand."""
SUBJECTS: Mapping[str, str] = {
    **dict.fromkeys(("i", "im", "id", "ive", "ill"), "i"),
    **dict.fromkeys(("you", "youre", "youd", "youve", "youll"), "you"),
    **dict.fromkeys(("we", "weve"), "we"),
    "it": "it",
}
"""Words with which a statement begins, each with the person that it stands for: "I'd like" may be heard as "I like". A
command may have them elsewhere ("can you put it down"). "It's" is none of them: "spin" is heard so in noise."""
MISHEARD = 0.4
"""Share of the letters in which a word of a command differs at most from such a word that was heard in its place."""


def leaves_out(words: Sequence[str], story: Iterable[str], heard: Collection[str]) -> bool:
    """Whether a sentence has no place for one of the words that tell a story.

    Args:
        words: of the sentence.
        story: words of :data:`NARRATING` that were heard, and one of :data:`SUBJECTS` with which it began.
        heard: all words that were heard: no other was heard in place of one of these.
    """
    persons = {SUBJECTS[word] for word in words if word in SUBJECTS}
    misheard = [word for word in words if word not in heard]
    return any(
        word not in words and SUBJECTS.get(word) not in persons and not _stands_for(word, misheard) for word in story
    )


def _stands_for(heard: str, words: Sequence[str]) -> bool:
    """Whether a word that was heard may have been one of these: "had" for "head"."""
    return any(Levenshtein.normalized_distance(heard, word) <= MISHEARD for word in words)
