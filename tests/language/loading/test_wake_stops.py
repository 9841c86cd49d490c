"""A wake word that would take away a stop is refused, wherever it is given."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine
from intent_engine.errors import ConfigError

GRAMMAR = """\
language: en
wake: [rover, {wake}]
operators:
  stop: [enough now]
intents:
  wave: {{action: {{type: custom}}, sentences: [wave]}}
"""


@pytest.mark.parametrize(("wake", "stop"), [("stop", "stop"), ("Robot, stop", "stop"), ("enough now", "enough now")])
def test_in_a_file(tmp_path, wake, stop):
    path = tmp_path / "my.yaml"
    path.write_text(GRAMMAR.format(wake=repr(wake)), "utf-8")
    with pytest.raises(ConfigError, match=rf"my\.yaml:2:15: the wake word '.*' tells the robot to stop \('{stop}'\)"):
        IntentEngine.from_files(path)


@pytest.mark.parametrize(("grammars", "wake"), [(["en"], "stop"), (["en", "de"], "halt an"), (["de"], "Stopp")])
def test_given_to_an_engine(grammars, wake):
    with pytest.raises(ConfigError, match=r"the wake word '.*' tells the robot to stop") as caught:
        IntentEngine.from_files(grammars, wake=["robot", wake])
    assert "robot'" not in str(caught.value)


def test_a_name_is_one_though_a_stop_begins_like_it(tmp_path):
    path = tmp_path / "my.yaml"
    path.write_text(GRAMMAR.format(wake="stopper"), "utf-8")
    IntentEngine.from_files(path, wake=["enough"])
