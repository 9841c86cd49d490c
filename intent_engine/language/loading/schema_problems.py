"""What JSON Schema finds wrong in a file, in words for the person who wrote it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean
from intent_engine.language.loading.other_words import (
    ACTIONS,
    FIELDS_OF_A_PLACE,
    KEYS_OF_A_GRAMMAR,
    KEYS_OF_A_SENTENCE,
    KEYS_OF_A_SLOT,
    KEYS_OF_AN_INTENT,
    TYPES,
    meant,
)
from intent_engine.language.loading.schema_check import surely_valid
from intent_engine.language.loading.several_names import as_list
from intent_engine.language.loading.value_hints import YAML_BOOLEANS, in_si, plainer, pose_otherwise, values_otherwise
from intent_engine.language.loading.yaml_source import YamlSource
from intent_engine.language_tag import code_of

if TYPE_CHECKING:
    from jsonschema import ValidationError
    from jsonschema.protocols import Validator

__all__ = ["schema_problems"]

_WORDS = {
    "string": "text",
    "object": "a mapping (key: value)",
    "array": "a list",
    "integer": "a whole number",
    "number": "a number",
    "boolean": "true or false",
    "null": "nothing",
}
_SLIP = 70
"""Percent of the letters that a misspelt key has of the one that was meant; "small" has as many as 60 of "allow"."""
_OF_AN_INTENT = {"action", "sentences", "examples", "defaults", "description", "then", "regex", "lark", "when"}
"""Keys of an intent that nobody calls an intent."""
_SECTIONS = ("slots", "phrases", "intents")
"""Of a grammar, with names that somebody gave."""


@lru_cache(maxsize=8)
def _validator(text: str) -> Validator:
    import json

    from jsonschema import Draft202012Validator

    return Draft202012Validator(json.loads(text))


def schema_problems(source: YamlSource, schema: dict[str, Any]) -> list[Problem]:
    """Check ``source.data`` against a schema.

    Returns:
        The problems, with file, line and column, in the order of the file. What they are about is noted in
        ``source.broken``, so that the rest of the file can still be read.
    """
    if surely_valid(source.data, schema):
        return []
    import json

    found: list[Problem] = []
    for error in _validator(json.dumps(schema, sort_keys=True)).iter_errors(source.data):
        found.extend(_problems(source, error))
    return sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0))


def _problems(source: YamlSource, error: ValidationError) -> Iterable[Problem]:
    path = tuple(error.absolute_path)
    name = _name(path)
    wanted: Any = error.validator_value
    schema: Any = error.schema
    instance: Any = error.instance
    broken = path
    if error.validator in ("additionalProperties", "required") and (inner := _section_within(source, path, error)):
        if path not in source.broken:
            source.broken.add(path)
            yield inner
        return
    if error.validator == "additionalProperties" and isinstance(instance, dict):
        if _bare_values(path, instance, schema):
            source.broken |= {(*path, "type"), *((*path, key) for key in instance)}
            first = next(iter(instance))
            hint = f"put them under 'values': {{values: {{{first}: ...}}}}"
            yield _at(source, path, f"{name} has values, and no keys of a slot", hint, key=True)
            return
        for key in [key for key in instance if key not in schema.get("properties", ())]:
            source.broken.add((*path, key))
            yield _unknown_key(source, (*path, key), instance, schema)
        return
    if error.validator == "type":
        yield _wrong_type(source, path, name, wanted if isinstance(wanted, list) else [wanted], instance)
    elif error.validator == "enum":
        values = [str(value) for value in wanted]
        others = {"slots": TYPES, "intents": ACTIONS}.get(str(path[0]), {}) if path[-1:] == ("type",) else {}
        hint = meant(str(instance), others, values) or f"one of: {', '.join(values)}"
        yield _at(source, path, f"{instance!r} is not known here", hint)
    elif error.validator == "required":
        known = list(schema.get("properties", ()))
        strange = [key for key in instance if key not in known]
        for key in (key for key in wanted if key not in instance):
            slip = next((other for other in strange if _misspelt(other, key, known)), None)
            if slip is None:
                yield _at(source, path, f"{name} needs {key!r}", _missing_hint(key, path, instance), key=True)
            elif schema.get("additionalProperties") is not False:  # else that it is unknown is told of anyway
                yield _unknown_key(source, (*path, slip), instance, schema)
        if path[:1] == ("intents",) and len(path) == 2:
            broken = (*path, "action")  # the rest of it can be read
    elif error.validator == "pattern" and "array" in schema.get("type", ()):
        yield _wrong_type(source, path, name, ["array"], instance)
    elif error.validator == "pattern":
        if "propertyNames" in error.schema_path:
            broken = (*path, str(instance))
        if path and path[-1] == "language":
            yield _at(source, path, f"{instance!r} is no language code", _language_hint(str(instance)))
        else:
            hint = "letters, digits and '_', not beginning with a digit" + _as_name(str(instance))
            yield _at(source, broken, f"{instance!r} is not a name that can be used here", hint, key=True)
    elif error.validator in ("minLength", "minItems", "minProperties"):
        yield _at(source, path, f"{name} is empty", "write something, or remove it")
    elif error.validator in ("minimum", "maximum"):
        most = "at least" if error.validator == "minimum" else "at most"
        part = error.validator == "maximum" and wanted == 1 and 1 < instance <= 100
        bounds = [str(schema[key]) for key in ("minimum", "maximum") if key in schema]
        less = f"it is a part of one: {instance / 100:g}" if part else f"write a number {' to '.join(bounds)}"
        yield _at(source, path, f"{name} must be {most} {wanted}, not {instance}", less)
    elif error.validator == "exclusiveMinimum":
        yield _at(source, path, f"{name} must be more than {wanted}, not {instance}")
    else:
        yield _at(source, path, error.message)
    source.broken.add(broken)


def _name(path: tuple[Any, ...]) -> str:
    """What a person would call the value at a path."""
    if not path:
        return "the file"
    if isinstance(path[-1], int):
        owner = next((part for part in reversed(path) if isinstance(part, str)), "the file")
        return f"entry {path[-1] + 1} of {owner!r}"
    return repr(path[-1])


def _bare_values(path: tuple[Any, ...], instance: dict[Any, Any], schema: Any) -> bool:
    """Whether a slot is a mapping from values to what is said, as only its ``values`` may be: ``{small: [tiny]}``."""
    if path[:1] != ("slots",) or len(path) != 2 or not all(isinstance(said, str | list) for said in instance.values()):
        return False
    known = list(schema.get("properties", ()))
    if all(isinstance(said, list) for said in instance.values()):  # "minus" is no "min" that was misspelt
        return instance.keys().isdisjoint(known)
    return not any(did_you_mean(str(key), known, _SLIP) for key in instance)


def _unknown_key(source: YamlSource, path: tuple[Any, ...], instance: Any, schema: Any) -> Problem:
    key, known = str(path[-1]), list(schema.get("properties", ()))
    if (comma := _after_a_comma(source, path, instance)) is not None:
        return _at(source, path, f"unknown key {key!r}: the ',' before it begins a key", comma, key=True)
    if len(path) == 1 and key.startswith(("x-", ".")):  # as Compose and GitLab call what is only for anchors
        hint = "an anchor needs no place of its own: write &name where its value is first used, and *name from then on"
        return _at(source, path, f"unknown key {key!r}", hint, key=True)
    section = _section_of(instance[key], known)
    if len(path) == 1 and section is not None:
        message = f"{key!r} stands beside {section!r}, and belongs below it"
        return _at(source, path, message, f"indent it, and all of its lines, further than {section}:", key=True)
    if path[:1] == ("intents",) and len(path) == 3 and key == "slots":
        hint = (
            "slots of a sentence stand with it: {say: ..., slots: {...}}; what holds where none is said is in defaults"
        )
        return _at(source, path, "unknown key 'slots'", hint, key=True)
    if path[:1] == ("locations",):
        if key in ("z", "roll", "pitch"):
            return _at(source, path, f"unknown key {key!r}", "a place lies on the floor: leave it out", key=True)
        near = meant(key, FIELDS_OF_A_PLACE, known)
    else:
        near = meant(key, _other_keys(path, known), known)
    if near is None and len(instance) == 1 and known[:1] == ["say"]:
        value = source.raw.get(path, instance[key])
        if value == "":
            sentence = f"{{{key}}}" if _begins(source, path[:-1], "{") else f"{key}:"
            return _at(
                source, path, "YAML reads this sentence as a key without a value", f'quote it: "{sentence}"', True
            )
        return _at(
            source,
            path,
            "YAML reads this sentence as a key and its value",
            f'quote it: "{key}: {_as_written(value)}"',
            True,
        )
    return _at(source, path, f"unknown key {key!r}", near or f"known here: {', '.join(known)}", key=True)


def _other_keys(path: tuple[Any, ...], known: list[str]) -> Mapping[str, str]:
    """What other programs call the keys that may stand at a path."""
    if len(path) == 1 and "intents" in known:
        return KEYS_OF_A_GRAMMAR
    if known[:1] == ["say"]:
        return KEYS_OF_A_SENTENCE
    if len(path) == 3:
        return {"slots": KEYS_OF_A_SLOT, "intents": KEYS_OF_AN_INTENT}.get(str(path[0]), {})
    return {}


def _as_written(value: Any) -> str:
    """A value as it was written by somebody to whom braces are no YAML: ``{side}`` is a key without a value."""
    if not isinstance(value, dict):
        return str(value)
    return "{" + ", ".join(f"{key}: {one}" if one not in (None, "") else str(key) for key, one in value.items()) + "}"


def _after_a_comma(source: YamlSource, path: tuple[Any, ...], instance: dict[Any, Any]) -> str | None:
    """What to write where a "," in braces was to part a value, and not two keys: ``{x: 1,5}``, ``{aliases: a, b}``;
    None: it parts keys."""
    *above, key = path
    here = source.place(path, key=True)
    if here.source[: here.column - 1].rstrip()[-1:] != ",":
        return None
    keys = list(instance)
    raw = {each: source.raw.get((*above, each), instance[each]) for each in keys}
    at = next(index for index, each in enumerate(keys) if str(each) == str(key))
    first = next((index for index in range(at, -1, -1) if raw[keys[index]] not in ("", None)), at)
    value = raw[keys[first]]
    if at == first or not isinstance(value, str | int | float):
        return None
    if str(key).isdigit() and str(value).lstrip("+-").isdigit():
        return f"a number has a point: {value}.{key}"
    last = next((index for index in range(at, len(keys)) if raw[keys[index]] not in ("", None)), len(keys))
    return f"write it as a list: {keys[first]}: [{', '.join(map(str, (value, *keys[first + 1 : last])))}]"


def _section_within(source: YamlSource, path: tuple[Any, ...], error: ValidationError) -> Problem | None:
    """The problem of a section of a grammar that stands in another, as ``slots`` below ``intents``; None: it is none,
    or may be a slot or an intent of that name."""
    if len(path) != 2 or path[0] not in _SECTIONS or path[1] not in _SECTIONS or not isinstance(error.instance, dict):
        return None
    if not all(isinstance(one, dict | list | str) for one in error.instance.values()) or "type" in error.instance:
        return None
    message = f"{path[1]!r} stands below {path[0]!r}, and belongs beside it"
    return _at(source, path, message, f"indent it, and all of its lines, as far as {path[0]}:", key=True)


def _section_of(value: Any, known: list[str]) -> str | None:
    """The section of a grammar or map to which a mapping belongs by its keys; None for any other value or file."""
    if isinstance(value, dict) and "locations" in known and {"x", "y"} <= value.keys():
        return "locations"
    if not isinstance(value, dict) or "intents" not in known:
        return None
    if "action" in value or "sentences" in value:
        return "intents"
    return "slots" if "type" in value else None


def _begins(source: YamlSource, path: tuple[Any, ...], sign: str) -> bool:
    """Whether a value is written with this sign in front."""
    place = source.place(path)
    return place.source[place.column - 1 : place.column] == sign


def _misspelt(strange: Any, key: str, known: list[str]) -> bool:
    """Whether an unknown key is probably the missing one; it has been told of already."""
    return did_you_mean(str(strange), known) == did_you_mean(key, [key]) or known[:1] == ["say"]


def _missing_hint(key: str, path: tuple[Any, ...], instance: dict[Any, Any]) -> str | None:
    if key == "type" and path[-1:] == ("action",) and "name" in instance:
        return f"for your own: action: {{type: custom, name: {instance['name']}}}"
    if path[:1] == ("locations",):
        return "a place is {x: 5.0, y: 2.0, yaw: 0.0}, in m and rad"
    if path[-2:-1] == ("when",):
        return "- {slots: {name: value}, defaults: {name: value}}"
    if key == "tests":
        return 'tests: ["go left": {direction: left}, "go up": rejected]'
    if key == "name" and not path:
        return "what the robot is called: name: my_robot"
    if key == "say":
        return '- {say: "sentence", slots: {name: value}}'
    if key == "action":
        return "one of: move, turn, stop, navigate, pick, place; or for your own: action: {type: custom, name: ...}"
    return None


def _language_hint(given: str) -> str:
    near = code_of(given)
    return f"write {near}" if near else "two letters, as en or de"


def _as_name(given: str) -> str:
    name = re.sub(r"\W+", "_", given.strip()).strip("_")
    return f": {name}" if name and not name[0].isdigit() and name.isascii() else ""


def _wrong_type(source: YamlSource, path: tuple[Any, ...], name: str, wanted: list[str], instance: Any) -> Problem:
    raw = source.raw.get(path)
    message = f"{name} must be {' or '.join(_WORDS[kind] for kind in wanted)}"
    if len(path) == 4 and (path[0], path[2]) == ("slots", "units") and type(instance) in (int, float):
        return _at(source, path, f"the size of {name} stands behind it", f"write it before: {{{raw}: [{path[3]}]}}")
    if raw is not None and "string" in wanted:
        if raw.lower() in YAML_BOOLEANS:
            message = f"YAML reads {raw} as {str(instance).lower()}, not as a word"
        sign = "-" if path and isinstance(path[-1], int) else ":"
        return _at(source, path, message, f'quote it: "{raw}"' if raw else f"something is missing after the {sign!r}")
    hint = "write lines of the form  key: value" if not path else None
    if path[:1] == ("intents",) and len(path) == 2 and path[1] in _OF_AN_INTENT:
        return _at(source, path, f"{name} stands where an intent's name stands", "indent it below the intent", key=True)
    if path[:1] == ("locations",) and (pose := pose_otherwise(path, instance)) is not None:
        hint = pose
    elif (meaning := values_otherwise(path, instance)) is not None:
        hint = meaning
    elif "array" in wanted and isinstance(instance, dict) and ("say" in instance or "string" not in wanted):
        hint = "write it as a list: begin it with '- ', or put [ ] around it"
    elif "string" in wanted and isinstance(instance, list) and _begins(source, path, "-"):
        hint = "one '-' is enough for each"
    elif "string" in wanted and _begins(source, path, "[") and isinstance(path[-1], int):
        hint = f'quote it: "[{", ".join(map(str, instance))}]"'
    elif "string" in wanted and isinstance(instance, dict) and len(instance) == 1 and _begins(source, path, "{"):
        hint = f'quote it: "{_as_written(instance)}"'
    elif "object" in wanted and isinstance(instance, list) and path:
        hint = "write each as a line  name: ...  without a '-' or brackets"
    elif "number" in wanted and "string" not in wanted and isinstance(instance, str):
        hint = in_si(instance, share=path[-1:] == ("min_confidence",))
    else:
        hint = hint or plainer(path, wanted, instance)
    if raw == "":
        hint = "something is missing after the ':'"
    elif "array" in wanted and isinstance(instance, str) and instance.startswith("-"):
        hint = "a blank belongs behind each '-'"
    elif "array" in wanted and isinstance(instance, str) and path[:1] == ("locations",):
        hint = f"write it as a list: {as_list(instance)}"
    elif "array" in wanted and isinstance(instance, str):
        short = len(instance) < 30 and "\n" not in instance
        hint = f"write it as a list: [{instance}]" if short else "write each on a line that begins with -"
    return _at(source, path, message, hint)


def _at(source: YamlSource, path: tuple[Any, ...], message: str, hint: str | None = None, key: bool = False) -> Problem:
    place = source.place(path, key=key)
    return Problem(message, source.file, place.line, place.column, place.source, hint)
