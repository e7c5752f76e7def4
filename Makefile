# The one entry for people. `make demo` and `make test` work on a fresh clone.

VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed-for-tests
TOOLS := $(VENV)/.installed
# npm writes it when it has installed what the lock file says.
PAGE_TOOLS := web/node_modules/.package-lock.json
PYTHON ?= python3
EXAMPLE ?= examples/quadruped.kindsl
# What one process compiles serves all that tests start, wherever Python is told otherwise.
export PYTHONDONTWRITEBYTECODE :=
# Files in order: those of few tests, some of them long, would else come last and run alone.
BROWSERS := tests/typist tests/web tests/vscode tests/preview
IN_PARALLEL := $(BIN)/python -m pytest --dist loadfile --no-loadscope-reorder -n
# Tests in browsers wait for what is drawn: a third worker takes a sixth off their time.
RUN_TESTS = $(IN_PARALLEL) 2 $(BROWSERS:%=--ignore=%); others=$$?; \
	$(IN_PARALLEL) 3 $(BROWSERS) && exit $$others

.PHONY: demo demo-web playground test thorough fix lint types layers docs tables bench vsix screenshots clean

# The pip that comes with Python may take twice as long as the latest, but does where that cannot be had.
$(BIN)/python:
	@echo "Making a virtual environment in $(VENV)"
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --upgrade pip || true

$(TOOLS): pyproject.toml | $(BIN)/python
	@echo "Installing kindsl in it, with all that the preview and the mechanics need"
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[all]'
	@touch $@

# Compiled is what tests import, when they do: a third of what there is.
$(STAMP): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile -e '.[test]'
	touch $(TOOLS) $@

# Three of the findings in an arm full of mistakes, one of them explained, then the live preview of a robot.
demo: $(TOOLS)
	@echo; echo "What a generator reads in silence: three findings in examples/broken_arm.kindsl"; echo
	@$(BIN)/kdsl-lint --exit-zero --isolated examples/broken_arm.kindsl 2>/dev/null | awk '/^[^ ].*\[KD/ { n++ } n > 3 { exit } { print }'
	@echo; echo "The first one explained, with kdsl-lint --explain KD301"; echo
	@$(BIN)/kdsl-lint --explain KD301
	@echo; echo "Now the live preview: edit $(EXAMPLE) and save, and the picture follows. Ctrl-C stops."; echo
	@$(BIN)/kindsl preview $(EXAMPLE) $(DEMO_OPTIONS)

# Everything that the CI runs; what takes one core only goes side by side, installations as well. The
# search of a package for secrets takes as long as all else in packing: only what is released is searched.
test:
	@$(MAKE) --jobs 2 --output-sync --no-print-directory PACKING=--allow-package-all-secrets \
		vsix types page-tests lint layers docs-check
	$(RUN_TESTS)

# The tests with every random case; `make test` tries a part of them.
thorough: $(STAMP)
	export KINDSL_THOROUGH=1; $(RUN_TESTS)

