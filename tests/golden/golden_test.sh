#!/usr/bin/env bash
# Bakes the scenes of data/, projects its probes, and compares each with its golden file.
# Usage: golden_test.sh SHPRT SOURCE_DIR WORK_DIR [--refresh]
# --refresh writes the golden files anew instead of comparing: look at `git diff --stat` and say in the commit why they changed.
set -euo pipefail
shprt=$1 source=$2 work=$3 refresh=${4:-}
golden=$source/tests/golden
rm -rf "$work"
mkdir -p "$work"
cd "$source"  # so that assets name their sources as data/...

# Few rays and a low degree keep the files small; half precision too, so the tolerance is that of half.
"$shprt" bake data/knot.ply -o "$work/knot.prt.exr" --degree 2 --rays 64 --half --compression zip --quiet
"$shprt" bake data/courtyard.obj -o "$work/courtyard.prt.exr" --degree 2 --rays 64 --half --compression zip --quiet
"$shprt" bake data/courtyard.obj -o "$work/courtyard_unshadowed.prt.exr" --model unshadowed --degree 1 --half --compression zip --quiet
"$shprt" project-probe data/sky.hdr -o "$work/sky.json" --degree 8 --quiet
"$shprt" project-probe data/studio.hdr -o "$work/studio.json" --window auto --quiet

if [ "$refresh" = --refresh ]; then
  cp "$work"/*.prt.exr "$work"/*.json "$golden/"
  echo "golden files refreshed in $golden"
  exit 0
fi

# A ray that grazes an edge may fall on either side of it on another processor: one of 64 rays moves a coefficient by
# about 0.01. Everything else agrees to the rounding of half.
failed=0
for file in knot courtyard; do
  "$shprt" diff "$golden/$file.prt.exr" "$work/$file.prt.exr" --atol 0.02 --rtol 1e-3 || failed=1
done
"$shprt" diff "$golden/courtyard_unshadowed.prt.exr" "$work/courtyard_unshadowed.prt.exr" --atol 1e-6 --rtol 1e-3 || failed=1
for file in sky studio; do
  "$shprt" diff "$golden/$file.json" "$work/$file.json" --rtol 1e-9 --atol 1e-12 || failed=1
done

# The comparison must be able to fail: another albedo is another bake.
if "$shprt" bake data/knot.ply -o "$work/other.prt.exr" --degree 2 --rays 64 --albedo 0.5 --half --quiet &&
   "$shprt" diff "$golden/knot.prt.exr" "$work/other.prt.exr" --atol 0.02 --rtol 1e-3 --quiet; then
  echo "a bake of another albedo passed as equal"
  failed=1
fi
exit $failed
