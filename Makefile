# `make help` lists the targets.

CARGO ?= cargo
PREFIX ?= /usr/local
DESTDIR ?=
BINDIR = $(DESTDIR)$(PREFIX)/bin
MANDIR = $(DESTDIR)$(PREFIX)/share/man/man1
BASHDIR = $(DESTDIR)$(PREFIX)/share/bash-completion/completions
ZSHDIR = $(DESTDIR)$(PREFIX)/share/zsh/site-functions
FISHDIR = $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d

.PHONY: help build install uninstall dist deb wheel clean
.PHONY: test judges test-random test-readers test-browser test-tex corpora test-corpora test-corpora-back kills fuzz fuzz-random coverage mutants truth numbers lint
.PHONY: golden gallery
.PHONY: bench bench-startup bench-convert gains growth-convert scale

# ---- Build

help: ## List the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1\t\2/p' $(MAKEFILE_LIST) | sort | expand -t 18

# A program that needs no shared library starts in two thirds of the time and runs on every Linux. It takes the C library as an
# archive, which some systems have in a package of its own: without it, the program is linked as Cargo does by itself.
ARCHIVE = $(filter /%,$(shell $(CC) -print-file-name=libc.a 2>/dev/null))
STATIC = $(if $(ARCHIVE),-C target-feature=+crt-static)

build: ## Build the optimised program, target/release/curveto
	$(CARGO) rustc --release --locked --bin curveto -- $(STATIC)

install: build ## Install the program, its man pages and its shell completions below $(DESTDIR)$(PREFIX)
	install -d '$(BINDIR)' '$(MANDIR)' '$(BASHDIR)' '$(ZSHDIR)' '$(FISHDIR)'
	install -m 755 target/release/curveto '$(BINDIR)/curveto'
	target/release/curveto man --out-dir '$(MANDIR)'
	target/release/curveto completions bash > '$(BASHDIR)/curveto'
	target/release/curveto completions zsh > '$(ZSHDIR)/_curveto'
	target/release/curveto completions fish > '$(FISHDIR)/curveto.fish'

uninstall: ## Remove what install installed
	rm -f '$(BINDIR)/curveto' '$(MANDIR)'/curveto.1 '$(MANDIR)'/curveto-*.1
	rm -f '$(BASHDIR)/curveto' '$(ZSHDIR)/_curveto' '$(FISHDIR)/curveto.fish'

dist: build ## Make a tarball of the program, its man pages, completions and licences in target/dist
	packaging/dist.sh target/release/curveto target/dist

deb: build ## Make a Debian package in target/debian, by cargo-deb
	target/release/curveto man --out-dir target/deb/man
	for shell in bash zsh fish; do target/release/curveto completions $$shell > target/deb/curveto.$$shell || exit 1; done
	command -v cargo-deb > /dev/null || $(CARGO) install --locked cargo-deb
	$(CARGO) deb --no-build --locked

wheel: ## Make a wheel that carries the program, and try it in a fresh environment
	rm -rf target/wheel
	python3 -m venv target/wheel
	target/wheel/bin/pip install --quiet ./packaging/python
	target/wheel/bin/curveto circle 50

clean: ## Remove everything that was built
	$(CARGO) clean

# ---- Test

# The same random cases every time, so that a change decides and not chance; test-random tries others.
test: export PROPTEST_RNG_SEED ?= 1
test: judges ## Run all tests; Ghostscript and Poppler are among the judges and are installed where that is possible
	$(CARGO) test --locked

# The tests run Ghostscript on our PostScript and Poppler on our PDF. Debian's packages come by themselves; elsewhere this says what to do.
judges:
	@command -v gs >/dev/null && command -v pdftoppm >/dev/null || { \
		echo 'Ghostscript (gs) or Poppler (pdftoppm) is missing'; \
		if command -v apt-get >/dev/null && [ "$$(id -u)" = 0 ]; then \
			apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends ghostscript poppler-utils; \
		elif command -v apt-get >/dev/null && command -v sudo >/dev/null; then \
			sudo apt-get update -q && sudo DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends ghostscript poppler-utils; \
		else \
			echo 'install them first: brew install ghostscript poppler, dnf install ghostscript poppler-utils, pacman -S ghostscript poppler, apk add ghostscript poppler-utils'; \
			exit 1; \
		fi; }

