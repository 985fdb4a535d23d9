# `make demo` ends with a picture, `make test` runs the checks of every change, `make test-all` the slow ones too.
# Each sets up what it needs.
PYTHON ?= python3
VENV := .venv
RUN := $(VENV)/bin
# Neighbours share fixtures, so a process keeps a run of them. It grows with every kernel that it compiles, so
# each part of the tests has processes of its own: 2 GB do.
PYTEST := $(RUN)/python -m pytest -n 2 --dist worksteal
CONTRACT := tests/contract
MODELS := tests/models tests/studies tests/training tests/evaluation
PICTURES := tests/mitsuba tests/cli tests/docs tests/exporters
PAGE := tests/viewer tests/web
OTHERS := $(filter-out $(CONTRACT) $(MODELS) $(PICTURES) $(PAGE) tests/helpers tests/__pycache__,$(patsubst %/,%,$(wildcard tests/*/))) tests/test_layout.py
define run_tests
	@failed=; for part in "$(CONTRACT)" "$(MODELS)" "$(PICTURES)" "$(PAGE)" "$(OTHERS)"; do $(PYTEST) $(1) $$part || failed=1; done; test -z "$$failed"
endef

.PHONY: demo test test-all lint benchmark clean

demo: $(VENV)/.demo
	$(RUN)/loomlight demo -o demo.png

test: lint
	$(call run_tests,)

test-all: lint
	$(call run_tests,-m "")

lint: $(VENV)/.test
	$(RUN)/ruff check src studies tests tools examples integrations
	$(RUN)/ruff format --check src studies tests tools examples integrations
	$(RUN)/mypy
	$(RUN)/lint-imports

benchmark: $(VENV)/.test
	$(RUN)/python -m studies speed/point

# What a picture needs, and what tests need beside it.
$(VENV)/.demo: pyproject.toml constraints.txt scripts/setup.sh
	bash scripts/setup.sh demo "$(PYTHON)" "$(VENV)"
	touch $@

$(VENV)/.test: $(VENV)/.demo $(wildcard web/package.json web/*/package.json)
	bash scripts/setup.sh test "$(PYTHON)" "$(VENV)"
	touch $@

clean:
	rm -rf $(VENV) .pytest_cache .mypy_cache .ruff_cache demo.png
