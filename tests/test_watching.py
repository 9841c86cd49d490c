"""A grammar edited while the engine runs: the new one as a whole, or the old one."""

from __future__ import annotations

import contextlib
import json
import queue
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status
from intent_engine.watching import Watcher


@contextlib.contextmanager
def killed_after(run: subprocess.Popen, seconds: float = 120.0) -> Iterator[None]:
    """A program that says nothing more ends the test, not the patience of whoever runs it."""
    timer = threading.Timer(seconds, run.kill)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


BROKEN = "language: en\nintents:\n  wave: {action: custom, sentences: ['wave (at']}\n"


def save(file: Path, text: str) -> None:
    """As editors do: nobody sees it half written."""
    other = file.with_suffix(".saved")
    other.write_text(text)
    other.rename(file)


def grammar(generation: int, language: str = "en") -> str:
    """Every sentence of it names its generation, in the action and in a slot."""
    rows = "".join(
        f"  say_{word}:\n    action: {{type: custom, name: g{generation}, g: {generation}}}\n    sentences: [{word}]\n"
        for word in ("alpha", "bravo", "charlie")
    )
    return f"language: {language}\nintents:\n{rows}"


@pytest.fixture
def file(tmp_path) -> Path:
    path = tmp_path / "g.yaml"
    path.write_text(grammar(1))
    return path


def generation(engine: IntentEngine, text: str = "alpha") -> str:
    (action,) = engine.parse(text).actions
    return action.name


def test_a_reload_takes_the_new_grammar_and_map(tmp_path, file):
    places = tmp_path / "map.yaml"
    places.write_text("locations: {kitchen: {x: 1.0, y: 2.0}}")
    engine = IntentEngine.from_files(file, locations=places)
    file.write_text(grammar(2))
    places.write_text("locations: {garden: {x: 1.0, y: 2.0}}")
    assert generation(engine) == "g1"
    engine.reload()
    assert generation(engine) == "g2"
    assert list(engine.locations or ()) == ["garden"]


def test_a_broken_file_keeps_the_old_grammar(tmp_path, file):
    engine = IntentEngine.from_files(file, locations={"kitchen": (1.0, 2.0)})
    before = (engine.grammar, engine.locations, engine.matcher(), engine.files)
    for text in (BROKEN, "", "language: [", grammar(2).replace("sentences", "sentence")):
        file.write_text(text)
        with pytest.raises(ConfigError, match=r"g\.yaml"):
            engine.reload()
        assert generation(engine) == "g1"
        assert (engine.grammar, engine.locations, engine.matcher(), engine.files) == before
    file.unlink()
    with pytest.raises(ConfigError, match="no such file"):
        engine.reload()
    assert generation(engine) == "g1"


def test_a_broken_map_keeps_the_old_grammar_too(tmp_path, file):
    places = tmp_path / "map.yaml"
    places.write_text("locations: {kitchen: {x: 1.0, y: 2.0}}")
    engine = IntentEngine.from_files(file, locations=places)
    file.write_text(grammar(2))
    places.write_text("locations: {kitchen: {x: one}}")
    with pytest.raises(ConfigError, match=r"map\.yaml"):
        engine.reload()
    assert generation(engine) == "g1"


def test_parses_beside_a_reload_never_mix_grammars(tmp_path):
    """Two files of two languages: what one parse sees of both is always of one state of the files."""
    files = [tmp_path / "en.yaml", tmp_path / "de.yaml"]

    def write(number: int) -> None:
        for path in files:
            path.write_text(grammar(number, path.stem))

    write(0)
    engine = IntentEngine.from_files(files)
    wrong: list[str] = []
    seen: set[str] = set()
    done = threading.Event()

    def parse(text: str) -> None:
        while not done.is_set():
            found = engine.parse(text)
            if found.status is not Status.ACCEPTED or len(found.actions) != 2:
                wrong.append(str(found))
                return
            first, second = found.actions
            seen.add(first.name)
            if not first.name == second.name == f"g{first.slots['g']}" == f"g{second.slots['g']}":
                wrong.append(str(found))

    threads = [threading.Thread(target=parse, args=(text,)) for text in ("alpha then bravo", "bravo und charlie")]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        for thread in threads:
            thread.start()
        for number in range(1, 25):
            write(number)
            if number % 5 == 0:
                files[number % 2].write_text(BROKEN)
                with pytest.raises(ConfigError):
                    engine.reload()
                write(number)
            engine.reload()
    finally:
        done.set()
        sys.setswitchinterval(interval)
        for thread in threads:
            thread.join()
    assert not wrong
    assert len(seen) > 3, "the threads parsed while the grammar changed"


