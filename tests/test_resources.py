"""Which file is meant by a bare name: a user's own first, then the one that comes with the engine."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from intent_engine import resources
from intent_engine.errors import ConfigError


def test_a_copy_in_the_folder_one_stands_in_wins(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert resources.default_grammar().is_absolute()
    (tmp_path / "grammars").mkdir()
    (tmp_path / "grammars" / "en.yaml").write_text("language: en\n", "utf-8")
    assert resources.default_grammar() == Path("grammars/en.yaml")


@pytest.mark.parametrize("given", ["grammars/mine.yaml", "mine.yaml", "/somewhere/mine.yml", "./mine"])
def test_a_path_is_a_path_even_if_nothing_is_there(given):
    assert resources.find("grammars", given) == Path(given)


def test_the_text_of_a_file_is_no_name_of_one():
    with pytest.raises(ConfigError, match="the text of a file stands where a path or a name belongs: 'language: en"):
        resources.find("grammars", "language: en\nintents: {}\n" * 50)


def test_a_name_that_is_too_long_for_a_file_is_that_of_none():
    with pytest.raises(ConfigError, match=r"no file xxx"):
        resources.find("grammars", "x" * 300)


def test_the_installed_package_comes_before_the_repository(tmp_path, monkeypatch):
    package = tmp_path / "site-packages" / "intent_engine"
    installed = package / "share" / "locations" / "home.yaml"
    installed.parent.mkdir(parents=True)
    installed.write_text("frame: map\n", "utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(resources, "PACKAGE", package)
    assert resources.default_locations() == [installed]
    with pytest.raises(ConfigError, match=r"no file en\.yaml in grammars/"):
        resources.default_grammar()


@pytest.mark.parametrize(
    ("texts", "maps"),
    [
        ((), ["home"]),
        (["language: en"], ["home"]),
        (["# Deutsch\nlanguage: de  # so\nintents: {}"], ["zuhause"]),
        (["language: 'de'"], ["zuhause"]),
        (["language: DE-AT"], ["zuhause"]),
        (["language: en", "language: de"], ["home", "zuhause"]),
        (["language: fr"], ["home"]),
        (["intents: {a: {language: de}}"], ["home"]),
        (["\n  language: de"], ["home"]),
        (["language:\nde"], ["home"]),
        ([""], ["home"]),
    ],
)
def test_the_map_of_the_home_is_in_the_language_of_the_grammar(tmp_path, texts, maps):
    files = [tmp_path / f"{place}.yaml" for place in range(len(texts))]
    for file, text in zip(files, texts, strict=True):
        file.write_text(text, "utf-8")
    assert [one.stem for one in resources.default_locations(files)] == maps


def test_a_grammar_that_cannot_be_read_is_of_no_language(tmp_path):
    (tmp_path / "latin.yaml").write_bytes(b"language: de\n# \xff")
    for file in (tmp_path, tmp_path / "none.yaml", tmp_path / "latin.yaml"):
        assert [one.stem for one in resources.default_locations([file])] == ["home"]


def test_everything_that_is_looked_for_is_put_into_the_wheel(root):
    project = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))
    included = project["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    for path in (resources.default_grammar(), *resources.default_locations(), resources.default_robot()):
        kind = path.parent.name
        assert included[kind] == f"intent_engine/share/{kind}"
        assert (root / kind / path.name).is_file()


def test_a_file_that_lies_here_is_named_where_a_bare_name_is_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wave.yaml").write_text("language: en\n", "utf-8")
    with pytest.raises(ConfigError, match=r"there is a file here: wave\.yaml"):
        resources.find("grammars", "wave")
