#!/usr/bin/env bash
# What shprt bake refuses, and what the command line as a whole does.
# Usage: bad_bake_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/refusals.sh"

# --- bake: meshes ---------------------------------------------------------------------------------------------------
refused 1 bake missing.obj -o out.prt.exr && says missing.obj
refused 1 bake $in/empty.obj -o out.prt.exr && says empty.obj
refused 1 bake $in/folder -o out.prt.exr && says folder
refused 1 bake $in/probe.pfm -o out.prt.exr && says probe.pfm
refused 1 bake $in/nan.obj -o out.prt.exr && says nan.obj
refused 1 bake $in/no_faces.obj -o out.prt.exr && says no_faces.obj
refused 1 bake $in/no_area.obj -o out.prt.exr && says no_area.obj
refused 1 bake $in/asset.prt.exr -o out.prt.exr && says asset.prt.exr
refused 1 bake /dev/zero -o out.prt.exr && says device
# --- bake: outputs --------------------------------------------------------------------------------------------------
refused 1 bake $in/cube.obj -o missing-folder/out.prt.exr && says missing-folder
refused 2 bake $in/cube.obj -o out.txt && says .prt.exr
refused 1 bake $in/cube.obj -o /proc/out.prt.exr && says /proc
refused 1 bake $in/cube.obj -o $in/full.prt.exr && says full.prt.exr
refused 1 bake $in/cube.obj -o out.prt.exr --json missing-folder/out.json && says missing-folder
if [ "$(id -u)" -ne 0 ]; then  # root may write anywhere
  chmod 555 $in/locked
  refused 1 bake $in/cube.obj -o $in/locked/out.prt.exr && says locked
fi
# --- bake: options --------------------------------------------------------------------------------------------------
for degree in -1 33 abc 4.5 '' 1e1 99999999999999999999; do
  refused 2 bake $in/cube.obj -o out.prt.exr --degree "$degree" && says --degree && says 'from 0 to 32'
done
for rays in 0 -5 x 65537; do
  refused 2 bake $in/cube.obj -o out.prt.exr --rays "$rays" && says --rays && says 'from 1 to 65536'
done
for albedo in 1.5 -0.1 0.1,0.2 0.1,0.2,0.3,0.4 nan red 0.5,,0.5; do
  refused 2 bake $in/cube.obj -o out.prt.exr --albedo "$albedo" && says --albedo
done
refused 2 bake $in/cube.obj -o out.prt.exr --crease-angle 181 && says --crease-angle
refused 2 bake $in/cube.obj -o out.prt.exr --seed -1 && says --seed
refused 2 bake $in/cube.obj -o out.prt.exr --threads -1 && says --threads
refused 2 bake $in/cube.obj -o out.prt.exr --model glossy && says --model
refused 2 bake $in/cube.obj -o out.prt.exr --compression rar && says --compression
refused 2 bake $in/cube.obj -o out.prt.exr --unknown && says --unknown
refused 2 bake $in/cube.obj && says --output
refused 2 bake -o out.prt.exr && says SCENE
refused 2 && says subcommand
refused 2 cook $in/cube.obj && says cook
# --- bake: effects, bounces, refinement -----------------------------------------------------------------------------
refused 2 bake $in/cube.obj -o out.prt.exr --effects shadow && says --effects
refused 2 bake $in/cube.obj -o out.prt.exr --effects auto --model shadowed && says --model
refused 2 bake $in/cube.obj -o out.prt.exr --model shadowed --bounces 2 && says --bounces
refused 2 bake $in/cube.obj -o out.prt.exr --bounces -1 && says --bounces
refused 2 bake $in/cube.obj -o out.prt.exr --degree auto && says --light
refused 2 bake $in/cube.obj -o out.prt.exr --light $l && says --degree
refused 2 bake $in/cube.obj -o out.prt.exr --degree auto --light $l --model shadowed && says --degree
refused 1 bake $in/cube.obj -o out.prt.exr --degree auto --light missing.json && says missing.json
refused 2 bake $in/cube.obj -o out.prt.exr --fit --model unshadowed && says --fit
for error in 0 -1 2 nan; do refused 2 bake $in/cube.obj -o out.prt.exr --error $error && says --error; done
for time in 0 1s ''; do refused 2 bake $in/cube.obj -o out.prt.exr --time "$time" && says --time && says 'from 0.01'; done
refused 2 bake $in/cube.obj -o out.prt.exr --time 1 --rays 64 && says --time && says --rays
refused 2 bake $in/cube.obj -o out.prt.exr --fit --time 1 && says --time && says --fit
refused 2 bake $in/cube.obj -o out.prt.exr --fit --error 0.1 && says --error && says --rays
refused 2 bake $in/cube.obj -o out.prt.exr --rays 31 --error-part && says --error-part && says '--rays 32'
refused 2 bake $in/cube.obj -o out.prt.exr --fit --error-part && says --error-part && says --fit
for edge in 0 -1 inf long ''; do refused 2 bake $in/cube.obj -o out.prt.exr --max-edge "$edge" && says --max-edge; done
refused 1 bake $in/cube.obj -o out.prt.exr --max-edge 1e-6 && says --max-edge
for memory in -1 1.5G G 1X 99999999999999999999; do
  refused 2 bake $in/cube.obj -o out.prt.exr --memory "$memory" && says --memory