lint: $(STAMP) $(PAGE_TOOLS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	cd web && npm run --silent lint && npm run --silent types

$(PAGE_TOOLS): web/package-lock.json
	cd web && npm ci --ignore-scripts --no-audit --no-fund --silent
	touch $@

# The parts of the preview's page that need no browser, in Node.
.PHONY: page-tests
page-tests: $(PAGE_TOOLS)
	cd web && npm run --silent test:unit

types: $(STAMP)
	$(BIN)/mypy

layers: $(STAMP)
	$(BIN)/lint-imports --no-logo 2>/dev/null || $(BIN)/lint-imports

fix: $(STAMP)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

# What is generated from one source: parser tables from the grammar, rule pages from the rules, the
# page's types from the scene's messages.
tables: $(STAMP)
	$(BIN)/python -m generating.tables

docs: tables
	$(BIN)/python -m generating.rule_pages
	$(BIN)/python -m generating.message_types
	$(BIN)/python -m tests.docs.rewrite
	if [ -d ../shared/corpus ]; then $(BIN)/python docs/pictures/published_models.py; fi

.PHONY: docs-check
docs-check: $(STAMP)
	$(BIN)/python -m generating.tables --check
	$(BIN)/python -m generating.rule_pages --check
	$(BIN)/python -m generating.message_types --check

# Those that take an hour are run by themselves: python benchmarks/soak.py.
LONG := soak mutation urdf_fuzz
bench: $(STAMP)
	for file in $(filter-out $(LONG:%=benchmarks/%.py),$(wildcard benchmarks/*.py)); do \
		$(BIN)/python $$file || exit 1; done

# What a change makes slow without anyone noticing, held to its limits: a minute or two.
.PHONY: bench-quick
bench-quick: $(STAMP)
	for name in lint lsp parsing preview; do $(BIN)/python benchmarks/$$name.py --quick || exit 1; done

# What findings claim with a probability, and how much of it holds, on so many slips of a kind.
SLIPS ?= 20
.PHONY: calibration
calibration: $(STAMP)
	$(BIN)/python benchmarks/calibration.py --half 1 --number $(SLIPS)

# Coverage-guided, so many inputs for each target: RUNS_EACH=1000000 make fuzz.
RUNS_EACH ?= 20000
.PHONY: fuzz
fuzz: $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'atheris>=2.3'
	for target in $(basename $(notdir $(wildcard tests/fuzz/targets/*.py))); do \
		$(BIN)/python -m tests.fuzz.run --target $$target --runs $(RUNS_EACH) || exit 1; done

# New random documents against RobCoGen2's own reader: N=20000 SEED=7 make differential.
N ?= 5000
SEED ?= 1
.PHONY: differential
differential: $(STAMP)
	PYTHONPATH=. $(BIN)/python -m tests.differential.run --documents $(N) --seed $(SEED)

# How much of a change of the code the tests notice; takes an hour.
.PHONY: mutation
mutation: $(STAMP)
	$(BIN)/python benchmarks/mutation.py

# Python with the server in it, for a browser's tab and an editor without Python; made anew when a source is younger.
IMAGE := web/build/server/image.json
$(IMAGE): $(shell git ls-files server/kindsl grammar web/scripts web/package-lock.json examples vscode-extension/requirements.txt) | $(BIN)/python $(PAGE_TOOLS)
	cd web && PYTHON=$(abspath $(BIN))/python npm run --silent server

# The extension, one file for desktops and browsers.
vsix: $(IMAGE)
	cd vscode-extension && npm ci --ignore-scripts --no-audit --no-fund --silent && PYTHON=$(abspath $(BIN))/python npm run --silent package -- $(PACKING)

# The whole tool in a browser's tab: one static folder, dist/playground.
playground: $(TOOLS) $(IMAGE)
	cd web && PYTHON=$(abspath $(BIN))/python npm run --silent playground

# The documentation and the playground as one static folder, dist/site.
.PHONY: site
site: playground
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[site]'
	$(BIN)/python docs/site/build.py
	@echo "Read it with: python3 -m http.server --bind 127.0.0.1 --directory dist/site"

# What the extension and the playground bundle: pinned with hashes, listed (CycloneDX), held against known flaws.
SUPPLY := build/supply/bin
.PHONY: lock sbom audit
$(SUPPLY)/pip-audit:
	$(PYTHON) -m venv build/supply
	$(SUPPLY)/python -m pip install --quiet --disable-pip-version-check 'uv>=0.9' 'cyclonedx-bom>=7' 'pip-audit>=2.9'

PINS := vscode-extension/requirements
lock: $(SUPPLY)/pip-audit
	head -1 $(PINS).txt > build/requirements.txt
	$(SUPPLY)/uv pip compile --quiet --no-deps --generate-hashes --universal --no-header --no-annotate \
		--python-version 3.11 $(PINS).in >> build/requirements.txt
	mv build/requirements.txt $(PINS).txt

sbom: $(SUPPLY)/pip-audit
	mkdir -p dist/sbom
	$(SUPPLY)/cyclonedx-py requirements $(PINS).txt --of JSON -o dist/sbom/python.cdx.json
	for part in web vscode-extension; do (cd $$part && npm sbom --sbom-format cyclonedx --package-lock-only \
		--omit dev) > dist/sbom/$$part.cdx.json || exit 1; done

audit: $(SUPPLY)/pip-audit
	$(SUPPLY)/pip-audit --strict --requirement $(PINS).txt --no-deps --disable-pip
	for part in web vscode-extension; do (cd $$part && npm audit --omit dev) || exit 1; done

# A release: versions, change log, tag; docs/releasing.md says what the tag does.
.PHONY: release
release: $(STAMP)
	git diff --quiet HEAD
	$(BIN)/python packaging/release.py version $(VERSION)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[test]'
	$(BIN)/python -m pytest -q tests/test_release.py tests/test_supply.py tests/vscode/test_vscode_sources.py
	git commit --quiet --all --message "Release $(VERSION)"
	git tag --annotate v$(VERSION) --message "kindsl $(VERSION)"

demo-web: playground
	@echo "The playground, on this machine only; Ctrl-C stops it."
	$(BIN)/python web/serve.py dist/playground

screenshots: $(STAMP)
	$(BIN)/python docs/pictures/lint_output.py
	$(BIN)/python -m tests.preview.screenshots
	$(BIN)/python docs/pictures/guide_pictures.py

clean:
	rm -rf $(VENV) build dist artifacts vscode-extension/node_modules vscode-extension/out web/node_modules web/build
