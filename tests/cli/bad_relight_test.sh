#!/usr/bin/env bash
# What shprt relight refuses.
# Usage: bad_relight_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/refusals.sh"

# --- relight --------------------------------------------------------------------------------------------------------
refused 1 relight missing.prt.exr $l -o out.png && says missing.prt.exr
refused 1 relight $in/empty.prt.exr $l -o out.png && says empty.prt.exr
refused 1 relight $in/truncated.prt.exr $l -o out.png && says truncated.prt.exr
refused 1 relight $in/cut_at_the_end.prt.exr $l -o out.png && says cut_at_the_end.prt.exr
refused 1 relight $in/cube.obj $l -o out.png && says cube.obj
refused 1 relight $in/folder $l -o out.png && says folder
refused 1 relight $a missing.json -o out.png --quiet && says missing.json
refused 1 relight $a $in/empty.json -o out.png --quiet && says empty.json
refused 1 relight $a $in/newer.json -o out.png --quiet && says newer.json
refused 1 relight $a $a -o out.png --quiet && says 'not a light'
refused 2 relight $a $l -o out.bmp && says .png
refused 2 relight $a $l -o out && says .png
refused 1 relight $a $l -o $a && says 'is an input'
refused 1 relight $a $l -o missing-folder/out.png && says missing-folder
for suffix in csv json png ply; do
  refused 1 relight $a $l -o $in/full.$suffix --quiet --exposure 0 && says full.$suffix
done
refused 2 relight $a -o out.png && says LIGHT
printf '{"objects":[{"file":"corner.obj","material":{"emission":1}}]}' >$in/room.json
"$shprt" bake $in/room.json -o $in/room.prt.exr --rays 16 --degree 1 --quiet
refused 2 relight $a $l -o out.png --emission 1 && says --emission
refused 2 relight $in/room.prt.exr $l -o out.png --emission -1 && says --emission
refused 1 relight $a $l -o out.csv --error-bars && says asset.prt.exr && says --error-part
refused 1 relight $a $l -o out.png --error-bars --quiet && says --error-bars
refused 2 relight $in/room.prt.exr -o out.png --turntable 3 && says --turntable
refused 2 relight $in/room.prt.exr -o out.png --rotate axis:0,1,0,3 && says --rotate
refused 2 relight $a $l -o out.png --size 0x10 && says --size
refused 2 relight $a $l -o out.png --size 640 && says --size
refused 2 relight $a $l -o out.png --size 640x && says --size
refused 2 relight $a $l -o out.png --size 99999x99999 && says --size
refused 2 relight $a $l -o out.png --samples 0 && says --samples
refused 2 relight $a $l -o out.png --turntable 0 && says --turntable
for camera in eye:1,2 eye:1,2,x lens:4 fov:0 orbit:0,95 'eye:1,1,1 target:1,1,1' ' '; do
  refused 2 relight $a $l -o out.png --quiet --camera "$camera" && says --camera
done
refused 2 relight $a $l -o out.png --quiet --background && says --background
refused 2 relight $a $in/probe.pfm -o out.png --background --background-color 1 && says --background
refused 2 relight $a $l -o out.csv --size 10x10 && says --size
refused 2 relight $a $l -o out.ply --turntable 3 && says --turntable
refused 2 relight $a $l -o out.png --turntable 3 --json out_0002.png && says out_0002.png
refused 1 relight $a $in/cube.obj -o out.png --quiet && says 'a mesh, not a light'
refused 2 relight $a $l -o out.png --format csv && says --format
refused 2 relight missing.prt.exr $l -o out.png --camera orbit:spin && says --camera
refused 2 relight $a $l -o - --format png && says --format
refused 2 relight $a $l -o - --format tiff && says --format
refused 2 relight $a $l -o - --json - && says --json
refused 2 relight $a $l -o out.png --layout latlong --quiet && says --layout
full_disk relight $a $l -o out.csv --quiet
full_disk relight $a $l -o out.ply --quiet
full_disk relight $a $l -o out.png --quiet --size 256x256
full_disk relight $a $l -o out.exr --quiet --size 256x256

finish
