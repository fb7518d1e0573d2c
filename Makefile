# `make help` lists the targets.

CARGO ?= cargo
PREFIX ?= /usr/local
DESTDIR ?=
BINDIR = $(DESTDIR)$(PREFIX)/bin
MANDIR = $(DESTDIR)$(PREFIX)/share/man/man1
BASHDIR = $(DESTDIR)$(PREFIX)/share/bash-completion/completions
ZSHDIR = $(DESTDIR)$(PREFIX)/share/zsh/site-functions
FISHDIR = $(DESTDIR)$(PREFIX)/share/fish/vendor_completions.d

.PHONY: help build test lint golden install uninstall clean ghostscript pictures

help: ## List the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1\t\2/p' $(MAKEFILE_LIST) | sort | expand -t 18

build: ## Build the optimised program, target/release/curveto
	$(CARGO) build --release --locked

test: ghostscript ## Run all tests; Ghostscript is one of the judges and is installed where that is possible
	$(CARGO) test --locked

lint: ## Check formatting and lints
	$(CARGO) fmt --all -- --check
	$(CARGO) clippy --all-targets --all-features --locked -- -D warnings

golden: ## Write the golden files in fixtures/ anew
	CURVETO_GOLDEN=1 $(CARGO) test --locked --test all -- golden schema peers measure_cli documented_commands convert::

pictures: build ## Draw the pictures of the documentation anew, with the program itself
	$(MAKE) --no-print-directory -f Makefile.picture images
	sh docs/pictures-chen.sh

# The tests run Ghostscript on our PostScript. Debian's package comes by itself; elsewhere this says what to do.
ghostscript:
	@command -v gs >/dev/null || { \
		echo 'Ghostscript (gs) is missing'; \
		if command -v apt-get >/dev/null && [ "$$(id -u)" = 0 ]; then \
			apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends ghostscript; \
		elif command -v apt-get >/dev/null && command -v sudo >/dev/null; then \
			sudo apt-get update -q && sudo DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends ghostscript; \
		else \
			echo 'install it first: brew install ghostscript, dnf install ghostscript, pacman -S ghostscript, apk add ghostscript'; \
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
