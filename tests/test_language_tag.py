"""Languages by the tags that people and systems write."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from intent_engine import IntentEngine
from intent_engine.cli import app
from intent_engine.errors import ConfigError
from intent_engine.language_tag import code_of, language_of
from intent_engine.resources import default_grammar

languages = st.from_regex(r"[a-z]{2,3}", fullmatch=True)
subtags = st.lists(st.from_regex(r"[-_][A-Za-z0-9]{1,8}", fullmatch=True), max_size=4).map("".join)


@given(languages, subtags)
def test_script_region_and_capitals_change_nothing(language, rest):
    assert language_of(language + rest) == language_of((language + rest).upper()) == language


@pytest.mark.parametrize("text", ["", "e", "en-", "-US", "english", "en US", "grammars/en.yaml", "en.yaml", "ën"])
def test_what_is_no_tag_stays_what_it_is(text):
    assert language_of(text) == text


@pytest.mark.parametrize("tag", ["de-AT", "de_DE", "DE", "de-Latn-CH-1996"])
def test_a_region_takes_the_grammar_and_the_map_of_its_language(tag):
    assert CliRunner().invoke(app, ["parse", "--language", tag, "fahr in die Küche"]).exit_code == 0
    assert IntentEngine.from_files(default_grammar("de")).parse("halt an", language=tag).stops


@pytest.mark.parametrize("tag", ["en_US", "EN", "en-US-x"])
def test_a_grammar_may_say_its_language_with_a_region(tag, tmp_path):
    (tmp_path / "g.yaml").write_text(f"language: {tag}\nintents:\n  wave: {{action: custom, sentences: [wave]}}\n")
    engine = IntentEngine.from_files(tmp_path / "g.yaml")
    assert engine.languages == ("en",)
    assert engine.parse("don't wave").actions == ()


@pytest.mark.parametrize(("name", "code"), [("English", "en"), (" deutsch ", "de"), ("français", "fr"), ("xx", None)])
def test_the_name_of_a_language_is_told_as_its_code(name, code):
    assert code_of(name) == code


def test_a_language_that_is_asked_for_by_its_name():
    with pytest.raises(ConfigError, match=r"no grammar of language 'german' is loaded.*\n.*write 'de'"):
        IntentEngine.from_files(default_grammar("de")).parse("halt", language="german")
