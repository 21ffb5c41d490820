#!/usr/bin/env bash
# What shprt study refuses, before it begins to measure.
# Usage: bad_study_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/refusals.sh"
mkdir -p ../in/study/index.html
echo '{}' >../in/study.json
mkdir ../in/own
cp ../in/light.json ../in/own/study.json

refused 2 study $in/cube.obj -o '' && says --output
refused 1 study missing.obj -o study && says missing.obj
refused 1 study $in/nan.obj -o study && says nan.obj
refused 1 study $a -o study && says asset.prt.exr
refused 1 study $in/cube.obj missing.hdr -o study && says missing.hdr
refused 1 study $in/cube.obj $in/cube.obj -o study && says cube.obj
refused 1 study $in/cube.obj $in/neither.json -o study && says neither.json
# --- folders --------------------------------------------------------------------------------------------------------
refused 1 study $in/cube.obj -o $in/study.json && says study.json && says 'is a file'
refused 1 study $in/cube.obj -o $in/study.json/below && says study.json
refused 1 study $in/cube.obj -o $in/study && says index.html
refused 1 study $in/cube.obj -o /proc/study && says /proc
refused 1 study $in/cube.obj $in/own/study.json -o $in/own && says 'is an input'
refused 1 study $in/cube.obj -o study --json missing-folder/out.json && says missing-folder
refused 2 study $in/cube.obj -o $in/folder --json $in/folder/study.json && says --json
if [ "$(id -u)" -ne 0 ]; then  # root may write anywhere
  chmod 555 $in/locked
  refused 1 study $in/cube.obj -o $in/locked && says locked
  refused 1 study $in/cube.obj -o $in/locked/study && says locked
fi
# --- options --------------------------------------------------------------------------------------------------------
refused 2 study $in/cube.obj && says --output
refused 2 study -o study && says SCENE
refused 2 study $in/cube.obj -o study --degree 33 && says --degree
refused 2 study $in/cube.obj -o study --degree auto && says --degree
refused 2 study $in/cube.obj -o study --rays 0 && says --rays
refused 2 study $in/cube.obj -o study --error 0 && says --error
refused 2 study $in/cube.obj -o study --layout latlong && says --layout
refused 2 study $in/cube.obj $l -o study --layout latlong && says --layout
refused 2 study $in/cube.obj $l $l -o study
finish
