"""The search that the model leads along the grammar: with a made-up one, whose wish is known, and the real one."""

from __future__ import annotations

import zlib
from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.language.networks.approximate import UtteranceSearch
from intent_engine.language.utterance import plain
from intent_engine.speech.acoustic.writing import Names, Writer
from intent_engine.speech.hypotheses import guided, word_pieces
from intent_engine.speech.hypotheses.guided import GuidedSearch
from intent_engine.speech.hypotheses.word_count import WORD, word_count

VOCABULARY = 51864
SENTENCES = [
    ("go forward two meters", "Go forward two meters"),
    ("go forward two meters", "Go forward 2 meters"),
    ("turn left one hundred twenty degrees", "Turn left 120 degrees"),
    ("turn right ninety degrees", "Turn right, 90 degrees"),
    ("drive ahead zero point five meters", "Drive ahead 0.5 meters"),
    ("robot stop", "Robot, stop"),
    ("thats enough", "That's enough"),
    ("go to the charging dock", "Go to the charging dock"),
    ("pick up the cup", "Pick up the cup"),
]


class Wishes:
    """A model that wants to say one text: its next piece is likely, all others are unlikely, some more than others."""

    def __init__(self, tokens: Sequence[int], stop: int, wish: float = -0.1) -> None:
        self.tokens = (*tokens, stop)
        self.wish = wish
        self.calls = 0

    def row(self, beginning: tuple[int, ...]) -> np.ndarray:
        chance = np.random.default_rng(zlib.crc32(repr(beginning).encode()))
        row = chance.uniform(-14, -10, VOCABULARY).astype(np.float32)
        if beginning == self.tokens[: len(beginning)] and len(beginning) < len(self.tokens):
            row[self.tokens[len(beginning)]] = self.wish
        return row

    def __call__(self, beginnings, length):
        self.calls += 1
        for beginning in beginnings:
            for place in range(len(beginning) + 1):
                yield beginning[:place], self.row(beginning[:place])
            while len(beginning) < length:
                beginning = (*beginning, int(np.argmax(self.row(beginning))))
                yield beginning, self.row(beginning)


@pytest.fixture(scope="module")
def search(engine, whisper) -> GuidedSearch:
    return GuidedSearch(UtteranceSearch(engine.matcher().likely), Writer(whisper.tokenizer("en"), "en"))


@pytest.mark.parametrize(("words", "text"), SENTENCES)
def test_it_finds_what_the_model_wants_to_say(search, whisper, words, text):
    tokenizer = whisper.tokenizer("en")
    model = Wishes(tokenizer.encode(" " + text), *tokenizer.encode("."))
    found = search.likeliest(model, ["what", "ever"], "Whatever.", -8.0)
    assert found[0][0] == tuple(words.split())
    assert found[0][1] == pytest.approx(model.wish * len(model.tokens), abs=1e-4), "every piece and the full stop"
    assert model.calls <= guided.USUAL.calls


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_whatever_the_model_wants_only_sentences_of_the_grammar_come_out(search, engine, seed):
    chance = np.random.default_rng(seed)

    def anything(beginnings, length):
        for beginning in beginnings:
            yield beginning, chance.uniform(-6, 0, VOCABULARY).astype(np.float32)

    graph = engine.matcher().likely
    found = search.likeliest(anything, ["go"], "Go.", -3.0)
    values = [score + WORD * word_count(words) for words, score in found]
    assert values == sorted(values, reverse=True)
    for words, _ in found:
        read, state = graph.walk(words)
        assert read == len(words)
        assert graph.accepting(state)


def test_a_long_sentence_is_found_though_a_short_one_of_its_beginning_is_likelier(search, whisper):
    """In noise every word costs something, and whoever says less pays less."""
    tokenizer = whisper.tokenizer("en")
    said = tokenizer.encode(" Return to the starting point")
    model = Wishes(said, *tokenizer.encode("."), wish=-1.4)
    (right,) = tokenizer.encode(" Right")

    def tempted(beginnings, length):
        for beginning, row in model(beginnings, length):
            if not beginning:
                row[right] = -2.0
            if beginning == (right,):
                row[model.tokens[-1]] = -2.0
            yield beginning, row

    found = search.likeliest(tempted, ["return", "to", "this", "powder"], "Return to this powder.", -9.0)
    assert found[0][0] == ("return", "to", "the", "starting", "point")
    assert ("right",) in dict(found)


