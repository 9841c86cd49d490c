"""What points back to what the same utterance named: "fly to tank 2 and photograph *it*", "focus on the actor and
follow *him*", "close the first valve and open *the second*", "go to the archive and fetch the boxes *from there*"."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood, free_words_of, readings_of
from intent_engine.language.meaning.wordings.nouns_before_of import NounsBeforeOf
from intent_engine.language.meaning.wordings.nouns_of_names import NounsOfNames
from intent_engine.language.meaning.wordings.nouns_of_numbers import NounsOfNumbers
from intent_engine.language.meaning.wordings.nouns_of_values import NounsOfValues
from intent_engine.language.meaning.wordings.persons_named import PersonsNamed
from intent_engine.language.meaning.wordings.places_there import PlacesThere
from intent_engine.language.meaning.wordings.pronouns import NameSaid, NamesListed
from intent_engine.language.utterance import Utterance

__all__ = ["NamedAgain"]


class NamedAgain:
    """Puts the one name that fits in the place of what points to it.

    Args:
        grammar: whose names they are.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._phrases = phrases
        self._names = NamesListed(grammar, phrases.sequence)
        others = (PersonsNamed, NounsOfValues, NounsOfNames, NounsOfNumbers, NounsBeforeOf, PlacesThere)
        self._rules = (self._names, *(rule(grammar, phrases.sequence) for rule in others))

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with those names; None: it points to none, or it is not clear to which.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        found = next(filter(None, (rule.put_in(core, as_said) for rule in self._rules)), None)
        at = self._phrases.correction.find(core.words, 1)
        if at is None or self._phrases.joined_before(core.words, at[0]):
            return found
        # "Make a tea, make it two" corrects how many, and makes no second tea.
        return None if any(one.intent is other.intent for one, other in pairwise(readings_of(found))) else found

    def before(
        self,
        text: str,
        core: Utterance,
        before: Callable[[], Sequence[Clause]],
        understood: Callable[[str], Understood],
    ) -> list[NameSaid]:
        """What the commands of an earlier utterance named for which the pronoun of a text may stand."""
        return self._names.before(text, core, before, lambda one: free_words_of(understood(one)))
