"""Run by mkdocs: writes what the program itself knows into the pages, so that they cannot fall behind it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

VERBS = "<!-- verbs -->"
"""Where docs/cli.md wants the reference of all verbs."""
DECISIONS = "<!-- decisions -->"
"""Where docs/decisions/index.md wants the list of its pages."""


def on_config(config: Any) -> Any:
    """Put every page of this folder that the navigation does not name into its section of guides."""
    named = set(re.findall(r"[\w/-]+\.md", str(config["nav"])))
    folder = Path(config["docs_dir"])
    guides = [path.name for path in sorted(folder.glob("*.md")) if path.name not in named]
    for section in config["nav"]:
        if "Guides" in section:
            section["Guides"] = guides
    return config


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Replace the marks of a page."""
    if VERBS in markdown:
        markdown = markdown.replace(VERBS, _verbs())
    if DECISIONS in markdown:
        folder = Path(page.file.abs_src_path).parent
        pages = sorted(path for path in folder.glob("*.md") if path.name != "index.md")
        markdown = markdown.replace(DECISIONS, "\n".join(f"- [{_title(path)}]({path.name})" for path in pages))
    return bars_as_written(markdown)


def bars_as_written(markdown: str) -> str:
    r"""``\|`` in the code of a table as ``|``: GitHub needs the stroke, and Python-Markdown would show it."""
    lines = markdown.split("\n")
    for number, line in enumerate(lines):
        if line.startswith("|"):
            lines[number] = re.sub(r"`[^`]+`", lambda code: code[0].replace("\\|", "|"), line)
    return "\n".join(lines)


def _verbs() -> str:
    command = [sys.executable, "-m", "typer", "intent_engine.cli", "utils", "docs", "--name", "intent-engine"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    # The page has its own title, and its verbs stand one level below it.
    return done.stdout.partition("\n")[2]


def _title(path: Path) -> str:
    return path.read_text("utf-8").partition("\n")[0].lstrip("# ")
