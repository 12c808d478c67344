# `make run` and `make test` do all their set-up themselves; `make help` lists the rest.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.PHONY: help run build build-tested build-all check test generate prove audit pictures \
	test-cargo test-program format clippy house test-unit test-rust verify test-cluster test-conformance test-attacks test-clients test-exports test-schemas test-python test-browser test-umbridge test-web \
	setup-build setup-rust setup-cluster setup-proxy setup-java setup-npm setup-browser setup-python setup-test

TARGET := $(or $(CARGO_TARGET_DIR),target)
STRAINSITE := $(TARGET)/release/strainsite
# What tests are compiled with, and the program that they drive: half the time of the one that ships.
TESTED := $(TARGET)/ci/strainsite
export STRAINSITE_BIN := $(abspath $(TESTED))
# Cargo has both cores for itself: it doesn't share the jobs of this file.
CARGO := MAKEFLAGS= cargo
# What all that Cargo does agrees on, so that nothing is compiled twice.
ALL := --profile ci --workspace --locked
# What a suite that drives the program needs. `make test` has built it before: asking Cargo again would wait for what Cargo is doing.
PROGRAM := $(if $(BUILT),,build-tested)
# nextest where it is installed: it runs the tests of several crates at a time. It doesn't know those of documentation.
ifneq ($(shell cargo nextest --version 2>/dev/null),)
    # Its own --profile names something else.
    UNIT_TESTS := $(CARGO) nextest run $(ALL:--profile=--cargo-profile) --lib --no-tests=pass --status-level=fail
else
    UNIT_TESTS := $(CARGO) test $(ALL) --lib --quiet
endif

help:
	@echo "make run     build, run the paper's study on the default database, serve the dashboard"
	@echo "make build   the program alone, $(STRAINSITE)"
	@echo "make check   format, lints, rules of the house and unit tests: what one runs every few minutes"
	@echo "make test    every check and test; a suite alone: test-rust test-cluster test-web test-browser test-conformance test-attacks test-exports test-schemas test-python verify"
	@echo "make generate   what follows from the program: description of the service, types of its clients, dashboard, schemas, pages"
	@echo "make pictures   the pictures of the README, drawn anew; VIEWS=--all for every view, into web/screenshots/"
	@echo "make prove   what takes hours: advisories, generated clients, PyPI's umbridge, 200 kills, studies on linear bricks, effects of what is left out, a leaning wheel by CalculiX, ten minutes of requests, 10 000 random scenes, the tables of the docs, ten minutes of fuzzing (READER=scene, study, sweep, inputs, values, recording or model)"

run: build
	$(STRAINSITE) run studies/foot-tire.toml
	$(STRAINSITE) serve

build: setup-build
	$(CARGO) build --release --locked --bin strainsite

# With the features that tests have, so that nothing is compiled for the program alone.
build-tested: setup-build
	$(CARGO) build $(ALL) --bins

# The program with the Rust tests, whose compilation fills the core that the program's crates, one waiting for the other, leave idle.
build-all: setup-rust
	$(CARGO) test $(ALL) --tests --examples --benches --no-run

# After a small change the compiler takes from its last pass what still holds: half the time. The program that ships is compiled without.
check: export CARGO_INCREMENTAL := 1
check: format house clippy test-unit

# Our crates are linted as they are compiled. The suites that drive the program wait more than they work: they run beside Cargo's tests, and are told at
# the end, in one piece.
test: export RUSTC_WORKSPACE_WRAPPER := $(abspath tests/rust/rustc)
test:
	@$(MAKE) --no-print-directory -j2 build-all setup-test
	@log=$(TARGET)/test-program.log; program=passed; cargo=passed; \
	$(MAKE) --no-print-directory --keep-going BUILT=yes test-program >$$log 2>&1 & beside=$$!; \
	nice $(MAKE) --no-print-directory BUILT=yes test-cargo || cargo=FAILED; \
	wait $$beside || program=FAILED; \
	cat $$log; \
	echo "Rust tests: $$cargo; verify and the suites that drive the program: $$program"; \
	[ $$cargo$$program = passedpassed ]

test-cargo: format house test-rust

test-program: test-cluster test-conformance test-attacks test-exports test-schemas test-python test-browser test-web verify

# Examples in the description are recorded: lab/examples.py, when an answer has a new field.
generate: build-tested setup-npm setup-python
	lab/generate $(TESTED)

# The rigs of lab print the tables of docs/.
RIGS := $(filter-out random_scenes figure,$(basename $(notdir $(wildcard lab/examples/*.rs lab/examples/*/*.rs))))

