"""What is said for an angle or a speed without a number: "about face", "half speed"."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

__all__ = ["RELATIVE_SPEEDS", "WHOLE_ANGLES", "Relative"]


@dataclass(frozen=True, slots=True)
class Relative:
    """A speed that was said in terms of the usual one: "half speed", "slowly"."""

    factor: float


RELATIVE_SPEEDS: Mapping[str, Mapping[str, float]] = {
    "en": {
        "slowly": 0.5, "slow": 0.5, "slower": 0.5, "gently": 0.5, "carefully": 0.5, "very slowly": 0.25,
        "at a crawl": 0.25, "really slowly": 0.25, "slowly and carefully": 0.5, "quickly": 1.5, "fast": 1.5,
        "faster": 1.5, "rapidly": 1.5, "very fast": 2.0, "very quickly": 2.0, "half speed": 0.5,
        "half the speed": 0.5, "half your speed": 0.5, "quarter speed": 0.25, "a quarter speed": 0.25,
        "full speed": 2.0, "top speed": 2.0, "maximum speed": 2.0, "normal speed": 1.0, "normally": 1.0,
        "the usual speed": 1.0, "twice the speed": 2.0, "twice as fast": 2.0, "double the speed": 2.0,
        "double speed": 2.0, "half as fast": 0.5, "low speed": 0.5, "slow speed": 0.5, "high speed": 1.5,
    },
    "de": {
        "langsam": 0.5, "langsamer": 0.5, "vorsichtig": 0.5, "ganz langsam": 0.25, "sehr langsam": 0.25, "schnell": 1.5,
        "schneller": 1.5, "sehr schnell": 2.0, "halber geschwindigkeit": 0.5, "halbe geschwindigkeit": 0.5,
        "halbem tempo": 0.5, "halbes tempo": 0.5, "voller geschwindigkeit": 2.0, "volle geschwindigkeit": 2.0,
        "vollem tempo": 2.0, "normaler geschwindigkeit": 1.0, "normalem tempo": 1.0, "doppelter geschwindigkeit": 2.0,
        "doppeltem tempo": 2.0, "geringer geschwindigkeit": 0.5, "niedriger geschwindigkeit": 0.5,
        "hoher geschwindigkeit": 1.5, "hohem tempo": 1.5,
    },
}  # fmt: skip
"""Words for speeds, by language, as factors of the usual speed. Modest on purpose: limits of the robot file still
hold."""

WHOLE_ANGLES: Mapping[tuple[str, ...], float] = {
    ("all", "the", "way", "around"): 2 * math.pi,
    ("all", "the", "way", "round"): 2 * math.pi,
    ("a", "full", "circle"): 2 * math.pi,
    ("full", "circle"): 2 * math.pi,
    ("completely", "around"): 2 * math.pi,
    ("about", "face"): math.pi,
    ("an", "about", "face"): math.pi,
    ("half", "way", "around"): math.pi,
    ("halfway", "around"): math.pi,
    ("half", "way", "round"): math.pi,
    ("halfway", "round"): math.pi,
    ("a", "u", "turn"): math.pi,
    ("u", "turn"): math.pi,
}
