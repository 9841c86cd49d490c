"""Microphones as PortAudio sees them, and what to do where it sees none."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from intent_engine.errors import DeviceError

__all__ = ["InputDevice", "choose", "hint_for_no_microphone", "hint_for_permission", "list_devices", "portaudio"]


@dataclass(frozen=True, slots=True)
class InputDevice:
    """A microphone."""

    index: int
    """PortAudio's number of it; changes when something is plugged in."""
    name: str
    channels: int
    rate: int
    """Hz that it runs at by itself."""
    interface: str
    """ALSA, PulseAudio, Core Audio, WASAPI, ..."""
    default: bool = False


def portaudio() -> Any:
    """The sounddevice module, with PortAudio loaded.

    Raises:
        DeviceError: there is no PortAudio; says what to install.
    """
    try:
        import sounddevice
    except (OSError, ImportError) as error:
        raise DeviceError(
            f"PortAudio is not there, so no microphone can be heard ({error})\n    {_install()}"
        ) from None
    return sounddevice


def list_devices() -> tuple[InputDevice, ...]:
    """The microphones that there are, by PortAudio's number.

    Raises:
        DeviceError: there is no PortAudio, or it cannot tell.
    """
    sd = portaudio()
    found = []
    default = _default_input(sd)
    try:
        for index, device in enumerate(sd.query_devices()):
            if device["max_input_channels"] > 0:
                found.append(_device(sd, index, device, default))
    except sd.PortAudioError as error:  # as of a sound server that has just ended
        raise DeviceError(f"the microphones cannot be listed: {error}\n    {hint_for_permission()}") from None
    return tuple(found)


def choose(device: int | str | None = None) -> InputDevice:
    """The microphone that is meant.

    Args:
        device: its number, its name or a part of it; None: the system's default.

    Raises:
        DeviceError: there is none, or several; lists those that there are.
    """
    there = list_devices()
    if not there:
        raise DeviceError(f"there is no microphone\n    {hint_for_no_microphone()}")
    if device is None:
        return next((one for one in there if one.default), there[0])
    text = str(device).strip()
    if text.isdecimal():
        found = [one for one in there if one.index == int(text)]
    else:
        found = [one for one in there if one.name.casefold() == text.casefold()]
        found = found or [one for one in there if text.casefold() in one.name.casefold()]
    if len({one.name for one in found}) == 1:  # the same microphone through several interfaces: the first serves
        return found[0]
    listed = "\n".join(f"    {one.index}: {one.name} ({one.interface})" for one in found or there)
    what = f"several microphones are named like {text!r}" if found else f"there is no microphone {text!r}"
    raise DeviceError(f"{what}; choose by number or name:\n{listed}")


def _device(sd: Any, index: int, device: Any, default: int) -> InputDevice:
    return InputDevice(
        index,
        str(device["name"]),
        int(device["max_input_channels"]),
        int(device["default_samplerate"]),
        str(sd.query_hostapis(device["hostapi"])["name"]),
        index == default,
    )


def _default_input(sd: Any) -> int:
    try:
        return int(sd.default.device[0])
    except (TypeError, ValueError, IndexError, sd.PortAudioError):
        return -1


def _install() -> str:
    if sys.platform.startswith("linux"):
        return "install it: sudo apt-get install libportaudio2 (Fedora: portaudio, Arch: portaudio)"
    return "install it again with the sounddevice wheel, which brings it: pip install --force-reinstall sounddevice"


def hint_for_no_microphone() -> str:
    """What to do where no microphone is seen."""
    if sys.platform.startswith("linux"):
        if not Path("/dev/snd").exists():
            return (
                "plug one in; in a container give it the sound devices (docker run --device /dev/snd ...),\n"
                "    or pipe sound in from elsewhere: arecord -f S16_LE -r 16000 -t raw | intent-engine listen --pcm -"
            )
        return f"plug one in; arecord -l lists those that the system knows. {hint_for_permission()}"
    return f"plug one in. {hint_for_permission()}"


def hint_for_permission() -> str:
    """How this system lets a program use the microphone."""
    if sys.platform == "darwin":
        return (
            "Allow it: System Settings > Privacy & Security > Microphone, switch on your terminal, and start it again"
        )
    if sys.platform == "win32":
        return "Allow it: Settings > Privacy & security > Microphone, let desktop apps access it"
    if may_not_use_sound():
        return "This user may not use it: sudo usermod -aG audio $USER, then log in again"
    return "If another program holds it, close that; this user may use the sound devices"


def may_not_use_sound(folder: Path = Path("/dev/snd")) -> bool:
    """Whether there are sound devices that this user may not read (Linux)."""
    devices = list(folder.glob("pcmC*c")) if folder.is_dir() else []
    return bool(devices) and not any(os.access(device, os.R_OK) for device in devices)