RUNS ?= 20
RANDOM_TESTS = $(subst /,::,$(patsubst src/%.rs,%::,$(patsubst tests/all/%.rs,%::,$(shell grep -rl 'proptest!' src tests/all))))

test-random: ## Run the tests of random cases RUNS=20 times, with other cases each time
	for run in $$(seq $(RUNS)); do $(CARGO) test --locked --lib --test all -- $(RANDOM_TESTS) || exit 1; done

test-readers: build ## Read our DXF files by ezdxf and our glyphs by fontTools, which come from PyPI
	python3 -m venv target/readers
	target/readers/bin/pip install --quiet ezdxf==1.4.5 fonttools==4.68.0
	target/readers/bin/python tests/readers.py target/release/curveto

test-browser: ## Drive the pages of explore and compare in headless Chromium; it and what drives it are installed where that is possible
	$(CARGO) build --locked
	tests/browser/run target/debug/curveto

test-tex: ## Compile our TikZ by LaTeX (Debian: texlive-latex-base and texlive-pictures)
	@command -v pdflatex >/dev/null || apt-get install -yq --no-install-recommends texlive-latex-base texlive-pictures
	$(CARGO) test --locked --test all -- --ignored latex

# The icon sets that `convert` is tried on; they are fetched, never committed.
CORPORA = lucide-static-1.62.0 bootstrap-icons-1.13.2

# Those that have no arcs to begin with, for the way back.
CORPORA_BACK = mdi-svg-7.4.47 simple-icons-16.37.0

corpora: $(CORPORA:%=corpora/%/package/package.json) ## Fetch the icon sets for test-corpora and bench-convert

corpora/%/package/package.json:
	@mkdir -p corpora/$*
	name='$*'; scoped=$$(echo "$${name%-*}" | sed 's,^mdi-,@mdi/,'); cd corpora && npm pack --silent "$$scoped@$${name##*-}" > /dev/null
	tar -xzf corpora/$*.tgz -C corpora/$*
	@touch $@

test-corpora: corpora ## Convert the icon sets and judge every file
	$(CARGO) test --locked --test all -- --ignored --nocapture corpora::

test-corpora-back: corpora $(CORPORA_BACK:%=corpora/%/package/package.json) ## Bring the arcs of mdi, simple-icons, lucide and bootstrap-icons back and judge every file
	$(CARGO) test --release --locked --test all -- --ignored --nocapture way_back::

KILLS ?= 100

kills: ## Kill convert a hundred times at random moments; every file has to be whole
	CURVETO_KILLS=$(KILLS) $(CARGO) test --locked --test all faults::a_killed_run

