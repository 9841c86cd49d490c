"""The benchmarks' sentences through our engine, the collector, and the peers' grammars. No times are asserted here."""

from __future__ import annotations

import json
import signal
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import nullcontext
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

from benchmarks import __main__ as collector
from benchmarks import judging
from benchmarks.judging import REFUSED, RIGHT, WRONG, Sentence, verdict
from benchmarks.peers import Peer, Step, plain
from benchmarks.report import Plot, Report, Table

KINDS = ("plain", "filler", "misheard", "negated", "corrected", "compound", "out of scope")


@pytest.fixture(scope="module")
def ours() -> Peer:
    return judging.ours()


# -- our engine ---------------------------------------------------------------------------------------------------


def test_the_list_has_every_kind_of_sentence_and_none_twice() -> None:
    sentences = judging.sentences()
    assert len(sentences) >= 80
    kinds = Counter(sentence.kind for sentence in sentences)
    assert tuple(kinds) == KINDS
    assert min(kinds.values()) >= 12
    assert len({plain(sentence.text) for sentence in sentences}) >= len(sentences) - 2, "digits may repeat words"


def test_every_sentence_is_understood_but_the_known_defects(ours: Peer) -> None:
    found = {
        sentence.text: verdict(sentence, ours.steps(sentence.text))
        for sentence in judging.sentences()
        if verdict(sentence, ours.steps(sentence.text)) != RIGHT
    }
    assert found == judging.known_defects(), "`ours` at the end of benchmarks/sentences.yaml is the list to correct"


def test_no_defect_moves_a_robot() -> None:
    assert set(judging.known_defects().values()) <= {REFUSED}


@pytest.mark.parametrize(
    ("wanted", "found", "expected"),
    [
        ([("turn", {"angle": 1.5708})], [("turn", {"angle": 1.5707963})], RIGHT),
        ([("turn", {"angle": 1.5708})], [("turn", {"angle": 1.6})], WRONG),
        ([("pick", {"thing": "cup"})], [("pick", {"thing": "the cup"})], RIGHT),
        ([("pick", {"thing": "cup"})], [("pick", {})], WRONG),
        ([("pick", {"thing": "cup"})], [("pick", {"thing": "cup", "source": "table"})], WRONG),
        ([("stop", {})], [("move", {})], WRONG),
        ([("stop", {})], [], REFUSED),
        ([], [], RIGHT),
        ([], [("stop", {})], WRONG),
        ([("stop", {}), ("come", {})], [("stop", {})], WRONG),
    ],
)
def test_verdicts(wanted: list[Step], found: list[Step], expected: str) -> None:
    assert verdict(Sentence("plain", "", tuple(wanted)), found) == expected


# -- the peers ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("module", ["hassil_peer", "rhasspy_peer", "adapt_peer", "padacioso_peer"])
def test_a_peers_grammar_is_as_good_as_its_engine_allows(module: str) -> None:
    """Plain sentences, with and without fillers: what a peer has wrong elsewhere is then not its grammar's fault."""
    try:
        peers = import_module(f"benchmarks.peers.{module}").peers(judging.places())
    except ImportError as error:
        pytest.skip(f"the bench extra is not installed: {error}")
    for peer in peers:
        found = judging.verdicts(peer)
        assert found["plain"] == Counter({RIGHT: found["plain"].total()}), peer.name
        assert found["filler"] == Counter({RIGHT: found["filler"].total()}), peer.name


def test_plain_words_for_peers() -> None:
    assert plain("Turn left, 45° NOW!") == "turn left 45 degrees now"
    assert plain("go 2.5 meters. Don't stop...") == "go 2.5 meters don't stop"


# -- the collector ------------------------------------------------------------------------------------------------


def a_row(**changed: object) -> dict[str, object]:
    row: dict[str, object] = {
        "figure": "a | b", "value": 0.0123, "unit": "ms", "peer": None, "peer_value": None, "ratio": None,
        "spread": [1, 2.5], "runs": 3, "command": "python -m benchmarks --only it",
    }  # fmt: skip
    return row | changed


def test_rows_without_a_peer_and_with_one() -> None:
    assert collector.cells(a_row()) == ["a | b", "0.0123 ms", "1 .. 2.5", "", "", "", "3"]
    assert collector.cells(a_row(peer="p", peer_value=1234.5, ratio=100.4))[3:6] == ["p", "1,234 ms", "100x"]


@pytest.mark.parametrize("wrong", [{"extra": 1}, None])
def test_a_row_of_another_form_is_refused(wrong: dict[str, object] | None) -> None:
    row = a_row(**wrong) if wrong else {"figure": "alone"}
    with pytest.raises(ValueError, match="it: a row has wrong keys"):
        collector.checked("it", [row])


def test_one_module_replaces_only_what_is_its_own() -> None:
    report = Report(
        collector.checked("one", [a_row()]),
        [Table("T", ["a"], [["1|2"]], "A note.")],
        [Plot("P", "one.svg", "x", "y", {"ours": [[1, 2]]})],
    )
    results = collector.merge({"rows": []}, "one", report, quick=False)
    results = collector.merge(results, "two", Report.of(collector.checked("two", [a_row()])), quick=True)
    results = collector.merge(results, "one", report, quick=False)
    assert [row["module"] for row in results["rows"]] == ["one", "two"]
    assert [len(results[kind]) for kind in ("tables", "plots")] == [1, 1]
    page = collector.page(json.loads(json.dumps(results)))
    assert page.count("Quick runs") == 1
    assert "| a \\| b | 0.0123 ms |" in page
    assert "**T**\n\n| a |\n|---|\n| 1\\|2 |\n\nA note.\n" in page
    assert "](images/one.svg)" in page