def test_only_files_that_matter_cause_a_reload(tmp_path, file):
    engine = IntentEngine.from_files(file)
    told: list[ConfigError | None] = []
    watcher = Watcher(engine, told.append)
    file.write_text(grammar(2))
    assert not watcher.changed([tmp_path / "other.yaml"])
    assert generation(engine) == "g1"
    assert watcher.changed([tmp_path / "other.yaml", file])
    assert generation(engine) == "g2"
    assert told == [None]


def test_a_file_that_was_refused_is_watched_until_it_is_mended(tmp_path, file):
    engine = IntentEngine.from_files(file)
    told: list[ConfigError | None] = []
    watcher = Watcher(engine, told.append)
    words = tmp_path / "words.yaml"
    words.write_text("language: en\nphrases: {a: (x}\n")
    file.write_text(grammar(2).replace("intents:", "include: [words.yaml]\nintents:"))
    assert watcher.changed([file])
    assert isinstance(told[-1], ConfigError)
    assert generation(engine) == "g1"
    assert words.resolve() in watcher.files
    words.write_text("language: en\nphrases: {a: x}\n")
    assert watcher.changed([words])
    assert told[-1] is None
    assert generation(engine) == "g2"


WITH = "include: [other.yaml]\nintents:\n  bow: {action: custom, sentences: ['bow [{how}]']}\n"


@pytest.mark.parametrize("before", [None, "slots: {who: [me]}\n"], ids=["not there", "there, and without it"])
def test_what_a_refused_grammar_includes_is_watched(tmp_path, file, before):
    engine = IntentEngine.from_files(file)
    told: list[ConfigError | None] = []
    watcher = Watcher(engine, told.append)
    other = tmp_path / "other.yaml"
    if before is not None:
        other.write_text(before)
    file.write_text(WITH)
    assert watcher.changed([file])
    assert told[-1] is not None
    other.write_text("slots: {how: [deeply]}\n")
    assert watcher.changed([other])
    assert told[1:] == [None]
    assert engine.parse("bow deeply").actions


def test_a_link_that_leads_elsewhere_is_another_grammar(tmp_path, file):
    (tmp_path / "versions").mkdir()
    (tmp_path / "versions" / "g2.yaml").write_text(grammar(2))
    link = tmp_path / "link.yaml"
    link.symlink_to(file)
    engine = IntentEngine.from_files(link)
    watcher = Watcher(engine)
    assert {link, file} <= watcher.files
    link.unlink()
    link.symlink_to(tmp_path / "versions" / "g2.yaml")
    assert watcher.changed([link])
    assert generation(engine) == "g2"


def test_files_are_watched(tmp_path, file):
    pytest.importorskip("watchfiles")
    engine = IntentEngine.from_files(file)
    told: queue.Queue[ConfigError | None] = queue.Queue()
    with Watcher(engine, told.put) as watcher:
        file.write_text(BROKEN)
        assert isinstance(told.get(timeout=30), ConfigError)
        file.write_text(grammar(3))
        while told.get(timeout=30) is not None:
            pass  # a file seen half written
        assert generation(engine) == "g3"
        save(file, grammar(4))
        while generation(engine) != "g4":
            told.get(timeout=30)
    watcher.close()


def test_a_system_that_refuses_to_watch_is_told(monkeypatch, caplog, file):
    watchfiles = pytest.importorskip("watchfiles")

    def refuse(*_, **__):
        raise OSError(28, "inotify watch limit reached")

    monkeypatch.setattr(watchfiles, "watch", refuse)
    engine = IntentEngine.from_files(file)
    with Watcher(engine):
        assert generation(engine) == "g1"
    assert "files cannot be watched: [Errno 28] inotify watch limit reached" in caplog.text


