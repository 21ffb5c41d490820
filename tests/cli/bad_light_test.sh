#!/usr/bin/env bash
# What project-probe, convert, diff and info refuse.
# Usage: bad_light_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/refusals.sh"

# --- project-probe --------------------------------------------------------------------------------------------------
refused 1 project-probe missing.hdr -o out.json && says missing.hdr
refused 1 project-probe $in/empty.hdr -o out.json && says empty.hdr
refused 1 project-probe $in/cube.obj -o out.json && says cube.obj
refused 1 project-probe $in/folder -o out.json && says folder
refused 1 project-probe $in/broken.json -o out.json && says broken.json
refused 1 project-probe $in/neither.json -o out.json && says neither.json
refused 1 project-probe $in/unknown_light.json -o out.json && says laser
refused 1 project-probe $in/light.json -o out.json && says convert
refused 1 project-probe $in/asset.prt.exr -o out.json && says asset
refused 1 project-probe $in/probe.pfm -o missing-folder/out.json && says missing-folder
refused 1 project-probe $in/probe.pfm -o $in/full.json && says full.json
refused 1 project-probe $in/probe.pfm -o $in/folder && says folder
refused 2 project-probe $in/probe.pfm -o out.json --degree 33 && says 'from 0 to 32'
refused 2 project-probe $in/front.json -o out.json --degree 1001 && says 'from 0 to 1000'
refused 1 project-probe $in/probe.pfm -o $in/turn.txt --rotate @$in/turn.txt && says 'would be overwritten'
refused 1 convert $in/light.json -o out.json --json $in/turn.txt --rotate @$in/turn.txt && says 'would be overwritten'
refused 1 project-probe $in/bright.json -o out.json --exposure 60 && says 'beyond double'
refused 1 convert $in/brighter_light.json -o out.json --convention gltf && says 'beyond double'
refused 1 project-probe $in/layout_list.json -o out.json && says 'lights[0].layout'
refused 1 project-probe $in/image_list.json -o out.json --degree 33 && says 'lights[0].file'
refused 1 project-probe $in/front.json -o out.json --degree 33 --window auto && says 'degree 32 or less'
refused 2 project-probe $in/probe.pfm -o out.json --window triangle && says --window
refused 2 project-probe $in/probe.pfm -o out.json --layout sphere && says --layout
refused 2 project-probe $in/front.json -o out.json --layout latlong && says --layout
refused 2 project-probe $in/probe.pfm -o out.json --exposure bright && says --exposure
refused 2 project-probe $in/probe.pfm -o out.json --exposure nan && says --exposure
for spec in '' axis axis:1,2,3 axis:0,0,0,90 axis:0,1,0,x quat:0,0,0,0 euler:xyz,1,2,3 matrix:1,2,3 \
  matrix:1,0,0,0,1,0,0,0,-1 matrix:2,0,0,0,2,0,0,0,2 @missing.txt @$in/mirror.txt spin:3; do
  refused 2 project-probe $in/probe.pfm -o out.json --rotate "$spec" && says --rotate
done
# --- convert, diff, info --------------------------------------------------------------------------------------------
refused 1 convert missing.json -o out.json && says missing.json
refused 1 convert $in/broken.json -o out.json && says broken.json
refused 1 convert $in/newer.json -o out.json && says newer.json
refused 1 convert $in/probe.pfm -o out.json && says project-probe
refused 1 convert $l -o missing-folder/out.json && says missing-folder
refused 2 convert $l -o out.json --degree 1001 && says 'from 0 to 1000'
refused 2 convert $l -o out.json --convention godot && says 'three.js, unity, unreal'
refused 1 convert $in/unknown_convention.json -o out.json && says 'convention is wrong'
refused 1 convert $in/short_convention.json -o out.json && says 'has 1 entries where degree 2'
refused 1 relight $a $in/unity.json -o out.csv --quiet && says 'shprt convert unity.json'
refused 1 info $in/unity.json && says 'shprt convert unity.json'
refused 2 convert $l -o out.json --rotate axis:0,0,0,1 && says --rotate
refused 2 diff $a missing.prt.exr && says missing.prt.exr
refused 2 diff $a $in/truncated.prt.exr && says truncated.prt.exr
refused 2 diff $a $l && says 'cannot be compared'
refused 2 diff $in/cube.obj $in/cube.obj && says 'cannot be compared'
refused 2 diff $a $a --rtol -1 && says --rtol
refused 2 diff $a $a --atol x && says --atol
refused 2 diff $a && says B
refused 1 info missing && says missing
refused 1 info $in/empty.json && says empty.json
refused 1 info $in/folder && says folder
refused 1 info $in/truncated.prt.exr && says truncated.prt.exr
refused 1 info $in/nan.obj && says nan.obj
refused 2 info && says FILE
full_disk convert $l -o out.json --degree 32

finish
