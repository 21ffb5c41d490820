#!/usr/bin/env bash
# Runs the Python reader exactly as docs/file-formats.md prints it, and compares its answer with `shprt relight`.
# Usage: python_reader_test.sh SHPRT SOURCE_DIR WORK_DIR. Exit code 77: skipped.
set -euo pipefail
shprt=$1 source=$2 work=$3
python=/usr/bin/python3
"$python" -c 'import OpenImageIO, numpy' 2>/dev/null || { echo "SKIPPED: no OpenImageIO for $python"; exit 77; }
mkdir -p "$work"
awk '/^```python$/ {inside = 1; next} /^```/ {inside = 0} inside' "$source/docs/file-formats.md" >"$work/reader.py"
[ -s "$work/reader.py" ] || { echo "docs/file-formats.md has no Python reader"; exit 1; }
"$shprt" project-probe "$source/data/studio.hdr" -o "$work/light.json" --quiet
for asset in knot.ply courtyard.obj cornell.json; do  # one channel, three, and light of its own
  "$shprt" bake "$source/data/$asset" -o "$work/asset.prt.exr" --rays 32 --quiet
  "$python" "$work/reader.py" "$work/asset.prt.exr" "$work/light.json" >"$work/python.txt"
  "$shprt" relight "$work/asset.prt.exr" "$work/light.json" -o "$work/own.csv" --quiet
  paste -d' ' "$work/python.txt" <(sed -n 2p "$work/own.csv" | cut -d, -f7-9 | tr ',' ' ') |
    awk '{for (i = 1; i <= 3; ++i) {d = $i - $(i + 3); if (d < 0) d = -d; if (!(d < 1e-5)) {print "radiance differs: " $0; exit 1}}}'
done
