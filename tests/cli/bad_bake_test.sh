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
refused 2 bake -o out.prt.exr && says MESH
refused 2 && says subcommand
refused 2 cook $in/cube.obj && says cook
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
