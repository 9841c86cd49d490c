"""The pieces in which Moonshine writes words: those of Llama, of which its models carry the bare list."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any

__all__ = ["BEGINNING", "END", "MoonshinePieces"]

BEGINNING, END = 1, 2
"""Of a text."""
FIRST_BYTE = 3
"""The piece that is the byte 0; the other bytes follow."""
BYTES = 256
WORDS = 32000
"""Pieces of text; further ones are no text."""
BLANK = "\u2581"


class MoonshinePieces:
    """A tokenizer from ``tokenizer.bin``.

    The list has no merges, but they follow from it: a piece is made of any two that it is the sum of, and one that
    stands earlier is made first (https://github.com/google/sentencepiece, ``bpe``).

    Args:
        file: pieces in UTF-8, each after its length (of 128 bytes and more in two bytes, the lower seven bits first).

    Raises:
        ValueError: the file is something else.
    """

    eot = END

    def __init__(self, file: Path) -> None:
        self._pieces = list(_read(file.read_bytes()))
        if len(self._pieces) < WORDS or self._pieces[BEGINNING] != b"<s>":
            raise ValueError(f"{file.name} is no list of pieces")

    def encode(self, text: str) -> list[int]:
        """The pieces of a text; one that begins with a blank begins with a word."""
        return list(self.tokenizer.encode(text, add_special_tokens=False).ids)

    def decode(self, pieces: list[int]) -> str:
        """The text of pieces."""
        raw = b"".join(self._pieces[piece] for piece in pieces if END < piece < WORDS)
        return raw.decode("utf-8", "replace").replace(BLANK, " ").strip()

    @cached_property
    def tokenizer(self) -> Any:
        """As a ``tokenizers.Tokenizer``."""
        from tokenizers import Tokenizer, decoders, models, normalizers

        names = [self._name(number) for number in range(WORDS)]
        numbers = {name: number for number, name in enumerate(names)}
        merges = []
        for name in names[FIRST_BYTE + BYTES :]:
            pairs = [(name[:at], name[at:]) for at in range(1, len(name))]
            known = [pair for pair in pairs if pair[0] in numbers and pair[1] in numbers]
            merges += sorted(known, key=lambda pair: (numbers[pair[0]], numbers[pair[1]]))
        found = Tokenizer(models.BPE(vocab=numbers, merges=merges, unk_token="<unk>", byte_fallback=True))
        found.normalizer = normalizers.Replace(" ", BLANK)
        found.decoder = decoders.Sequence([decoders.Replace(BLANK, " "), decoders.ByteFallback(), decoders.Fuse()])
        return found

    def _name(self, number: int) -> str:
        """How ``tokenizers`` calls a piece."""
        if FIRST_BYTE <= number < FIRST_BYTE + BYTES:
            return f"<0x{number - FIRST_BYTE:02X}>"
        return self._pieces[number].decode("utf-8")


def _read(raw: bytes) -> list[bytes]:
    pieces = []
    at = 0
    while at < len(raw):
        length = raw[at]
        at += 1
        if length >= 128:
            if at >= len(raw):
                raise ValueError("it is cut off")
            length = raw[at] * 128 + length - 128
            at += 1
        if at + length > len(raw):
            raise ValueError("it is cut off")
        pieces.append(raw[at : at + length])
        at += length
    return pieces
