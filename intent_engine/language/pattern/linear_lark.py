"""Lark, with terminals that RE2 looks for: Python's own regular expressions take years for some of them, as ``(a+)+b``
does of a long word."""

from __future__ import annotations

import re
from typing import Any

import re2
from lark import Lark

from intent_engine.language.pattern.every_letter import with_every_letter

__all__ = ["LinearLark"]


class _Linear:
    """In the place of the module ``re``, of which Lark uses this alone."""

    @staticmethod
    def compile(pattern: str, flags: int = 0) -> Any:
        """A regular expression; what RE2 does not know, as a look behind, is Python's."""
        options = re2.Options()
        options.log_errors = False
        try:
            return re.compile(pattern, flags) if flags else re2.compile(with_every_letter(pattern), options)
        except re2.error:
            return re.compile(pattern, flags)


class LinearLark(Lark):
    """A Lark grammar."""

    def _build_parser(self) -> Any:
        lexing: Any = self.lexer_conf
        lexing.re_module = _Linear
        return super()._build_parser()