def test_what_is_far_behind_what_was_heard_is_given_up(search, whisper):
    model = Wishes([], *whisper.tokenizer("en").encode("."))
    assert search.likeliest(model, ["he", "was"], "He was not an ill disposed young man.", -3.0) == []
    assert model.calls == 1


def test_no_short_sound_stands_for_what_was_misheard(search, whisper):
    tokenizer = whisper.tokenizer("en")
    model = Wishes(tokenizer.encode(" So stop"), *tokenizer.encode("."))
    assert ("so", "stop") not in dict(search.likeliest(model, ["so", "stop"], "So stop.", -1.0))


def test_of_very_many_names_those_like_what_was_heard_are_asked_about(tmp_path, whisper, monkeypatch):
    names = "".join(f"  room {number}: {{x: 1.0, y: 1.0}}\n" for number in range(40)) + "  veranda: {x: 1.0, y: 1.0}\n"
    (tmp_path / "map.yaml").write_text("frame: map\nlocations:\n" + names)
    root = guided.__file__.rsplit("intent_engine", 1)[0]
    engine = IntentEngine.from_files(root + "grammars/en.yaml", locations=tmp_path / "map.yaml")
    monkeypatch.setattr(word_pieces, "MANY_WORDS", 10)
    tokenizer = whisper.tokenizer("en")
    search = GuidedSearch(UtteranceSearch(engine.matcher().likely), Writer(tokenizer, "en"))
    model = Wishes(tokenizer.encode(" Go to the veranda"), *tokenizer.encode("."))
    heard = ["go", "to", "the", "veronda"]
    assert search.likeliest(model, heard, "Go to the Veronda.", -6.0)[0][0] == ("go", "to", "the", "veranda")


@pytest.mark.parametrize("text", ["Tell Anna", "Tell anna", "Anna, come", "Tell the VIP"])
def test_a_name_is_found_as_the_model_writes_it(tmp_path, whisper, text):
    (tmp_path / "people.yaml").write_text(
        "language: en\nslots: {who: [Anna, the VIP]}\nintents: "
        "{tell: {action: {type: custom, name: tell}, sentences: ['tell {who}', '{who} come']}}\n"
    )
    engine = IntentEngine.from_files(tmp_path / "people.yaml")
    tokenizer = whisper.tokenizer("en")
    names = Names(tokenizer, engine.grammar.as_written)
    search = GuidedSearch(UtteranceSearch(engine.matcher().likely), Writer(tokenizer, "en", names))
    model = Wishes(tokenizer.encode(" " + text), *tokenizer.encode("."))
    found = search.likeliest(model, ["what", "ever"], "Whatever.", -8.0)
    assert found[0][0] == tuple(plain(text))
    assert found[0][1] == pytest.approx(model.wish * len(model.tokens), abs=1e-4)


def test_the_real_model_leads_to_what_was_said(search, whisper, spoken):
    encoded = whisper.encode(spoken)
    found = search.likeliest(
        lambda beginnings, length: whisper.next_pieces(encoded, beginnings, length, "en"),
        ["oh", "forward", "to", "me", "does"],
        "Oh forward to me does.",
        whisper.score(encoded, ["Oh forward to me does."], "en")[0],
    )
    assert found[0][0] == ("go", "forward", "two", "meters")
    words, score = found[0]
    assert score == pytest.approx(whisper.score_words(encoded, [words], "en")[0], abs=0.5), (
        "as teacher forcing finds it"
    )


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("", 0),
        ("stop", 1),
        ("one", 1),
        ("turn left one hundred and ten degrees", 4),
        ("turn left ninety degrees", 4),
        ("shake at a hundred rpm", 4),
        ("shake at eight hundred rpm", 4),
        ("go back two and a half meters", 4),
        ("turn left and ten degrees", 5),
        ("bring one and a cup", 5),
        ("bring a cup", 3),
    ],
)
def test_a_number_counts_as_few_words(text, count):
    """Else "one hundred ten" would be worth two words more than the "ninety" that was said."""
    assert word_count(tuple(text.split())) == count