def test_without_watchfiles_it_says_what_to_install(monkeypatch, file):
    monkeypatch.setitem(sys.modules, "watchfiles", None)
    with pytest.raises(ConfigError, match=r"pip install 'intent-engine\[watch\]'"):
        Watcher(IntentEngine.from_files(file)).start()


def test_an_engine_that_was_not_made_from_files_cannot_be_reloaded(file):
    engine = IntentEngine(IntentEngine.from_files(file).grammars)
    with pytest.raises(ConfigError):
        engine.reload()
    assert generation(engine) == "g1"


def test_parse_takes_up_changes(file):
    pytest.importorskip("watchfiles")
    command = [sys.executable, "-m", "intent_engine.cli", "parse", "--watch", "--grammar", str(file), "-"]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    with subprocess.Popen(command, text=True, **pipes) as run, killed_after(run):
        assert run.stdin is not None
        assert run.stdout is not None
        assert run.stderr is not None

        def ask() -> str:
            print("alpha", file=run.stdin, flush=True)
            return json.loads(run.stdout.readline())["actions"][0]["name"]

        assert ask() == "g1"
        save(file, BROKEN)
        lines = [run.stderr.readline() for _ in range(2)]
        assert lines[0].startswith("not reloaded, the old grammar stays in use:")
        assert "'(' is never closed" in lines[1]
        assert ask() == "g1"
        file.write_text(grammar(2))
        while not run.stderr.readline().startswith("reloaded: 3 sentences"):
            pass
        assert ask() == "g2"
        file.write_text(grammar(3).replace("[alpha]", "[alpha, alpha]"))
        told = iter(run.stderr.readline, "")
        assert any(line.startswith("reloaded:") for line in told)
        assert f"1 warning in grammar {file}: intent-engine check {file} shows it" in next(told)
        run.stdin.close()
        assert run.wait(timeout=30) == 0


def test_a_watcher_begins_once_and_ends_once(file):
    pytest.importorskip("watchfiles")
    watcher = Watcher(IntentEngine.from_files(file))
    with watcher:
        thread = watcher._thread
        watcher.start()
        assert watcher._thread is thread
    watcher.close()
    with pytest.raises(RuntimeError, match="this watcher is closed"):
        watcher.start()
    with pytest.raises(TypeError, match="Watcher takes an IntentEngine, not 'en'"):
        Watcher("en")


def test_watch_is_for_many_sentences(intent_engine, file):
    done = intent_engine("parse", "--watch", "--grammar", file, "alpha", COLUMNS="200")
    assert done.returncode == 2
    assert "--watch is for sentences from standard input" in done.stderr


def test_watch_is_for_recordings_that_last(intent_engine):
    done = intent_engine("run", "--watch", "examples/demo.flac", COLUMNS="200")
    assert done.returncode == 2
    assert "--watch needs --realtime" in done.stderr


def test_a_robot_that_listens_takes_up_changes(tmp_path, root):
    """Sound goes on for as long as its pipe is open; the grammar changes in between."""
    pytest.importorskip("watchfiles")
    text = (root / "grammars/en.yaml").read_text("utf-8")
    path = tmp_path / "en.yaml"
    path.write_text(text)
    command = [sys.executable, "-m", "intent_engine.cli", "listen", "--watch", "--json", "--no-reflex", "--pcm", "-"]
    command += ["--grammar", str(path)]
    silence = bytes(2 * 16_000)
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, **pipes) as run, killed_after(run):
        assert run.stdin is not None
        assert run.stderr is not None
        run.stdin.write(silence)
        run.stdin.flush()
        lines = iter(lambda: run.stderr.readline().decode(), "")
        assert any(line.startswith("listening to") for line in lines)
        run.stdin.write(silence)
        run.stdin.flush()
        for edited, told in ((text + "intents: {", "not reloaded"), (text + "# edited\n", "reloaded: ")):
            path.write_text(edited)
            assert any(line.startswith(told) for line in lines)
        run.stdin.close()
        assert run.wait(timeout=60) == 0
