"""What leads one model along the grammar of one language, kept until that is reloaded."""

from __future__ import annotations

from dataclasses import dataclass

from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.speech.acoustic.scoring import Scoring
from intent_engine.speech.acoustic.writing import Writer
from intent_engine.speech.hypotheses.guided import GuidedSearch
from intent_engine.speech.hypotheses.rivals import Rivals
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

__all__ = ["Guide"]


@dataclass(frozen=True, slots=True)
class Guide:
    """A grammar in a model's pieces."""

    near: UtteranceSearch
    """The grammar's own search, another one after it was reloaded."""
    guided: GuidedSearch
    rivals: Rivals
    singles: dict[str, int]
    """Words that are whole sentences, each with its first piece."""

    @classmethod
    def of(cls, model: Scoring, grammar: SpokenGrammar, language: str | None) -> Guide:
        """Of the grammar of a language, for a model."""
        near = grammar.search(language)
        writer = Writer(model.tokenizer(language), language, model.names(language))
        return cls(
            near,
            GuidedSearch(near, writer, model.end_piece(language)),
            Rivals(near, writer, grammar.corrections(language)),
            {word: writer.pieces([word])[0] for word in near.single_words()},
        )
