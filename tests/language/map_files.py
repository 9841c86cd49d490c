"""Maps to write, and what a mistake in one is told as; for the tests of map files."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import assume
from hypothesis import strategies as st

from intent_engine.errors import ConfigError
from intent_engine.language.locations import Location, load
from intent_engine.language.slots.name_words import name_words

metres = st.floats(-1e6, 1e6)
words = st.text("abcdefghijklmnopqrstuvwxyz", min_size=2, max_size=8)
spoken = st.lists(words, min_size=1, max_size=3).map(" ".join)


@st.composite
def maps(draw):
    """Places whose names are all said differently."""
    said: set[tuple[str, ...]] = set()

    def fresh(name: str) -> bool:
        key = name_words(name)
        if key in said or name in ("yes", "no", "on", "off", "true", "false", "null", "nan", "inf"):
            return False
        said.add(key)
        return True

    found = {}
    for name in draw(st.lists(spoken, min_size=1, max_size=6)):
        aliases = [alias for alias in draw(st.lists(spoken, max_size=3)) if fresh(alias)]
        if fresh(name):
            pose = {"x": draw(metres), "y": draw(metres)}
            optional = {
                "yaw": draw(st.floats(-math.pi, math.pi)),
                "tags": draw(st.lists(words, min_size=1, max_size=2)),
            }
            optional |= {"frame": draw(st.sampled_from(["odom", "level 2"]))} | (
                {"aliases": aliases} if aliases else {}
            )
            keys = draw(st.lists(st.sampled_from(sorted(optional)), unique=True))
            found[name] = pose | {key: optional[key] for key in keys}
    assume(found)
    return found


def expected(places: dict, frame: str) -> dict[str, Location]:
    return {
        name: Location(
            name,
            pose["x"],
            pose["y"],
            pose.get("yaw", 0.0),
            pose.get("frame", frame),
            tuple(pose.get("aliases", ())),
            tuple(pose.get("tags", ())),
        )
        for name, pose in places.items()
    }


def problems_of(text: str, path: Path) -> list[str]:
    path.write_text(text, "utf-8")
    with pytest.raises(ConfigError) as caught:
        load(path)
    for problem in caught.value.problems:
        assert problem.file == str(path)
        if problem.line is not None:
            assert problem.source == text.split("\n")[problem.line - 1]
            assert 1 <= problem.column <= len(problem.source) + 1
    return [f"{problem.line}:{problem.column} {problem.message} ({problem.hint})" for problem in caught.value.problems]
