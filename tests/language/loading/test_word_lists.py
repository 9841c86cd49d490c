"""Lists of language files that are written short."""

from __future__ import annotations

import pytest

from intent_engine.language.loading.word_lists import in_full


@pytest.mark.parametrize(
    ("written", "phrases"),
    [
        (["stop", "stop it"], ["stop", "stop it"]),
        (["[no] sorry"], ["sorry", "no sorry"]),
        (["(can|could) you [please]"], ["can you", "can you please", "could you", "could you please"]),
        (["stop [it|right now]"], ["stop", "stop it", "stop right now"]),
        (["hold [on [a second]]"], ["hold", "hold on", "hold on a second"]),
        (["((can|could) you|would they) go"], ["can you go", "could you go", "would they go"]),
        (["and", ["then", "[and] next"]], ["and", "then", "next", "and next"]),
        (["then", "[and] then"], ["then", "and then"]),
        ([1, "t'arrêter"], ["1", "t'arrêter"]),
    ],
)
def test_what_a_list_stands_for(written: list[object], phrases: list[str]) -> None:
    assert sorted(in_full(written)) == sorted(phrases)
