# Two commands: `make demo` ends with a picture, `make test` runs every check. Both set up all they need.
PYTHON ?= python3
VENV := .venv
RUN := $(VENV)/bin

.PHONY: demo test setup lint benchmark clean

demo: setup
	$(RUN)/loomlight demo -o demo.png

test: lint
	$(RUN)/python -m pytest -n 2 --dist worksteal # neighbours share fixtures, so a process keeps a run of them

lint: setup
	$(RUN)/ruff check src tests tools benchmarks experiments
	$(RUN)/ruff format --check src tests tools benchmarks experiments
	$(RUN)/mypy
	$(RUN)/lint-imports

setup: $(VENV)/.installed

$(VENV)/.installed: pyproject.toml constraints.txt scripts/setup.sh $(wildcard web/package.json web/*/package.json)
	bash scripts/setup.sh "$(PYTHON)" "$(VENV)"
	touch $@

benchmark: setup
	$(RUN)/python -m benchmarks.point

clean:
	rm -rf $(VENV) .pytest_cache .mypy_cache .ruff_cache demo.png
