#!/usr/bin/env bash
# What codegen refuses.
# Usage: bad_codegen_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/refusals.sh"
"$shprt" convert $l -o ../in/degree13.json --degree 13 --quiet
sed 's/\[0.886226925452757[0-9]*,/[1e300,/' $l >../in/huge.json

refused 2 codegen && says --language
refused 2 codegen --language && says --language
for language in '' python GLSL glsl,c; do
  refused 2 codegen --language "$language" -o out.txt && says "glsl, hlsl, wgsl, c"
done
for degree in -1 13 1e9 2.5 x ''; do
  refused 2 codegen --language c --degree "$degree" -o out.h && says 'from 0 to 12'
done
for what in '' rays basis, ,basis basis,,rotation 'basis rotation' Basis; do
  refused 2 codegen --language c --what "$what" -o out.h && says 'basis, evaluate, irradiance, rotation'
done
refused 2 codegen --language c --degree 9 --what rotation -o out.h && says 'degree 8'
refused 2 codegen --language c --type half -o out.h && says --type
refused 2 codegen --language glsl --type double -o out.glsl && says --type
refused 2 codegen --language c -o same.h --json same.h && says --json
refused 2 codegen --language c --json - && says --json
refused 2 codegen --language c extra
refused 1 codegen --language c -o missing-folder/out.h && says missing-folder
refused 1 codegen --language c -o $in/folder && says folder
refused 1 codegen --language c -o $in/full.json && says full.json
refused 1 codegen --language c --json missing-folder/figures.json && says missing-folder
refused 1 codegen --language c --light missing.json -o out.h && says missing.json
refused 1 codegen --language c --light '' -o out.h
refused 1 codegen --language c --light $in/broken.json -o out.h && says broken.json
refused 1 codegen --language c --light $in/probe.pfm -o out.h && says probe.pfm
refused 1 codegen --language c --light $l -o $l && says input
refused 1 codegen --language c --light $in/degree13.json -o out.h && says --degree
refused 1 codegen --language glsl --light $in/huge.json -o out.h && says '1e+300 does not fit'
full_disk codegen --language c --degree 4 -o out.h

finish
