# The two commands: `make run` and `make test`. Both do all their set-up themselves.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.PHONY: run build test lint test-rust test-web test-browser test-conformance test-exports test-python verify setup-build setup-calculix setup-faketime setup-test setup-conformance help

STRAINSITE := $(or $(CARGO_TARGET_DIR),target)/release/strainsite
export STRAINSITE_BIN := $(abspath $(STRAINSITE))
# Debian packages are installed as root, or by sudo where there is one.
APT_GET := $(if $(filter 0,$(shell id -u)),,sudo )apt-get

help:
	@echo "make run    build, run the paper's study on the default database, serve the dashboard"
	@echo "make test   every check and test"

run: build
	$(STRAINSITE) run studies/foot-tire.toml
	$(STRAINSITE) serve

build: setup-build
	cargo build --release --locked --bin strainsite

test: lint test-rust test-web test-browser test-conformance test-exports test-python verify

# In release mode like the tests, so that what both need is built once.
lint: setup-build
	cargo fmt --all --check
	cargo clippy --release --workspace --all-targets --locked -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --release --workspace --no-deps --locked --quiet

test-rust: setup-build setup-calculix setup-faketime
	cargo test --release --workspace --locked

test-web: setup-test
	cd web && npm ci && npm test && npm run check-dist

# The binary that the Rust tests drive: building it apart from them would build its dependencies once more.
test-browser: setup-test test-rust
	cd tests/browser && npm ci && npm test

# The running service against its own description, for a minute.
test-conformance: setup-conformance test-rust
	tests/conformance/run

# The Python client against the running service.
test-python: setup-conformance test-rust
	python/check

# Exported files, read by pandas, pyarrow and meshio.
test-exports: setup-conformance test-rust
	tests/exports/run

# Every case whose answer is known, on the binary that the Rust tests drove; these ran the extremes.
verify: test-rust
	$(STRAINSITE) verify

setup-build:
	@command -v cargo >/dev/null || { echo "Rust is missing: install rustup's stable toolchain (1.95 or newer)"; exit 1; }
	@command -v cc >/dev/null || { $(APT_GET) update -q && $(APT_GET) install -y -q gcc libc6-dev; }

# The second opinion of --solver calculix; its tests are skipped without it.
setup-calculix:
	@command -v ccx >/dev/null || { $(APT_GET) update -q && $(APT_GET) install -y -q --no-install-recommends calculix-ccx; }

# Makes the clock jump in a test, which is skipped without it.
setup-faketime:
	@command -v faketime >/dev/null || { $(APT_GET) update -q && $(APT_GET) install -y -q --no-install-recommends faketime; }

setup-test: setup-calculix
	@command -v npm >/dev/null || { echo "Node.js is missing: install version 20.19 or newer with npm"; exit 1; }
	@test -x /usr/bin/chromium || { $(APT_GET) update -q && $(APT_GET) install -y -q --no-install-recommends chromium; }

setup-conformance:
	@python3 -c 'import ensurepip, venv' 2>/dev/null || { $(APT_GET) update -q && $(APT_GET) install -y -q --no-install-recommends python3-venv; }