prove: setup-rust setup-cluster setup-python build-tested audit test-clients test-umbridge
	STRAINSITE_KILLS=200 $(CARGO) test $(ALL) --test slow kill
	$(CARGO) test $(ALL) --test slow -- --ignored
	$(CARGO) test $(ALL) --test quick ground_profiles -- --ignored
	STRAINSITE_CONFORMANCE_S=600 tests/conformance/run
	$(CARGO) build $(ALL) --examples
	$(TARGET)/ci/examples/random_scenes 10000 1
	for rig in $(RIGS); do echo "== $$rig"; $(TARGET)/ci/examples/$$rig; done
	tests/attacks/ending/stopping-anywhere --moments 40
	tests/cluster/kills
	tests/fuzz/run --seconds 600 $(or $(READER),scene)

# Published advisories about what we depend on; what can't be asked is said.
audit:
	tests/audit

format: setup-build
	cargo fmt --all --check

# In the profile of the tests, so that macros and build scripts are built once.
clippy: setup-build
	$(CARGO) clippy $(ALL) --all-targets -- -D warnings

house:
	python3 lab/house.py --self-test
	python3 lab/house.py
	python3 lab/fields.py --check

test-unit: setup-build
	$(UNIT_TESTS)

# The tests, and the documentation: its links and its examples.
test-rust: setup-rust
	RUSTDOC=$(abspath tests/rust/rustdoc) MAKEFLAGS= tests/rust/run $(ALL)

# Every case whose answer is known; the Rust tests ran the extremes.
verify: $(PROGRAM)
	$(TESTED) verify

# A real Slurm of three nodes, which waits more than it works.
test-cluster: $(PROGRAM) setup-cluster
	tests/cluster/run

# The running service against its own description, for half a minute.
test-conformance: $(PROGRAM) setup-python
	tests/conformance/run

# What accidents, scripts and hostile clients do to it.
test-attacks: $(PROGRAM) setup-proxy
	tests/attacks/run

# Clients that generators make of the description. In `make prove`: it takes Java, and packages of 80 MB.
test-clients: $(PROGRAM) setup-python setup-npm setup-java
	tests/clients/run

# The package of UM-Bridge's authors as client and as server. In `make prove`: its packages take 90 MB.
test-umbridge: $(PROGRAM) setup-python
	tests/umbridge/run

# Exported files, read by pandas, pyarrow and meshio.
test-exports: $(PROGRAM) setup-python
	tests/exports/run

# Schemas of documents against their readers, and what ships against taplo.
test-schemas: $(PROGRAM) setup-python
	tests/schemas/run

# The Python client against the running service.
test-python: $(PROGRAM) setup-python
	python/check

# The pictures of the README, from the real program; every view with VIEWS=--all, into web/screenshots/.
pictures: $(PROGRAM) setup-browser tests/browser/node_modules/.package-lock.json
	node tests/browser/pictures.mjs $(VIEWS)

# The real program in a real browser.
test-browser: $(PROGRAM) setup-browser tests/browser/node_modules/.package-lock.json
	cd tests/browser && npm test

test-web: setup-npm web/node_modules/.package-lock.json
	cd web && npm test && npm run check-dist

# npm writes this file last.
%/node_modules/.package-lock.json: %/package-lock.json | setup-npm
	cd $* && npm ci --no-audit --no-fund

# Set-up, on Debian: packages are installed as root, or by sudo where there is one, and by one target at a time.
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)
INSTALL := mkdir -p $(TARGET) && flock $(TARGET)/apt.lock $(SUDO) sh -c 'apt-get update -q && apt-get install -y -q --no-install-recommends "$$@"' sh

setup-build:
	@command -v cargo >/dev/null || { echo "Rust is missing: install rustup's stable toolchain (1.95 or newer)"; exit 1; }
	@command -v cc >/dev/null || { $(INSTALL) gcc libc6-dev; }

# The second opinion of --solver calculix, and a clock that jumps: their tests are skipped without them.
setup-rust: setup-build
	@command -v ccx >/dev/null || { $(INSTALL) calculix-ccx; }
	@command -v faketime >/dev/null || { $(INSTALL) faketime; }

# The proxy that an attack puts before the service: its part is left out without.
setup-proxy:
	@command -v nginx >/dev/null || test -x /usr/sbin/nginx || { $(INSTALL) nginx-light; }

# Slurm as Debian has it; the test starts it as its own user.
setup-cluster: setup-build
	@command -v slurmctld >/dev/null || test -x /usr/sbin/slurmctld || { $(INSTALL) slurm-wlm munge; }

setup-java:
	@command -v java >/dev/null || { $(INSTALL) default-jre-headless; }

setup-npm:
	@command -v npm >/dev/null || { echo "Node.js is missing: install version 20.19 or newer with npm"; exit 1; }

setup-browser: setup-rust setup-npm
	@test -x /usr/bin/chromium || { $(INSTALL) chromium; }

setup-python:
	@python3 -c 'import ensurepip, venv' 2>/dev/null || { $(INSTALL) python3-venv; }
	@python/environment >/dev/null

setup-test: setup-rust setup-cluster setup-proxy setup-browser setup-python web/node_modules/.package-lock.json tests/browser/node_modules/.package-lock.json
