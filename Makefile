# `make help` lists the targets.

CARGO ?= cargo
PREFIX ?= /usr/local
DESTDIR ?=
BINDIR = $(DESTDIR)$(PREFIX)/bin
MANDIR = $(DESTDIR)$(PREFIX)/share/man/man1
BASHDIR = $(DESTDIR)$(PREFIX)/share/bash-completion/completions
ZSHDIR = $(DESTDIR)$(PREFIX)/share/zsh/site-functions
FISHDIR = $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d

.PHONY: help build test test-readers test-tex lint golden install uninstall clean judges pictures

help: ## List the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1\t\2/p' $(MAKEFILE_LIST) | sort | expand -t 18

build: ## Build the optimised program, target/release/curveto
	$(CARGO) build --release --locked

test: judges ## Run all tests; Ghostscript and Poppler are among the judges and are installed where that is possible
	$(CARGO) test --locked

test-readers: build ## Read our DXF files by ezdxf and our glyphs by fontTools, which come from PyPI
	python3 -m venv target/readers
	target/readers/bin/pip install --quiet ezdxf==1.4.5 fonttools==4.68.0
	target/readers/bin/python tests/readers.py target/release/curveto

test-tex: ## Compile our TikZ by LaTeX (Debian: texlive-latex-base and texlive-pictures)
	@command -v pdflatex >/dev/null || apt-get install -yq --no-install-recommends texlive-latex-base texlive-pictures
	$(CARGO) test --locked --test exchange -- --ignored latex

FEATURES = document batch png pdf plot serde schema cli

lint: ## Check formatting, lints, each feature alone, and the documentation of the library
	$(CARGO) fmt --all -- --check
	$(CARGO) clippy --all-targets --all-features --locked -- -D warnings
	for feature in '' $(FEATURES); do \
		$(CARGO) clippy --lib --locked --no-default-features --features "$$feature" -- -D warnings || exit 1; \
	done
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked --all-features
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked --no-default-features

golden: ## Write the golden files in fixtures/ anew
	CURVETO_GOLDEN=1 $(CARGO) test --locked --test all -- golden format_goldens schema peers measure_cli documented_commands convert::

pictures: build ## Draw the pictures of the documentation anew, with the program itself
	$(MAKE) --no-print-directory -f Makefile.picture images
	sh docs/pictures-chen.sh

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

clean: ## Remove everything that was built
	$(CARGO) clean

# `convert` on real icon sets, and speed.
include Makefile.convert Makefile.engine
