#!/usr/bin/env bash
# Runs every ```sh block of one Markdown file, in order and in one folder, as a reader would who types them after
# building: with `shprt` on the PATH and data/ at hand. Blocks with another tag (text, json, cpp) are not run.
# Usage: run_examples.sh SHPRT SOURCE_DIR FILE.md
set -euo pipefail
shprt=$1 source=$2 file=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ln -s "$source/data" "$folder/data"
mkdir "$folder/bin"
ln -s "$shprt" "$folder/bin/shprt"

script=$folder/example.sh
{
  echo 'set -euo pipefail'
  # tools/ scripts install packages and build: quickstart and test are exercised by CI itself.
  awk '/^```sh$/ {inside = 1; next} /^```/ {inside = 0} inside' "$file" | grep -v '^tools/' || true
} >"$script"
commands=$(grep -c '^shprt' "$script" || true)
[ "$commands" -gt 0 ] || { echo "$file: no example that runs shprt"; exit 1; }
cd "$folder"
PATH=$folder/bin:$PATH bash -x "$script" || { echo "$file: an example failed"; exit 1; }
echo "$file: $commands shprt commands ran"
