#!/usr/bin/env bash
# From a fresh Debian or Ubuntu machine to pictures: installs what is missing, builds, bakes the scenes in data/, projects
# their light probes and relights. Run again at will; it rebuilds only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/packages.sh

echo "== 1/3  Packages"
ensure_packages "${packages[@]}"
offer_packages "${optional_packages[@]}"

echo "== 2/3  Build (two to five minutes on two cores, once; 200 MB)"
configure_and_build release -DSHPRT_BUILD_TESTS=OFF -DSHPRT_BUILD_BENCH=OFF

echo "== 3/3  Bake, project, relight"
out=quickstart-output
shprt=build/release/tools/shprt/shprt
mkdir -p "$out"
"$shprt" bake data/knot.ply -o "$out/knot.prt.exr" --degree 6 --rays 1024
"$shprt" project-probe data/sky.hdr -o "$out/sky.json" --degree 6 --window hann
"$shprt" relight "$out/knot.prt.exr" "$out/sky.json" --rotate axis:0,1,0,110 -o "$out/knot_sky.png"
"$shprt" relight "$out/knot.prt.exr" data/sky.hdr --window hann --background --camera orbit:0,6 -o "$out/knot_outdoors.png"
"$shprt" relight "$out/knot.prt.exr" data/studio.hdr --window hann -o "$out/knot_studio.png"
"$shprt" bake data/courtyard.obj -o "$out/courtyard.prt.exr"
"$shprt" relight "$out/courtyard.prt.exr" "$out/sky.json" --rotate axis:0,1,0,40 -o "$out/courtyard_sky.png"
"$shprt" bake data/cornell.json -o "$out/cornell.prt.exr" --rays 2048
"$shprt" relight "$out/cornell.prt.exr" -o "$out/cornell_lamp.png" --size 720x720 --camera "eye:0,1,4.2 target:0,1,0 fov:34"

echo
echo "Pictures:"
for picture in "$out"/*.png; do echo "  $PWD/$picture"; done
echo "The tool: $PWD/$shprt   (try: $shprt --help)"
