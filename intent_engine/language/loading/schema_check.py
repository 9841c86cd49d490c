"""Whether a file that is right is right, by its JSON Schema.

Loading ``jsonschema`` takes as long as reading a grammar, and nearly every file that is loaded has no mistake. This
knows the keywords that our schemas are made of and says yes where it is sure; for all else, a mistake or a keyword that
it does not know, ``jsonschema`` has the word (see :mod:`~intent_engine.language.loading.schema_problems`). Both read
the same schema, and agree (a property in the tests).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

__all__ = ["surely_valid"]

Schema = Mapping[str, Any]


def surely_valid(data: Any, schema: Schema) -> bool:
    """Whether data holds to a schema; also False where that cannot be told here.

    Args:
        data: as JSON or YAML give it: dict, list, str, int, float, bool, None.
        schema: of draft 2020-12, with ``$ref`` only to its own ``$defs``, and these not in a circle.
    """
    return _valid(data, schema, schema.get("$defs", {}))


def _valid(data: Any, schema: Any, definitions: Schema) -> bool:
    if not isinstance(schema, dict):
        return False
    for keyword, wanted in schema.items():
        check = _CHECKS.get(keyword)
        if check is None or not check(data, wanted, schema, definitions):
            return False
    return True


def _type(data: Any, wanted: Any, _schema: Schema, _definitions: Schema) -> bool:
    kinds = wanted if isinstance(wanted, list) else (wanted,)
    return any(kind in _TYPES and _TYPES[kind](data) for kind in kinds)


def _whole(data: Any) -> bool:
    return isinstance(data, int) or (isinstance(data, float) and data.is_integer())


_TYPES: Mapping[str, Callable[[Any], bool]] = {
    "string": lambda data: isinstance(data, str),
    "object": lambda data: isinstance(data, dict),
    "array": lambda data: isinstance(data, list),
    "boolean": lambda data: isinstance(data, bool),
    "number": lambda data: isinstance(data, (int, float)) and not isinstance(data, bool),
    "integer": lambda data: _whole(data) and not isinstance(data, bool),
}


def _reference(data: Any, wanted: Any, _schema: Schema, definitions: Schema) -> bool:
    head, name = wanted[:8], wanted[8:]
    return head == "#/$defs/" and name in definitions and _valid(data, definitions[name], definitions)


def _properties(data: Any, wanted: Any, _schema: Schema, definitions: Schema) -> bool:
    if not isinstance(data, dict):
        return True
    return all(_valid(value, wanted[key], definitions) for key, value in data.items() if key in wanted)


def _others(data: Any, wanted: Any, schema: Schema, definitions: Schema) -> bool:
    """``additionalProperties``; beside it our schemas have no ``patternProperties``."""
    if not isinstance(data, dict):
        return True
    known = schema.get("properties", ())
    if wanted is False:
        return all(key in known for key in data)
    return all(_valid(value, wanted, definitions) for key, value in data.items() if key not in known)


def _names(data: Any, wanted: Any, _schema: Schema, definitions: Schema) -> bool:
    return not isinstance(data, dict) or all(_valid(key, wanted, definitions) for key in data)


def _items(data: Any, wanted: Any, _schema: Schema, definitions: Schema) -> bool:
    return not isinstance(data, list) or all(_valid(item, wanted, definitions) for item in data)


def _enumerated(data: Any, wanted: Any, _schema: Schema, _definitions: Schema) -> bool:
    return isinstance(data, str) and data in wanted


def _number(data: Any) -> bool:
    return isinstance(data, (int, float)) and not isinstance(data, bool)


def _remark(_data: Any, _wanted: Any, _schema: Schema, _definitions: Schema) -> bool:
    return True


_CHECKS: Mapping[str, Callable[[Any, Any, Schema, Schema], bool]] = {
    "$schema": _remark,
    "$id": _remark,
    "$defs": _remark,
    "title": _remark,
    "description": _remark,
    "type": _type,
    "$ref": _reference,
    "properties": _properties,
    "additionalProperties": _others,
    "propertyNames": _names,
    "items": _items,
    "enum": _enumerated,
    "required": lambda data, wanted, *_: not isinstance(data, dict) or all(key in data for key in wanted),
    "pattern": lambda data, wanted, *_: not isinstance(data, str) or re.search(wanted, data) is not None,
    "minLength": lambda data, wanted, *_: not isinstance(data, str) or len(data) >= wanted,
    "minItems": lambda data, wanted, *_: not isinstance(data, list) or len(data) >= wanted,
    "minimum": lambda data, wanted, *_: not _number(data) or not data < wanted,
    "maximum": lambda data, wanted, *_: not _number(data) or not data > wanted,
}
