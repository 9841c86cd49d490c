"""Weights out of a model file of CTranslate2."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst

from intent_engine.speech.acoustic.ctranslate2_file import read_variables
from intent_engine.speech.weights import find_weights

KINDS = {"float32": 0, "int8": 1, "int16": 2, "int32": 3, "float16": 4}
arrays = st.sampled_from(sorted(KINDS)).flatmap(
    lambda kind: npst.arrays(kind, npst.array_shapes(min_dims=0, max_dims=3, max_side=4))
)
names = st.text("abc_/0123", min_size=1, max_size=8)


def text(value: str) -> bytes:
    return struct.pack("<H", len(value) + 1) + value.encode() + b"\0"


def written(variables: dict[str, npt.NDArray[np.generic]], version: int = 6) -> bytes:
    """As ``ModelSpec.save`` writes it."""
    data = struct.pack("<I", version) + text("WhisperSpec") + struct.pack("<II", 3, len(variables))
    for name, value in variables.items():
        data += text(name) + struct.pack(f"<B{value.ndim}I", value.ndim, *value.shape)
        data += struct.pack("<BI", KINDS[value.dtype.name], value.nbytes) + value.tobytes()
    return data + struct.pack("<I", 0)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("model") / "model.bin"


@given(st.dictionaries(names, arrays, max_size=4), st.sampled_from(["", "a", "ab/"]))
def test_what_was_written_is_read(path: Path, variables: dict[str, npt.NDArray[np.generic]], prefix: str) -> None:
    path.unlink(missing_ok=True)
    path.write_bytes(written(variables))
    found = read_variables(path, prefix)
    wanted = {name.removeprefix(prefix): value for name, value in variables.items() if name.startswith(prefix)}
    assert found.keys() == wanted.keys()
    for name, value in wanted.items():
        assert found[name].dtype == value.dtype
        np.testing.assert_array_equal(found[name], value)


@given(st.data())
def test_a_file_that_was_cut_is_refused(path: Path, data: st.DataObject) -> None:
    whole = written({"a": np.zeros((2, 3), np.float32), "b": np.zeros(4, np.float16)})
    path.unlink(missing_ok=True)
    path.write_bytes(whole[: data.draw(st.integers(1, len(whole) - 5))])
    with pytest.raises(ValueError, match="model of CTranslate2"):
        read_variables(path, "")


def test_another_version_is_refused(path: Path) -> None:
    path.unlink(missing_ok=True)
    path.write_bytes(written({}, version=7))
    with pytest.raises(ValueError, match="version 7, not 6"):
        read_variables(path, "")


def test_the_real_file() -> None:
    variables = read_variables(find_weights("tiny.en").path / "model.bin", "decoder/")
    assert variables["embeddings/weight"].shape == (51864, 384)
    assert int(variables["num_heads"]) == 6