done
# --- bake: scenes ---------------------------------------------------------------------------------------------------
scene() { printf '%s' "$1" >$in/scene.json; }
scene '{"objects":[{"file":"cube.obj","colour":1}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says 'objects[0].colour'
scene '{"objects":[{"file":"missing.obj"}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says missing.obj
scene '{"objects":[{"file":"cube.obj","role":"blocker"}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says receiver
scene '{"objects":[{"file":"cube.obj","transform":{"scale":0}}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says 'objects[0].transform.scale'
scene '{"objects":[{"file":"cube.obj","material":{"emission":-1}}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says 'objects[0].material.emission'
scene '{"objects":[{"file":"cube.obj","name":"a\nb"}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says 'objects[0].name'
scene '{"objects":[{"file":"cube.obj","file":"corner.obj"}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says twice
ln -sf loop.obj $in/loop.obj
scene '{"objects":[{"file":"loop.obj"}]}'
refused 1 bake $in/scene.json -o out.prt.exr && says 'objects[0].file'
scene '{"objects":[{"file":"corner.obj","material":{"emission":3.3e38,"albedo":1}}]}'
refused 1 bake $in/scene.json -o out.prt.exr --rays 8 && says emission
scene '{"objects":[{"name":"a","file":"cube.obj"}]}'
refused 2 bake $in/scene.json -o out.prt.exr --per-mesh --json out_a.prt.exr && says --json
scene '{"objects":[]}'
refused 1 bake $in/scene.json -o out.prt.exr && says objects
scene '{"objects":[{"file":"cube.obj"}'
refused 1 bake $in/scene.json -o out.prt.exr && says scene.json
scene '{"objects":[{"file":"cube.obj"}]}'
refused 1 bake $in/scene.json -o $in/cube.obj.prt.exr --json $in/cube.obj && says cube.obj
# --- plan -----------------------------------------------------------------------------------------------------------
refused 1 plan missing.obj && says missing.obj
refused 1 plan $in/cube.obj missing.json && says missing.json
refused 2 plan && says SCENE
refused 2 plan $in/cube.obj --degree x && says --degree
refused 1 plan $in/cube.obj --json $in/cube.obj && says cube.obj
full_disk bake $in/corner.obj -o out.prt.exr --rays 16

# Standard output that cannot take the data; for diff that is not "different".
no_output() {
  local expected=$1 code=0
  shift
  "$shprt" "$@" >/dev/full 2>../stderr.txt || code=$?
  [ $code -eq "$expected" ] || fail "exit code $code, not $expected, on a full standard output: shprt $*"
  [ "$(wc -l <../stderr.txt)" -eq 1 ] || fail "not one line on a full standard output: shprt $*"
  cases=$((cases + 1))
}
no_output 1 relight $a $l -o - --quiet
no_output 1 project-probe $in/probe.pfm -o - --quiet
no_output 1 info $l --json
no_output 1 info $a
no_output 1 --version
no_output 1 bake --help
no_output 2 diff $a $a

finish
