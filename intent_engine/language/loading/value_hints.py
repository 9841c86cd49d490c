"""What to write in the place of a value that is of another kind than the one that is wanted."""

from __future__ import annotations

import math
import re
from typing import Any

from intent_engine.language.normalize import words_of

__all__ = ["YAML_BOOLEANS", "in_si", "number_in_text", "plainer", "pose_otherwise", "values_otherwise"]

YAML_BOOLEANS = {"yes", "no", "on", "off", "true", "false"}
"""Words that YAML reads as true and false."""


def values_otherwise(path: tuple[Any, ...], instance: Any) -> str | None:
    """What to write for a value of a list that is a mapping, as hassil has ``{in: bow, out: bridge}``, and for a state
    that has a value; None: it is neither."""
    if not isinstance(instance, dict) or not instance:
        return None
    if path[:1] == ("slots",) and isinstance(path[-1], int) and path[2:3] in (("values",), path[-1:]):
        said, value = next(iter(instance.items()))[::-1]
        if {"in", "out"} <= instance.keys():
            said, value = instance["in"], instance["out"]
        elif len(instance) > 1 or isinstance(said, dict):
            return "write what is said for each value behind it: values: {bridge: [bow, bridge]}"
        shown = f'"{said}"' if isinstance(said, str) and re.search(r"\W", said) else said
        return f"write values: {{{value}: {shown}}}, and all that is said for one value in a list"
    if path[:1] == ("intents",) and path[2:] in (("requires",), ("excludes",)):
        return f"states have names alone, and no values: {path[2]}: [docked]"
    return None


def plainer(path: tuple[Any, ...], wanted: list[str], instance: Any) -> str | None:
    """What to write for something of another type, where nothing better is known."""
    if "boolean" in wanted and str(instance).lower() in YAML_BOOLEANS:
        return f"write it without quotes: {instance}"
    if "string" in wanted and isinstance(instance, list):
        return f"write one {'number' if 'number' in wanted else 'text'}, without a '-' or brackets"
    if wanted == ["object"] and path[:1] == ("intents",) and len(path) == 2:
        return f"write {{action: custom, sentences: [{instance}]}}"
    if wanted == ["object"] and path[-1:] == ("units",):
        return f"units are your own, with their sizes: {{30 cm: [step, steps]}}; one that is known is unit: {instance}"
    if wanted == ["object"] and path[:1] == ("locations",) and path[-1:] in (("x",), ("y",), ("yaw",)):
        return "indent it below the name of its place"
    if wanted == ["number"] or wanted == ["integer"]:
        return "write a number"
    return None


def number_in_text(raw: Any) -> str | None:
    """What to write for a number that is text to YAML: in quotes, or in another form, as 1e3; None: it is something
    else."""
    if not isinstance(raw, str) or re.fullmatch(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?", raw) is None:
        return None
    number = f"{float(raw):.15g}"
    return f"write {number} without quotes" if raw == number else f"YAML reads this as a word: write {number}"


def in_si(text: str, *, share: bool) -> str:
    """What to write for a number that has a unit, where none may be: "90 deg/s" is 1.5708. ``share``: it is a part of
    one."""
    from intent_engine.language.quantities import evaluate

    if (number := number_in_text(text)) is not None:
        return number
    words = words_of(text)
    if share:
        part = evaluate(words, "percent", "en")
        return f"it is a part of one: {part:g}" if isinstance(part, float) else "it is a part of one: 0.7"
    for kind in ("angular_speed", "angle", "speed", "distance", "duration"):
        value = evaluate(words, kind, "en")
        if isinstance(value, float):
            return f"a plain number in SI units, without a unit: {value:.5g}"
    return "a plain number, in SI units"


def pose_otherwise(path: tuple[Any, ...], instance: Any) -> str | None:
    """What to write for a pose, or a number of one, that is in another form: ``[5.0, 2.0, 0.0]``, ``90 deg``."""
    if len(path) == 3 and isinstance(instance, str):
        degrees = (
            re.fullmatch(r"\s*([-+]?[0-9.]+)\s*(?:°|deg|degs|degrees?)\s*", instance) if path[2] == "yaw" else None
        )
        if degrees is not None:
            return f"in rad, without a unit: {math.radians(float(degrees[1])):.4f}"
        return "a plain number, in " + ("rad" if path[2] == "yaw" else "m")
    numbers = (
        instance
        if isinstance(instance, list)
        else re.findall(r"[^\s(),]+", instance)
        if isinstance(instance, str)
        else ()
    )
    if len(path) != 2 or len(numbers) not in (2, 3):
        return None
    return (
        "write {" + ", ".join(f"{key}: {value}" for key, value in zip(("x", "y", "yaw"), numbers, strict=False)) + "}"
    )
