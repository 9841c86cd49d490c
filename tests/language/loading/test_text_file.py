"""Files that somebody names by mistake: devices without an end, and paths that no file has."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from intent_engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.language.loading.text_file import text_of

ZERO = Path("/dev/zero")


@pytest.fixture(params=["grammar", "map", "table", "robot"])
def read(request):
    """Reads a path as one kind of file."""
    ways = {
        "grammar": IntentEngine.from_files,
        "map": lambda path: IntentEngine.from_files("en", locations=path),
        "table": lambda path: IntentEngine.from_files("en", locations=f"{path}.csv"),
        "robot": load_robot,
    }
    return ways[request.param]


def test_a_device_without_an_end_is_too_large(read, tmp_path) -> None:
    link = tmp_path / "endless.yaml"
    link.symlink_to(ZERO)
    (tmp_path / "endless.yaml.csv").symlink_to(ZERO)
    with pytest.raises(ConfigError, match=r"is larger than 64 MiB\n    is this the right file\?"):
        read(str(link))


@pytest.mark.parametrize("name", ["room/a\0b.yaml", "a\ud800b.yaml"])
def test_a_path_that_no_file_has(read, name: str) -> None:
    with pytest.raises(ConfigError, match="is the path of no file\n    give the path of a YAML file"):
        read(name)


def test_a_text_is_read_as_python_reads_one(tmp_path) -> None:
    file = tmp_path / "text.yaml"
    file.write_bytes("\ufeffone\r\ntwö\rthree\n".encode())
    assert text_of(file) == file.read_text("utf-8-sig")


def test_a_pipe_is_read_once(tmp_path) -> None:
    from threading import Thread

    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    writer = Thread(target=pipe.write_text, args=("intents: {wave: {action: custom, sentences: [wave]}}",), daemon=True)
    writer.start()
    assert IntentEngine.from_files(str(pipe)).parse("wave").actions
    writer.join(timeout=60)
    assert not writer.is_alive()