@pytest.fixture
def results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A collector that writes elsewhere, and has measured two rows of ``one`` before."""
    path = tmp_path / "results.json"
    monkeypatch.setattr(collector, "RESULTS", path)
    monkeypatch.setattr(collector, "PAGE", tmp_path / "docs" / "benchmarks.md")
    before = Report(collector.checked("one", [a_row(figure="first"), a_row(figure="second")]))
    path.write_text(json.dumps(collector.merge({"rows": []}, "one", before, quick=True)), "utf-8")
    return path


def benchmark(monkeypatch: pytest.MonkeyPatch, name: str, run: object) -> None:
    module = ModuleType(f"benchmarks.{name}")
    module.run = run  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, f"benchmarks.{name}", module)
    monkeypatch.setattr(collector, "modules", lambda: ["one", "two"])


def measured(results: Path) -> list[tuple[str, float, bool]]:
    return [(row["figure"], row["value"], row["quick"]) for row in json.loads(results.read_text("utf-8"))["rows"]]


@pytest.mark.parametrize("error", [ZeroDivisionError("one over nothing"), KeyboardInterrupt()])
def test_what_was_measured_before_a_fault_is_kept(
    results: Path, monkeypatch: pytest.MonkeyPatch, error: BaseException
) -> None:
    def run(quick: bool) -> Iterator[list[dict[str, object]]]:
        yield [a_row(figure="first", value=7)]
        raise error

    benchmark(monkeypatch, "one", run)
    benchmark(monkeypatch, "two", lambda quick: [a_row(figure="third")])
    monkeypatch.setattr(sys, "argv", ["benchmarks"])
    interrupted = isinstance(error, KeyboardInterrupt)
    with pytest.raises(KeyboardInterrupt) if interrupted else nullcontext():
        assert collector.main() == 1
    assert measured(results)[:2] == [("first", 7, False), ("second", 0.0123, True)]
    assert len(measured(results)) == (2 if interrupted else 3), "the others are measured all the same"
    assert "| first | 7 ms |" in collector.PAGE.read_text("utf-8")


def test_what_was_measured_before_sigterm_is_kept(results: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def run(quick: bool) -> Iterator[list[dict[str, object]]]:
        yield [a_row(figure="first", value=7)]
        signal.raise_signal(signal.SIGTERM)
        pytest.fail("measured on")

    before = signal.signal(signal.SIGTERM, lambda *_: pytest.fail("nobody expected it"))
    try:
        benchmark(monkeypatch, "one", run)
        benchmark(monkeypatch, "two", lambda quick: [a_row(figure="third")])
        monkeypatch.setattr(sys, "argv", ["benchmarks"])
        with pytest.raises(SystemExit) as end:
            collector.main()
    finally:
        signal.signal(signal.SIGTERM, before)
    assert end.value.code == 143
    assert measured(results) == [("first", 7, False), ("second", 0.0123, True)]
    assert "| first | 7 ms |" in collector.PAGE.read_text("utf-8")


def test_a_whole_run_leaves_nothing_of_the_one_before(results: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    benchmark(monkeypatch, "one", lambda quick: [a_row(figure="first", value=7)])
    monkeypatch.setattr(sys, "argv", ["benchmarks", "--only", "one"])
    assert collector.main() == 0
    assert measured(results) == [("first", 7, False)]


@pytest.mark.parametrize(
    ("error", "told", "code"),
    [
        (FileNotFoundError("no recordings"), "one: skipped: no recordings", 0),
        (ModuleNotFoundError("No module named 'hassil'"), "hassil'; make bench installs what", 1),
    ],
)
def test_what_cannot_run_says_why(
    results: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    error: Exception,
    told: str,
    code: int,
) -> None:
    def run(quick: bool) -> list[dict[str, object]]:
        raise error

    benchmark(monkeypatch, "one", run)
    monkeypatch.setattr(sys, "argv", ["benchmarks", "--only", "one"])
    assert collector.main() == code
    assert told in capsys.readouterr().err
    assert len(measured(results)) == 2


def test_pictures_are_the_same_for_the_same_numbers(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the plot extra is not installed")
    from benchmarks.report import draw

    plots = [{"title": "P", "x": "x", "y": "y", "series": {"ours": [[1, 2], [10, 3]], "other": [[1, 9]]}}]
    for name in ("a.svg", "b.svg"):
        draw(plots, tmp_path / name)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_the_page_is_what_the_results_say() -> None:
    results = json.loads(collector.RESULTS.read_text("utf-8"))
    assert collector.page(results) == collector.PAGE.read_text("utf-8"), "run python -m benchmarks --page"
    for plot in results.get("plots", []):
        assert (collector.PAGE.parent / "images" / plot["file"]).stat().st_size < 100_000
    for row in results["rows"]:
        assert set(row) == {*collector.KEYS, "module", "measured", "machine", "quick"}
