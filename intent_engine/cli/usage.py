"""What is wrong with the options of a command line, told as every other error is."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import typer

from intent_engine.errors import Problem
from intent_engine.hints import did_you_mean

__all__ = ["NAME", "UsageError", "usage_problem"]

NAME = "intent-engine"

FILE_OPTIONS = ("--audio", "--file", "--input", "--recording", "--sound", "--wav")
"""By which other programs are given what is the argument of a verb here."""

UsageError: type[Exception] = next(kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "ClickException")
"""What Click raises. Some releases of Typer bring a Click of their own, so it is not imported, and told by names."""


def usage_problem(error: Any, verb: str = "", example: str = "") -> Problem | None:
    """What a person is told of an error of Click; None where the help was shown instead.

    Args:
        error: that Click raised.
        verb: whose options are wrong; empty: they stand before it.
        example: of the verb.
    """
    kind = type(error).__name__
    if kind == "NoArgsIsHelpError":
        return None
    hints = []
    context, parameter = getattr(error, "ctx", None), getattr(error, "param", None)
    message = error.format_message().rstrip(".")
    if kind == "NoSuchOption":
        message = f"there is no option {error.option_name}"
        hints = [_meant(error.option_name, context)]
    elif message == "Missing command":
        message = "the verb is missing"
        hints = [f"there is {', '.join(context.command.list_commands(context))}"] if context is not None else []
    elif kind == "BadOptionUsage":
        value = "takes no value" if "not take" in message else "needs a value"
        message = f"{error.option_name} {value}"
    elif kind == "MissingParameter" and parameter is not None:
        message = f"{_named(parameter)} is missing"
        hints = [_lower(getattr(parameter, "help", None) or ""), f"as in: {example}" if example else ""]
    elif kind == "BadParameter" and parameter is not None:
        message = f"{_named(parameter)}: {_refused(error.message.rstrip('.'), parameter.type)}"
        hints = [_wanted(parameter.type)]
    elif found := re.search(r"extra arguments?(?:\(s\))? \((.*)\)$", message):
        message = f"{found[1]!r} is too much"
        parameters = context.command.params if context is not None else ()
        takes = any(one.param_type_name == "argument" for one in parameters)
        hints = [_quoted(context, example) if takes else f"{verb} takes options alone"]
        if not takes and found[1].endswith((".yaml", ".yml")) and any("--grammar" in one.opts for one in parameters):
            hints = [f"a grammar is an option here: {NAME} {verb} --grammar {found[1]}"]
    hints.append(f"{NAME} {verb} --help".replace("  ", " ") + " tells all of it")
    return Problem(message, hint="\n    ".join(filter(None, hints)))


def _named(parameter: Any) -> str:
    """An option by its long name; an argument as the help shows it."""
    if parameter.param_type_name == "option":
        return str(max(parameter.opts, key=len))
    return str(getattr(parameter, "metavar", None) or parameter.name).upper()


def _quoted(context: Any, example: str) -> str:
    """What to do about an argument too many, of a verb that takes one sentence or one file."""
    quotes = "put words that belong together in quotes"
    if not any(_names_file(one) for one in context.command.params if one.param_type_name == "argument"):
        return f"{quotes}: {example}"
    return "give one path; in quotes, if it has spaces"


def _names_file(parameter: Any) -> bool:
    return str(getattr(parameter.type, "name", "")) in ("path", "file", "directory")


def _meant(option: str, context: Any) -> str:
    """The option that was meant, or where this one stands."""
    if context is None:
        return ""
    if context.parent is not None and option in _options(context.parent):
        return f"it stands before the verb: {NAME} {option} {context.info_name}"
    verbs = context.parent.command if context.parent is not None else context.command
    if having := [name for name in verbs.list_commands(context) if option in _options_of(verbs.commands[name])]:
        if context.parent is None:
            return f"it stands after the verb: {NAME} {having[0]} {option}"
        return f"it is an option of {' and '.join(having)}"
    files = [one for one in context.command.params if one.param_type_name == "argument" and _names_file(one)]
    if option in FILE_OPTIONS and files:
        return f"the path stands without an option: {NAME} {context.info_name} {_named(files[0])}"
    return did_you_mean(option, _options(context)) or ""


def _options(context: Any) -> Iterator[str]:
    return _options_of(context.command)


def _options_of(command: Any) -> Iterator[str]:
    for parameter in command.params:
        if parameter.param_type_name == "option":
            yield from (*parameter.opts, *parameter.secondary_opts)


def _refused(message: str, kind: Any) -> str:
    value, refused, why = message.partition(" is not ")
    if not refused or not _number(kind):
        return message
    return f"{value} is out of range" if "in the range" in why else f"{value} is no {_number(kind)}"


def _wanted(kind: Any) -> str:
    """What values an option takes."""
    number = _number(kind)
    least, most = getattr(kind, "min", None), getattr(kind, "max", None)
    if not number:
        return ""
    if most is not None:
        return f"give a {number} from {least} to {most}"
    return f"give a {number}" + (f", {least} or more" if least is not None else "")


def _number(kind: Any) -> str:
    return {"int": "whole number", "flo": "number"}.get(kind.name[:3], "")


def _lower(text: str) -> str:
    return (text[:1].lower() + text[1:]).rstrip(".")
