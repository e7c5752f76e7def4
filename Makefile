# The one entry for people. `make demo` and `make test` work on a fresh clone.

VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed-for-tests
TOOLS := $(VENV)/.installed
PYTHON ?= python3
EXAMPLE ?= examples/quadruped.kindsl

.PHONY: demo test fix lint types layers docs tables bench vsix screenshots clean

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)

$(TOOLS): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[all]'
	touch $@

$(STAMP): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[test]'
	touch $(TOOLS) $@

# Lint the examples, show what is found, then open the preview of one of them.
demo: $(TOOLS)
	$(BIN)/kdsl-lint --exit-zero examples
	$(BIN)/kindsl preview $(EXAMPLE) $(DEMO_OPTIONS)

# Everything that the CI runs.
test: $(STAMP) lint types layers docs-check vsix
	$(BIN)/python -m pytest -n 2 --dist loadfile

lint: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(STAMP)
	$(BIN)/mypy

layers: $(STAMP)
	$(BIN)/lint-imports --no-logo 2>/dev/null || $(BIN)/lint-imports

fix: $(STAMP)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

# What is generated from one source: parser tables from the grammar, rule pages from the rules.
tables: $(STAMP)
	$(BIN)/python -m kindsl.syntax.generate

docs: tables
	$(BIN)/python -m kindsl.rules.pages
	$(BIN)/python -m tests.docs.rewrite
	if [ -d ../shared/corpus ]; then $(BIN)/python docs/pictures/published_models.py; fi

.PHONY: docs-check
docs-check: $(STAMP)
	$(BIN)/python -m kindsl.syntax.generate --check
	$(BIN)/python -m kindsl.rules.pages --check

# The soak takes an hour and more: python benchmarks/soak.py.
bench: $(STAMP)
	for file in $(filter-out benchmarks/soak.py,$(wildcard benchmarks/*.py)); do \
		$(BIN)/python $$file || exit 1; done

vsix: $(STAMP)
	cd vscode-extension && npm ci --ignore-scripts --no-audit --no-fund --silent && PYTHON=$(abspath $(BIN))/python npm run --silent package

screenshots: $(STAMP)
	$(BIN)/python docs/pictures/lint_output.py
	$(BIN)/python -m tests.preview.screenshots
	$(BIN)/python docs/pictures/guide_pictures.py

clean:
	rm -rf $(VENV) build dist artifacts vscode-extension/node_modules vscode-extension/out
