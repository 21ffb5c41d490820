#!/usr/bin/env bash
# Bakes the shared kitchen (289 OBJ files, 1.05 million triangles) as one mesh and prints time and peak memory beside the
# asset's size. Usage: [MODEL=shadowed] [RAYS=256] bench/kitchen.sh [SHPRT] [SHARED_DIR]; needs /usr/bin/time (Debian package time).
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
shprt=${1:-$source/build/release/tools/shprt/shprt} shared=${2:-$source/../shared}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tar -C "$folder" -xf "$shared/data/meshes/kitchen.tar.xz"

# Indices of each file move up by what came before it.
find "$folder" -name '*.obj' | sort | while read -r file; do cat "$file"; echo "#end"; done | awk '
  /^#end/ {v += nv; t += nt; n += nn; nv = nt = nn = 0; next}
  /^v /   {++nv; print; next}
  /^vt /  {++nt; print; next}
  /^vn /  {++nn; print; next}
  /^f /   {line = "f"
           for (i = 2; i <= NF; ++i) {
             k = split($i, c, "/"); line = line " " (c[1] + v)
             if (k > 1) line = line "/" (c[2] == "" ? "" : c[2] + t)
             if (k > 2) line = line "/" (c[3] + n)
           }
           print line}' >"$folder/kitchen.obj"

/usr/bin/time -f "peak memory         %M kB" "$shprt" bake "$folder/kitchen.obj" -o "$folder/kitchen.prt.exr" --rays "${RAYS:-256}" \
  --model "${MODEL:-shadowed}"
echo "asset               $(($(stat -c %s "$folder/kitchen.prt.exr") / 1024)) kB"
