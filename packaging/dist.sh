#!/bin/sh
# packaging/dist.sh PROGRAM FOLDER: makes FOLDER/curveto-VERSION-SYSTEM-MACHINE.tar.gz of a built program: the program, its manual
# pages, completions and licences, laid out as below a prefix. The same program gives the same bytes.
set -eu

program=$1
folder=$2
here=$(cd "$(dirname "$0")/.." && pwd)
name=curveto-$("$program" --version | cut -d' ' -f2)-$(uname -s | tr '[:upper:]' '[:lower:]')-$(uname -m)
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
root=$stage/$name

for part in bin share/man/man1 share/bash-completion/completions share/zsh/site-functions share/fish/vendor_completions.d \
	share/doc/curveto; do
	mkdir -p "$root/$part"
done
cp "$program" "$root/bin/curveto"
chmod 755 "$root/bin/curveto"
"$program" man --out-dir "$root/share/man/man1"
"$program" completions bash > "$root/share/bash-completion/completions/curveto"
"$program" completions zsh > "$root/share/zsh/site-functions/_curveto"
"$program" completions fish > "$root/share/fish/vendor_completions.d/curveto.fish"
cp "$here/LICENSE-MIT" "$here/LICENSE-APACHE" "$here/README.md" "$here/CHANGELOG.md" "$root/share/doc/curveto/"
cp "$here/src/picture/font/LICENSE" "$root/share/doc/curveto/LICENSE-font"

mkdir -p "$folder"
find "$stage/$name" -exec touch -d 1980-01-01T00:00:00Z {} +
(cd "$stage" && find "$name" -type f | LC_ALL=C sort | tar -cf - --owner=0 --group=0 --numeric-owner -T -) | gzip -9n > "$folder/$name.tar.gz.part"
mv "$folder/$name.tar.gz.part" "$folder/$name.tar.gz"
echo "$folder/$name.tar.gz"
