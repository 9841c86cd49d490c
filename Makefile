# Everything a newcomer needs: `make demo` and `make test`. `make help` lists the rest.
PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
STAMP  := $(VENV)/.installed

.DEFAULT_GOAL := help
.PHONY: help setup demo test test-slow test-ros2 lint format types docs check bench clean

help: ## list the targets
	@awk 'BEGIN {FS = ":.*## "} /^[a-z0-9-]+:.*## / {printf "  %-14s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

$(STAMP): pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(0 if (3, 11) <= sys.version_info < (3, 14) else "intent-engine needs Python 3.11 to 3.13; this is %s. Try: make PYTHON=python3.12 ..." % sys.version.split()[0])'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade pip
	$(BIN)/python -m pip install --quiet -e '.[dev]'
	@touch $@

setup: $(STAMP) ## make .venv and install everything into it

demo: $(STAMP) ## play a spoken session on the simulated robot and draw its way to out/demo.png
	$(BIN)/intent-engine run examples/demo.flac --map --plot out/demo.png

# A file of tests stays in one process, so that a model is loaded once for all of them.
TOGETHER := -n auto --dist loadfile
# The slow ones are few and unequal: who has done their own takes some of the others.
BALANCED := -n auto --dist worksteal

test: $(STAMP) ## run the test suite, a process on each core
	$(BIN)/python -m pytest $(TOGETHER)

test-slow: $(STAMP) ## run the tests that take minutes: hours of sound, the drill, long random runs
	$(BIN)/python -m pytest $(BALANCED) -m "slow and not ros2"

test-ros2: ## the tests that need ROS 2, in an environment of their own; skipped with the reason where there is none
	@PYTHON=$(PYTHON) scripts/test_ros2.sh

lint: $(STAMP) ## ruff, rules and format
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(STAMP) ## let ruff rewrite
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

types: $(STAMP) ## mypy --strict
	$(BIN)/mypy

docs: $(STAMP) ## build the documentation into site/
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict

bench: $(STAMP) ## run the benchmarks and write benchmarks/results.json
	$(BIN)/python -m pip install --quiet -e '.[bench]'
	$(BIN)/python -m benchmarks

check: lint types test docs ## what a change must pass

clean: ## remove what was built
	rm -rf $(VENV) out site build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
