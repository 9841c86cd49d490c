"""What people usually did wrong where YAML cannot be read: strange blanks, quotes and colons, another format."""

from __future__ import annotations

import re

__all__ = [
    "after_a_quote",
    "merge_conflict",
    "section_of_ini",
    "spoilt_before",
    "typographic_quote",
    "without_colon",
    "without_dash",
]

_TYPOGRAPHIC = "\u201c\u201d\u201e\u2018\u2019\u201a\u00ab\u00bb"
_COLONS = "\uff1a\ufe55\ua789\u2236"
"""Colons that are none for YAML: of Chinese and Japanese keyboards, and of letters and mathematics."""
_SECTION = re.compile(r"\s*\[[\w.-]+\]\s*")


def section_of_ini(lines: list[str]) -> int | None:
    """The line, from 0, of the ``[Section]`` with which an INI file begins; None: it is none, or holds no more."""
    said = ((at, line) for at, line in enumerate(lines) if line.strip() and line.lstrip()[0] not in "#;")
    first, second = next(said, None), next(said, None)
    if first is None or second is None or not _SECTION.fullmatch(first[1]) or ": " in second[1]:
        return None
    return first[0]


def merge_conflict(lines: list[str]) -> tuple[int, str, str] | None:
    """The line with which git begins two versions of what follows, so that somebody may choose; None: there is none."""
    for at, line in enumerate(lines):
        if re.match(r"<{7}(?: |$)", line):
            return at, "is not valid YAML: a merge conflict begins here", "keep one of the two versions, up to >>>>>>>"
    return None


def typographic_quote(shown: str) -> str | None:
    """What to do about a quote of a word processor where YAML wants one of its own; None if there is none. One within
    a word is an apostrophe."""
    found = re.search(rf"(?<!\w)[{_TYPOGRAPHIC}]|[{_TYPOGRAPHIC}](?!\w)", shown)
    return f'{found[0]} is no quote for YAML: write " on both sides' if found else None


def spoilt_before(lines: list[str], line: int) -> tuple[int, str, str] | None:
    """A line, up to the one at which the parser gave up, with a blank or colon that is none, or no blank behind
    its first ':'; what is wrong with it, and what to do."""
    for at in range(line, max(line - 3, -1), -1):
        shown = lines[at] if at < len(lines) else ""
        lead = shown[: len(shown) - len(shown.lstrip())]
        if strange := next((sign for sign in lead if sign not in " \t"), None):
            return at, f"a blank of this line is no space, but U+{ord(strange):04X}", "type its blanks anew"
        if (colon := re.match(rf"\s*(?:- +)?\w+\s*([{_COLONS}])", shown)) is not None:
            message = f"is not valid YAML: the colon of this line is none, but U+{ord(colon[1]):04X}"
            return at, message, f"write {shown.strip().replace(colon[1], ': ', 1).replace(':  ', ': ')}"
        if re.match(r"\s*[a-z_]+:[^\s:/]", shown):
            return (
                at,
                "is not valid YAML: no blank stands behind this ':'",
                f"write {shown.strip().replace(':', ': ', 1)}",
            )
    return None


def without_colon(lines: list[str], line: int) -> tuple[int, str, str] | None:
    """The line before one on which a ':' cannot stand, if it should have one: ``wave``, ``action custom``, ``action =
    custom``; what is wrong with it, and what to do."""
    before = _before(lines, line)
    if before is None or lines[line].lstrip().startswith("-"):
        return None
    found = re.fullmatch(r"(\s*)(\w+)(?:(?:\s*=\s*|\s+)(\S.*?))?\s*", lines[before].split(" #")[0])
    if found is None or ":" in lines[before]:
        return None
    meant = f"{found[2]}: {found[3] or ''}".rstrip()
    return before, "is not valid YAML: no ':' stands in this line", f"write {meant}"


def without_dash(lines: list[str], line: int) -> tuple[int, str, str] | None:
    """The line before one that begins with a '-', if it stands as far to the right and has none."""
    before = _before(lines, line)
    if before is None or not lines[line].lstrip().startswith("- ") or not re.match(r"\s*[\w(]", lines[before]):
        return None
    if len(lines[before]) - len(lines[before].lstrip()) != len(lines[line]) - len(lines[line].lstrip()):
        return None
    return before, "is not valid YAML: no '-' stands in front of this line", f"write - {lines[before].strip()}"


def _before(lines: list[str], line: int) -> int | None:
    """The last line before another that holds more than a comment."""
    return next((at for at in range(min(line, len(lines)) - 1, -1, -1) if lines[at].split("#")[0].strip()), None)


def after_a_quote(lines: list[str], line: int, column: int) -> str | None:
    """What to do about words behind a quote that is closed; None if there is none in front of a place."""
    before = lines[line][:column].rstrip() if line < len(lines) else ""
    quote = before[-1:]
    if quote not in ("'", '"') or not quote:
        return None
    if before.count(quote) % 2:
        # All between the two is within the quotes, so the last line above with one is that which opens them.
        above = next((at for at in range(line - 1, -1, -1) if quote in lines[at]), None)
        if above is None or not lines[above].count(quote) % 2:
            return "this quote closes one that is opened further up: close that on its own line"
        return f"this quote closes one that is opened in line {above + 1}: close that there"
    if quote == "'":
        return "the text ends at its second '; write an apostrophe in double quotes: \"don't\""
    return "put all of the text between the quotes"
