"""Options that belong together, as one dataclass: a verb takes the dataclass, the command line its fields."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import get_type_hints

__all__ = ["grouped"]


def grouped(function: Callable[..., int | None]) -> Callable[..., int | None]:
    """Let Typer see the fields of each parameter that is a dataclass, in its place and with their defaults."""
    hints = get_type_hints(function, include_extras=True)
    groups: dict[str, tuple[Callable[..., object], list[str]]] = {}
    shown: list[inspect.Parameter] = []
    for parameter in inspect.signature(function).parameters.values():
        kind = hints[parameter.name]
        if not (isinstance(kind, type) and is_dataclass(kind)):
            shown.append(parameter.replace(kind=parameter.KEYWORD_ONLY, annotation=kind))
            continue
        kinds = get_type_hints(kind, include_extras=True)
        groups[parameter.name] = (kind, [field.name for field in fields(kind)])
        shown += [
            inspect.Parameter(field.name, parameter.KEYWORD_ONLY, default=field.default, annotation=kinds[field.name])
            for field in fields(kind)
        ]

    @functools.wraps(function)
    def ungrouped(**options: object) -> int | None:
        given = {name: make(**{field: options.pop(field) for field in names}) for name, (make, names) in groups.items()}
        return function(**options, **given)

    ungrouped.__signature__ = inspect.Signature(shown)  # type: ignore[attr-defined]
    ungrouped.__annotations__ = {parameter.name: parameter.annotation for parameter in shown}
    return ungrouped
