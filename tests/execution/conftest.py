"""Fixtures of the execution room."""

from __future__ import annotations

import pytest
from execution_stage import Stage

from intent_engine.execution.limits import Limits


@pytest.fixture
def stage():
    made: list[Stage] = []

    def make(limits: Limits | None = None, **options) -> Stage:
        made.append(Stage(limits, **options))
        return made[-1]

    yield make
    for each in made:
        each.executor.close()