T ?= 60
TARGETS = $(notdir $(basename $(wildcard fuzz/fuzz_targets/*.rs)))

# Inputs that were found go to fuzz/corpus and come back on the next run; what breaks a promise is in fuzz/artifacts.
fuzz: ## Look for inputs that break a promise, by their coverage, T=60 seconds a target (TARGETS='arcs lines': only these; needs nightly)
	command -v cargo-fuzz > /dev/null || $(CARGO) install --locked cargo-fuzz
	for target in $(TARGETS); do \
		mkdir -p fuzz/corpus/$$target; \
		$(CARGO) +nightly fuzz run -s none $$target fuzz/corpus/$$target fixtures/fuzz/$$target -- \
			-max_total_time=$(T) -timeout=20 -rss_limit_mb=2048 || exit 1; \
	done

FUZZ ?= 50

fuzz-random: ## Feed random and damaged input to all that reads, 50 times as many cases as make test (FUZZ=1000: for hours)
	CURVETO_FUZZ=$(FUZZ) $(CARGO) test --locked --test all fuzz::

truth: ## Hold the stated errors of a hundred thousand shapes off the beaten track against 256-bit arithmetic (CURVETO_CASES: of each class)
	$(CARGO) test --release --locked --test all truth:: -- --ignored --nocapture

numbers: ## Hold a billion printed numbers against the standard library
	$(CARGO) test --release --locked --lib -- --ignored a_billion_mixed_numbers

FEATURES = document batch png pdf plot serde schema simd cli

lint: ## Check formatting, lints, each feature alone, and the documentation of the library
	$(CARGO) fmt --all -- --check
	$(CARGO) clippy --all-targets --all-features --locked -- -D warnings
	for feature in '' $(FEATURES); do \
		$(CARGO) clippy --lib --locked --no-default-features --features "$$feature" -- -D warnings || exit 1; \
	done
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked --all-features
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked --no-default-features
	if command -v cargo-deny >/dev/null; then $(CARGO) deny --offline check licenses bans sources; fi

# The tests start the program thousands of times: its runs add to four files, in place of one each. What fails is for make test to say.
coverage: export PROPTEST_RNG_SEED ?= 1
coverage: export LLVM_PROFILE_FILE_NAME ?= curveto-%4m.profraw
coverage: judges ## List the lines that no test runs, in the library and in the programs that tests start (ten minutes)
	command -v cargo-llvm-cov > /dev/null || $(CARGO) install --locked cargo-llvm-cov
	! command -v rustup > /dev/null || rustup component add llvm-tools
	CARGO_PROFILE_TEST_DEBUG=0 $(CARGO) llvm-cov --locked --all-features --ignore-run-fail \
		--ignore-filename-regex '(tests|benches)/' --show-missing-lines

# In parts: make mutants FILES='src/shape src/joints.rs' SHARD=0/20 TESTS='shape:: bites:: golden::'
FILES ?= src/shape src/shape.rs src/joints src/joints.rs src/method src/method.rs src/measure src/measure.rs src/approximate \
	src/approximate.rs src/document src/document.rs src/batch src/batch.rs src/cli/output.rs src/cli/convert src/cli/convert.rs
SHARD ?= 0/1
TESTS ?=

mutants: ## Change the source in every small way and see whether a test notices (takes days; in parts by FILES, SHARD=0/20, TESTS)
	command -v cargo-mutants > /dev/null || $(CARGO) install --locked cargo-mutants
	mkdir -p target
	CARGO_PROFILE_TEST_DEBUG=0 $(CARGO) mutants --output target --timeout 900 --shard $(SHARD) --sharding round-robin \
		$(foreach file,$(FILES),-f '$(file)$(if $(filter %.rs,$(file)),,/**)') \
		-- --locked $(if $(TESTS),--lib --test all -- $(TESTS))

# ---- Golden files and pictures

golden: ## Write the golden files in fixtures/ anew
	CURVETO_GOLDEN=1 $(CARGO) test --locked --test all -- golden bad_input:: format_goldens schema peers measure_cli documented_commands convert::

gallery: build ## Draw the pictures of the documentation anew, and the page that shows them with their commands
	PATH="$(CURDIR)/target/release:$$PATH" docs/gallery/draw

# ---- Measure

bench: corpora ## Print one table: ours, kurbo, lyon_geom, usvg
	$(CARGO) bench --locked --bench table

bench-startup: build ## Compare the start of the program with that of an empty one, and of one without shared libraries
	mkdir -p target/startup
	printf 'fn main() {}\n' > target/startup/empty.rs
	rustc -O -C panic=abort -o target/startup/empty target/startup/empty.rs
	rustc -O -C panic=abort $(STATIC) -o target/startup/empty-static target/startup/empty.rs
	hyperfine --shell=none --warmup 50 --runs 1000 target/startup/empty target/startup/empty-static 'target/release/curveto circle 50'

bench-convert: corpora ## Measure convert beside usvg on the icon sets
	$(CARGO) bench --locked --bench convert

gains: corpora ## Count by valgrind the instructions that the fast paths of docs/design.md save (ten minutes)
	CARGO='$(CARGO)' benches/gains

# Nested drawings are SVG too, so all icons ten or twenty times over make one large file.
corpora/large-%.svg: | corpora
	{ printf '<svg xmlns="http://www.w3.org/2000/svg">\n'; for i in $$(seq $*); do cat corpora/*/package/icons/*.svg; done; printf '</svg>\n'; } > $@

growth-convert: build corpora/large-10.svg corpora/large-20.svg ## Show how memory and time of convert grow with the file
	@for size in 10 20; do for where in '' --check --in-place; do \
		cp corpora/large-$$size.svg corpora/large.svg; \
		printf '%s bytes, convert %s: ' "$$(wc -c < corpora/large.svg)" "$$where"; \
		/usr/bin/time -qf '%M KiB, %e s' target/release/curveto convert corpora/large.svg $$where 2>&1 > /dev/null || test $$? = 1; \
	done; done

scale: build ## Run batch on 10 M lines alone, under GNU parallel and under Apache Spark, and compare the outputs
	docs/scale/run
