"""The pytest plugin: examples of grammar files and ``*.intents.yaml`` files as test items.

Collected are files that end with ``.intents.yaml``; grammar files that the ini option ``intent_grammars`` names (globs)
or that are given on the command line by themselves. In runs without any of them nothing of the engine is loaded.
"""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from intent_engine.testing.coverage import Coverage
    from intent_engine.testing.examples import Case, Examples, Outcome

GRAMMARS = "intent_grammars"
LOCATIONS = "intent_locations"
COVERAGE = "--intent-coverage"

IN_WORKER = "intent_coverage"
"""Under which a process of pytest-xdist tells what it reached."""

_coverage_key: pytest.StashKey[Coverage] = pytest.StashKey()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("intent-engine")
    group.addoption(
        COVERAGE,
        action="store_true",
        help="List the intents, sentences and slots of grammars that no test reaches.",
    )
    parser.addini(GRAMMARS, "Grammar files whose examples are tests; globs from the root folder.", "linelist", [])
    parser.addini(LOCATIONS, "Map files for them; without any, the map that comes with the engine.", "linelist", [])


def pytest_configure(config: pytest.Config) -> None:
    if config.getoption(COVERAGE):
        from intent_engine.testing.coverage import Coverage

        config.stash[_coverage_key] = Coverage()
        config.stash[_coverage_key].start()


def pytest_unconfigure(config: pytest.Config) -> None:
    if _coverage_key in config.stash:
        config.stash[_coverage_key].stop()


@pytest.hookimpl(tryfirst=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    output = getattr(session.config, "workeroutput", None)
    if output is not None and _coverage_key in session.config.stash:
        output[IN_WORKER] = session.config.stash[_coverage_key].told()


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any, error: object) -> None:
    """A process of pytest-xdist has ended; one that crashed has told nothing."""
    if _coverage_key in node.config.stash:
        node.config.stash[_coverage_key].add(getattr(node, "workeroutput", {}).get(IN_WORKER, []))


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    if _coverage_key in config.stash:
        terminalreporter.section("intent coverage")
        for line in config.stash[_coverage_key].lines():
            terminalreporter.write_line(line)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if file_path.suffix not in (".yaml", ".yml"):
        return None
    tests = file_path.name.endswith((".intents.yaml", ".intents.yml"))
    if tests or parent.session.isinitpath(file_path) or _is_listed(file_path, parent.config):
        collector: pytest.Collector = IntentFile.from_parent(parent, path=file_path)
        return collector
    return None


def _is_listed(path: Path, config: pytest.Config) -> bool:
    if not path.is_relative_to(config.rootpath):
        return False
    name = path.relative_to(config.rootpath).as_posix()
    return any(fnmatch.fnmatch(name, pattern) for pattern in config.getini(GRAMMARS))


def _map_files(config: pytest.Config) -> list[Path]:
    return [config.rootpath / name for name in config.getini(LOCATIONS)]


class IntentFile(pytest.File):
    """A grammar or test file."""

    def collect(self) -> Iterable[pytest.Item]:
        from intent_engine.errors import ConfigError
        from intent_engine.testing.examples import load_examples

        try:
            examples = load_examples(self.path, _map_files(self.config))
        except ConfigError as error:
            raise self.CollectError(str(error)) from None
        return list(self._items(examples))

    def _items(self, examples: Examples) -> Iterator[pytest.Item]:
        for case in examples.cases:
            line = case.place.line if case.place is not None else 0
            yield IntentItem.from_parent(self, name=f"{line}: {case.text}", case=case, examples=examples)


class UnderstoodOtherwiseError(Exception):
    """A sentence was understood otherwise."""

    def __init__(self, outcome: Outcome) -> None:
        super().__init__(outcome.case.text)
        self.outcome = outcome


class IntentItem(pytest.Item):
    """One sentence and its meaning."""

    def __init__(self, *, case: Case, examples: Examples, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.case = case
        self.examples = examples

    def runtest(self) -> None:
        from intent_engine.testing.examples import run_case

        outcome = run_case(self.examples.engine, self.case)
        if outcome.missing:
            named = " or ".join(map(repr, outcome.missing))
            pytest.skip(f"no place of the map is called {named}; the ini option {LOCATIONS} names the map")
        if outcome.failed:
            raise UnderstoodOtherwiseError(outcome)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], *args: Any, **kwargs: Any) -> Any:
        if not isinstance(excinfo.value, UnderstoodOtherwiseError):
            return super().repr_failure(excinfo, *args, **kwargs)
        from intent_engine.testing.comparison import difference_table

        outcome = excinfo.value.outcome
        place = self.case.place
        where = f"{self.path.name}:{place.line}" if place is not None else self.path.name
        lines = [f"{where}: {self.case.text!r} is understood otherwise", difference_table(outcome.differences)]
        if outcome.found.reason:
            lines.append(f"reason: {outcome.found.reason}")
        if outcome.found.alternatives:
            lines.append(f"nearest: {', '.join(outcome.found.alternatives)}")
        return "\n".join(lines)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        line = self.case.place.line if self.case.place is not None else 0
        # Not the item's own name: of that, pytest would print the points in numbers as separators.
        return self.path, line - 1, f"{self.path.name}:{line} {self.case.text}"
