"""What other programs call the keys of a grammar, of an intent, of a sentence, the types and keys of slots, the actions
and the fields of a place, and their names here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from intent_engine.hints import did_you_mean

__all__ = [
    "ACTIONS",
    "FIELDS_OF_A_PLACE",
    "KEYS_OF_AN_INTENT",
    "KEYS_OF_A_GRAMMAR",
    "KEYS_OF_A_SENTENCE",
    "KEYS_OF_A_SLOT",
    "TYPES",
    "meant",
]

TYPES: Mapping[str, str] = {
    **dict.fromkeys(("int", "integer", "count"), "number, with whole: true"),
    **dict.fromkeys(("float", "double", "real", "decimal", "temperature", "numeric"), "number"),
    **dict.fromkeys(("str", "string", "word", "words", "any"), "text"),
    **dict.fromkeys(("list", "enum", "literal", "options", "color", "colour"), "choice, with values: [one, another]"),
    **dict.fromkeys(("place", "waypoint", "room", "pose"), "location"),
    **dict.fromkeys(("length", "meters", "metres"), "distance"),
    **dict.fromkeys(("time", "seconds"), "duration"),
    **dict.fromkeys(("velocity", "linear_velocity"), "speed"),
    **dict.fromkeys(("angular_velocity", "turn_speed"), "angular_speed"),
    **dict.fromkeys(("degrees", "yaw", "rotation"), "angle"),
    **dict.fromkeys(("percentage", "fraction"), "percent"),
    **dict.fromkeys(("bool", "onoff", "switch"), "boolean"),
}
KEYS_OF_A_GRAMMAR: Mapping[str, str] = {
    **dict.fromkeys(("lists", "entities", "types"), "slots: {name: [one, another]}"),
    **dict.fromkeys(("expansion_rules", "macros", "rules", "aliases"), "phrases: {name: template}"),
    **dict.fromkeys(("skip_words", "stopwords", "ignore"), "fillers: [please, uh]"),
    **dict.fromkeys(("responses", "speech"), "no part of a grammar: what the robot says is your program's"),
    **dict.fromkeys(("imports", "extends"), "include: [file.yaml]"),
    **dict.fromkeys(("lang", "locale"), "language"),
}
KEYS_OF_AN_INTENT: Mapping[str, str] = {
    **dict.fromkeys(
        ("data", "utterances", "expressions", "patterns", "phrases", "samples", "templates"), "sentences: [template]"
    ),
    **dict.fromkeys(("requires_context", "context"), "requires: [state]"),
    **dict.fromkeys(("excludes_context",), "excludes: [state]"),
    **dict.fromkeys(("tests",), "examples"),
}
KEYS_OF_A_SENTENCE: Mapping[str, str] = {
    **dict.fromkeys(("sentences", "sentence", "text", "template", "utterance"), "say: template, one for each entry"),
    **dict.fromkeys(("requires_context", "requires", "context"), "requires: [state] of the whole intent"),
    **dict.fromkeys(("excludes_context", "excludes"), "excludes: [state] of the whole intent"),
    **dict.fromkeys(("response",), "no part of a grammar: what the robot says is your program's"),
}
KEYS_OF_A_SLOT: Mapping[str, str] = {
    **dict.fromkeys(("options", "choices", "enum", "items", "synonyms"), "values"),
    **dict.fromkeys(("lower", "ge", "from"), "min"),
    **dict.fromkeys(("upper", "le", "to"), "max"),
    **dict.fromkeys(("range", "limits", "bounds", "between"), "min and max"),
    **dict.fromkeys(("integer", "int"), "whole: true"),
    **dict.fromkeys(("wildcard",), "type: text"),
    **dict.fromkeys(("step", "resolution", "increment"), "usual_step"),
    **dict.fromkeys(("default", "defaults"), "defaults: {name: value} of the intent"),
}
ACTIONS: Mapping[str, str] = {
    **dict.fromkeys(("drive", "go", "cmd_vel", "forward", "backward"), "move"),
    **dict.fromkeys(("rotate", "spin", "left", "right"), "turn"),
    **dict.fromkeys(("goto", "go_to", "navigation", "navigate_to_pose", "nav2"), "navigate"),
    **dict.fromkeys(("grab", "grasp", "take", "pick_up"), "pick"),
    **dict.fromkeys(("put", "drop", "put_down"), "place"),
    **dict.fromkeys(("halt", "cancel", "emergency_stop"), "stop"),
}
FIELDS_OF_A_PLACE: Mapping[str, str] = {
    **dict.fromkeys(("theta", "heading", "angle", "th", "yaw_rad"), "yaw, in rad"),
    **dict.fromkeys(("yaw_deg", "degrees", "deg", "theta_deg"), "yaw, in rad: 90 degrees are 1.5708"),
    **dict.fromkeys(("frame_id",), "frame"),
    **dict.fromkeys(("position", "coordinates", "coords", "pos"), "x and y, in m"),
    **dict.fromkeys(("orientation", "quaternion", "quat", "qw", "qx", "qy", "qz"), "yaw, in rad"),
}


def meant(word: str, others: Mapping[str, str], known: Iterable[str]) -> str | None:
    """A hint what an unknown word is called here, or which known one is spelled like it; None if none is."""
    other = others.get(word.lower())
    return f"that is {other}" if other else did_you_mean(word, known)
