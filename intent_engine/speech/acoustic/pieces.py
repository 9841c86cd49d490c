"""The pieces that a Whisper model writes words in, mended where its tokenizer file has lost one.

The published files of the multilingual models lack their first merge, the blank with a "t": it stood where a version
line was once skipped. A text that such a model *writes* looks the same, but one that it is *asked about* has " to" in
two pieces, as it never writes it: every word that begins with a "t" seems a million times less likely than it is.
"""

from __future__ import annotations

import json
from typing import Any

__all__ = ["mended"]


def mended(tokenizer: Any) -> Any:
    """A ``tokenizers.Tokenizer`` with every piece of its vocabulary within reach; the same one if nothing is missing.

    Merges come in the order of the pieces that they make, so a missing one is put where its piece stands.
    """
    if _whole(tokenizer):
        return tokenizer
    parts = json.loads(tokenizer.to_str())
    model = parts["model"]
    merges = [tuple(pair) if isinstance(pair, list) else tuple(pair.split(" ")) for pair in model["merges"]]
    made = {"".join(pair) for pair in merges}
    numbers: dict[str, int] = model["vocab"]
    lost = [(piece[0], piece[1]) for piece in numbers if len(piece) == 2 and piece not in made]
    order = sorted([*merges, *lost], key=lambda pair: numbers.get("".join(pair), len(numbers)))
    model["merges"] = [list(pair) for pair in order]
    return type(tokenizer).from_str(json.dumps(parts))


def _whole(tokenizer: Any) -> bool:
    """Whether the first piece after the single bytes can be reached."""
    first = tokenizer.id_to_token(256)
    text = first.replace("\u0120", " ")
    return len(first) != 2 or tokenizer.encode(text, add_special_tokens=False).ids == [256]
