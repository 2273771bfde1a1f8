# `make run` and `make test` do all the set-up that they need; `make help` lists the rest.
SHELL := /bin/sh
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed

# pybullet publishes wheels for Python 3.10 and 3.11 only, and the code is written for 3.11.
FIND_PYTHON = for python in "$(PYTHON)" python3.11 python3 python; do \
	if [ -n "$$python" ] && "$$python" -c 'import sys; sys.exit(sys.version_info[:2] != (3, 11))' 2>/dev/null; \
	then echo "$$python"; exit; fi; done

.PHONY: help run test test-all lint format type bench peers performance install chromium clean

help:
	@echo "make run        set everything up and open the dashboard (ARGS='--port 8080')"
	@echo "make test       set everything up, Chromium included, then lint, type check and test"
	@echo "make test-all   the same with the slow learning runs and soaks"
	@echo "make bench      measure speeds; after 'make peers' also those of other environments"
	@echo "make performance   measure everything that docs/performance.md shows (an hour, a calm machine)"
	@echo "make lint type format clean"

run: install
	@$(BIN)/python -m app --open $(ARGS)

test: install chromium lint type
	$(BIN)/python -m pytest -m "not slow" $(ARGS)

test-all: install chromium lint type
	$(BIN)/python -m pytest $(ARGS)

lint: install
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: install
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

type: install
	$(BIN)/mypy

bench: install
	$(BIN)/singulate bench $(ARGS)

# gym-pusht asks for opencv-python, whose files would replace those of opencv-python-headless.
peers: install
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[bench]'
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt --no-deps gym-pusht

performance: peers chromium
	$(BIN)/singulate soak --out docs/memory.json
	$(BIN)/singulate bench --out docs/performance.json --plot static/growth.png --page docs/performance.md

install: $(STAMP)

$(STAMP): pyproject.toml constraints.txt
	@if [ ! -x $(BIN)/python ]; then \
		python="$$($(FIND_PYTHON))"; \
		if [ -n "$$python" ]; then "$$python" -m venv $(VENV); \
		elif command -v uv >/dev/null 2>&1; then uv venv --seed --python 3.11 $(VENV); \
		else echo "singulate needs Python 3.11 (pybullet has no wheels beyond it): install it, or uv, or run 'make PYTHON=/path/to/python3.11'" >&2; exit 2; fi; \
	fi
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[test]'
	@touch $@

# A system Chromium where there is one, Debian's package where we may install it, else Playwright's.
chromium: install
	@for name in chromium chromium-browser google-chrome; do \
		if command -v $$name >/dev/null 2>&1; then exit 0; fi; done; \
	if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null 2>&1; then \
		apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium >/dev/null; \
	else $(BIN)/playwright install chromium; fi

clean:
	rm -rf $(VENV) build dist *.egg-info .mypy_cache .pytest_cache .ruff_cache test-artifacts
