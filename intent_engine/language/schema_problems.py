"""What JSON Schema finds wrong in a file, in words for the person who wrote it."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from intent_engine.errors import Problem
from intent_engine.language.yaml_source import YamlSource, did_you_mean

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
}
_YAML_BOOLEANS = {"yes", "no", "on", "off", "true", "false"}


@lru_cache(maxsize=8)
def _validator(identity: str, text: str) -> Validator:
    import json

    from jsonschema import Draft202012Validator

    return Draft202012Validator(json.loads(text))


def schema_problems(source: YamlSource, schema: dict[str, Any]) -> list[Problem]:
    """Check ``source.data`` against a schema; the problems carry file, line and column."""
    import json

    found: list[Problem] = []
    for error in _validator(str(schema.get("$id")), json.dumps(schema, sort_keys=True)).iter_errors(source.data):
        found.extend(_problems(source, error))
    return sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0))


def _problems(source: YamlSource, error: ValidationError) -> Iterable[Problem]:
    path = tuple(error.absolute_path)
    where = path[-1] if path else "the file"
    wanted: Any = error.validator_value
    schema: Any = error.schema
    instance: Any = error.instance
    if error.validator == "additionalProperties" and isinstance(instance, dict):
        known = list(schema.get("properties", ()))
        for key in instance:
            if key not in known:
                hint = did_you_mean(str(key), known) or f"known here: {', '.join(known)}"
                yield _at(source, (*path, key), f"unknown key {key!r}", hint, key=True)
    elif error.validator == "type":
        yield _wrong_type(source, path, where, wanted if isinstance(wanted, list) else [wanted], instance)
    elif error.validator == "enum":
        values = [str(value) for value in wanted]
        hint = did_you_mean(str(instance), values) or f"one of: {', '.join(values)}"
        yield _at(source, path, f"{instance!r} is not known here", hint)
    elif error.validator == "required":
        missing = [key for key in wanted if key not in instance]
        yield _at(source, path, f"{where!r} needs {' and '.join(repr(key) for key in missing)}", None, key=True)
    elif error.validator == "pattern":
        at = (*path, str(instance)) if "propertyNames" in error.schema_path else path
        hint = "letters, digits and '_', not beginning with a digit"
        if where == "language":
            hint = "two letters, as en or de"
        yield _at(source, at, f"{instance!r} is not a name that can be used here", hint, key=True)
    elif error.validator in ("minLength", "minItems"):
        yield _at(source, path, f"{where!r} is empty", "write something, or remove it")
    else:
        yield _at(source, path, error.message)


def _wrong_type(source: YamlSource, path: tuple[Any, ...], where: Any, wanted: list[str], instance: Any) -> Problem:
    raw = source.raw.get(path)
    message = f"{where!r} must be {' or '.join(_WORDS[kind] for kind in wanted)}"
    if raw is not None and raw.lower() in _YAML_BOOLEANS and "string" in wanted:
        message = f"YAML reads {raw} as {str(instance).lower()}, not as a word"
        return _at(source, path, message, f'quote it: "{raw}"')
    if raw is not None and "string" in wanted:
        return _at(source, path, message, f'quote it: "{raw}"' if raw else "something is missing after the ':'")
    return _at(source, path, message)


def _at(source: YamlSource, path: tuple[Any, ...], message: str, hint: str | None = None, key: bool = False) -> Problem:
    place = source.place(path, key=key)
    return Problem(message, source.file, place.line, place.column, place.source, hint)
