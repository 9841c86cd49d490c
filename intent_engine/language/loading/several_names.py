"""Names of a place that are one text: a list of one, as in a grammar, unless it looks like several."""

from __future__ import annotations

import re

from intent_engine.language.loading.yaml_source import YamlPath, YamlSource

__all__ = ["as_list", "looks_like_several", "on_several_lines"]

_BETWEEN = re.compile(r"[,;/|\n]")
"""Between names in one text; the schema of maps knows the same."""


def looks_like_several(names: str) -> bool:
    """Whether a text is no single name."""
    return not names.strip() or _BETWEEN.search(names) is not None


def as_list(names: str) -> str:
    """What to write for names that were written as one text: ``[foyer, entrance]``."""
    return f"[{', '.join(filter(None, map(str.strip, _BETWEEN.split(names))))}]"


def on_several_lines(source: YamlSource, place: YamlPath) -> bool:
    """Whether names of a place stand on lines of their own without a sign between them; that is told."""
    folded = [(*place, key) for key in ("aliases", "tags") if (*place, key) in source.folded]
    told = [path for path in folded if not list(source.entries(path, ""))]
    return bool(told)
