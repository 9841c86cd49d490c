"""Thanks that are said once more repeat nothing: "thanks again"."""

from __future__ import annotations

import pytest

ENGLISH = """
language: en
fillers: [thanks, "thank you", robot]
intents:
  again: {action: custom, sentences: ["[do it] again", "once more"]}
  left: {action: custom, sentences: ["turn left [again]"]}
"""
GERMAN = """
language: de
intents:
  again: {action: custom, sentences: ["[mach das] (nochmal|nochmals|noch einmal)"]}
"""


@pytest.mark.parametrize(
    ("grammar", "said"),
    [
        (ENGLISH, "thanks again"),
        (ENGLISH, "Thank you once more, robot."),
        (ENGLISH, "again thank you"),
        (GERMAN, "noch einmal danke"),
        (GERMAN, "nochmals vielen Dank"),
        (GERMAN, "danke schön nochmal"),
    ],
)
def test_they_repeat_nothing(engine_of, grammar: str, said: str) -> None:
    assert not engine_of(grammar).parse(said).actions


@pytest.mark.parametrize(
    ("grammar", "said", "intent"),
    [
        (ENGLISH, "again, thanks", "again"),
        (ENGLISH, "thanks, do it again", "again"),
        (ENGLISH, "do it again thanks", "again"),
        (ENGLISH, "turn left again thanks", "left"),
        (GERMAN, "nochmal, danke", "again"),
        (GERMAN, "danke, mach das nochmal", "again"),
    ],
)
def test_an_order_with_thanks_is_done(engine_of, grammar: str, said: str, intent: str) -> None:
    assert engine_of(grammar).parse(said).intent == intent
