#!/usr/bin/env bash
# Bakes the scenes of data/, projects its probes, and compares each with its golden file.
# Usage: golden_test.sh SHPRT SOURCE_DIR WORK_DIR [--refresh]
# --refresh replaces the golden files that do not agree: say in the commit why they changed.
set -euo pipefail
shprt=$1 source=$2 work=$3 refresh=${4:-}
golden=$source/tests/golden
rm -rf "$work"
mkdir -p "$work"
cd "$source"  # so that assets name their sources as data/...

# Few rays and a low degree keep the files small; half precision too, so the tolerance is that of half.
"$shprt" bake data/knot.ply -o "$work/knot.prt.exr" --model shadowed --degree 2 --rays 64 --half --compression zip --quiet
"$shprt" bake data/courtyard.obj -o "$work/courtyard.prt.exr" --model shadowed --degree 2 --rays 64 --half --compression zip --quiet
"$shprt" bake data/courtyard.obj -o "$work/courtyard_unshadowed.prt.exr" --model unshadowed --degree 1 --half --compression zip --quiet
"$shprt" project-probe data/sky.hdr -o "$work/sky.json" --degree 8 --quiet
"$shprt" project-probe data/studio.hdr -o "$work/studio.json" --window auto --quiet

# A ray that grazes an edge may fall on either side of it on another processor: one of 64 rays moves a coefficient by
# about 0.01. Everything else agrees to the rounding of half.
failed=0
compare() {
  local file=$1
  shift
  "$shprt" diff "$golden/$file" "$work/$file" "$@" && return
  if [ "$refresh" = --refresh ]; then
    cp "$work/$file" "$golden/$file"
    echo "refreshed $golden/$file"
  else
    failed=1
  fi
}
compare knot.prt.exr --atol 0.02 --rtol 1e-3
compare courtyard.prt.exr --atol 0.02 --rtol 1e-3
compare courtyard_unshadowed.prt.exr --atol 1e-6 --rtol 1e-3
compare sky.json --rtol 1e-9 --atol 1e-12
compare studio.json --rtol 1e-9 --atol 1e-12

# The comparison must be able to fail: another albedo is another bake.
if "$shprt" bake data/knot.ply -o "$work/other.prt.exr" --model shadowed --degree 2 --rays 64 --albedo 0.5 --half --quiet &&
   "$shprt" diff "$golden/knot.prt.exr" "$work/other.prt.exr" --atol 0.02 --rtol 1e-3 --quiet; then
  echo "a bake of another albedo passed as equal"
  failed=1
fi
exit $failed
