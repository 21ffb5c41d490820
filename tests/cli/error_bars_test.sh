#!/usr/bin/env bash
# Standard errors through the command line: relight --error-bars, info and diff, on errors that are known.
# Usage: error_bars_test.sh SHPRT WORK_DIR ADD_ERRORS
set -euo pipefail
shprt=$1 work=$2 add_errors=$3
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# errors FILE VALUE: the last three columns of every CSV row, to the digits given here.
errors() {
  awk -F, -v want="$2" '
    NR > 1 { for (i = 10; i <= 12; ++i) if ($i > want * (1 + 4e-6) || $i < want * (1 - 4e-6)) bad = 1 }
    END { exit bad || NR < 2 }' "$1"
}

quiet bake cube.obj -o plain.prt.exr --albedo 1
quiet bake cube.obj -o coloured.prt.exr --albedo 0.2,0.4,0.6
"$add_errors" plain.prt.exr cube.prt.exr 0.01
"$add_errors" coloured.prt.exr three.prt.exr 0.01

# --- relight --------------------------------------------------------------------------------------------------------
# Radiance 1 from everywhere is sqrt(4 pi) in band 0. Of a directional light of irradiance pi, band l sends (2l+1)/4 P_l(z) from
# height z; 0.01 sum_l sqrt(4 pi/(2l+1)) times that, squared, has a mean over each side's hemisphere, by quadrature of its own.
quiet relight plain.prt.exr constant.json -o plain.csv
for asset in cube three; do
  quiet relight $asset.prt.exr constant.json -o constant.csv --error-bars
  check "the header has errors" test "$(head -n 1 constant.csv)" = x,y,z,nx,ny,nz,r,g,b,r_error,g_error,b_error
  check "errors under even light" errors constant.csv 0.03544907701811032
  quiet relight $asset.prt.exr above.json -o above.csv --error-bars
  check "errors above under a sun" errors <(awk -F, 'NR == 1 || $5 > 0.9' above.csv) 0.03684775
  check "errors below" errors <(awk -F, 'NR == 1 || $5 < -0.9' above.csv) 0.005939382
  check "errors of the sides" errors <(awk -F, 'NR == 1 || ($5 > -0.1 && $5 < 0.1)' above.csv) 0.013539133
done
quiet relight cube.prt.exr constant.json -o constant.csv --error-bars
check "radiance stays as it was" cmp plain.csv <(cut -d, -f1-9 constant.csv)
quiet relight cube.prt.exr constant.json -o without.csv
check "no errors unasked" cmp plain.csv without.csv
quiet relight cube.prt.exr above.json -o turned.csv --error-bars --rotate axis:1,0,0,180
check "a sun from below" errors <(awk -F, 'NR == 1 || $5 < -0.9' turned.csv) 0.03684775
quiet relight cube.prt.exr constant.json -o brighter.csv --error-bars --exposure 1
check "exposure scales errors" errors brighter.csv 0.07089815403622064
run relight cube.prt.exr constant.json -o - --error-bars --json figures.json >stdout.csv 2>summary.txt
check "csv on standard output" cmp constant.csv stdout.csv
check "relative to radiance 1" grep -qE '^standard error +3.54% of the RMS radiance; at most 3.54%, at vertex [0-9]+$' summary.txt
check "figures" grep -qE '"relativeRms": 0.035449' figures.json
run relight cube.prt.exr constant.json -o without.csv --json figures.json >summary.txt
check "no figures unasked" grep -q '"standardError": null' figures.json
exits 1 grep -q 'standard error' summary.txt
quiet relight cube.prt.exr constant.json -o radiance.json --error-bars
check "json has an array more" test "$(grep -c '^\[' radiance.json)" = 96
check "json names it" grep -q '"standardErrors":\[' radiance.json
quiet relight cube.prt.exr constant.json -o cube.ply --error-bars
check "ply has errors" grep -qa 'property float radiance_error_b' cube.ply
check "the ply is a mesh again" grep -q '"triangles": 12' <(run info cube.ply --json)
run relight cube.prt.exr above.json -o spin.png --error-bars --size 32x32 --samples 1 --turntable 2 >summary.txt
check "pictures tell it" grep -q '^standard error' summary.txt
check "and are written" test -s spin_0002.png
quiet relight cube.prt.exr constant.json -o one_thread.csv --error-bars --threads 1
check "threads do not matter" cmp constant.csv one_thread.csv

# A lamp of radiance 1: emission is what --emission scales, errors with it, and squares add.
printf '{"objects":[{"file":"cube.obj","material":{"emission":1,"albedo":0.5}}]}' >lamp.json
quiet bake lamp.json -o lamp.prt.exr
"$add_errors" lamp.prt.exr uncertain.prt.exr 0.01 0.02
quiet relight uncertain.prt.exr -o lamp.csv --error-bars --emission 3
check "errors of emission alone" errors lamp.csv 0.06
quiet relight uncertain.prt.exr constant.json -o lamp.csv --error-bars --emission 3
check "errors of both" errors lamp.csv 0.0696895764188298
"$add_errors" lamp.prt.exr silent.prt.exr 0.01
run relight silent.prt.exr constant.json -o lamp.csv --error-bars >/dev/null 2>note.txt
check "emission taken for exact" errors lamp.csv 0.03544907701811032
check "and told so" grep -q 'taken for exact' note.txt
printf '{"lights":[{"type":"constant","radiance":[0,0,0]}]}' >dark.json
run relight cube.prt.exr dark.json -o dark.csv --error-bars --json figures.json >summary.txt
check "relative to nothing" grep -q '"relativeRms": null' figures.json
check "in the dark" grep -qE '^standard error +0, at most 0, where all radiance is 0$' summary.txt

# --- info and diff --------------------------------------------------------------------------------------------------
# 0.01 sqrt(5) over the norm of the unshadowed transfer, sqrt(1/(4 pi) + 1/(3 pi) + 5/(64 pi) + 1/(256 pi)).
run info uncertain.prt.exr >info.txt
check "part error" grep -qE '^part error +24 x 5, Y float, scan lines, none$' info.txt
check "part emissionError" grep -qE '^part emissionError +24 x 1, B,G,R float, scan lines, none$' info.txt
run info cube.prt.exr >info.txt
check "standard error of the transfer" grep -qE '^standard error +0.0486 of the unshadowed transfer, RMS$' info.txt
check "what the bake measured" grep -qE '^sampling error +0.0625 of the unshadowed transfer' info.txt
check "vertices by rays" grep -qE '^vertices by rays +32: 1, 64: 23$' info.txt
run info uncertain.prt.exr --json >info.json
check "errors relative to what they are of" grep -qE '"emission": 0.0(2|199999)' info.json
check "the histogram" test "$(tr -d ' \n' <info.json | grep -o '"verticesByRays":\[\[32,1\],\[64,23\]\]')"
check "null without" grep -q '"standardError": null' <(run info plain.prt.exr --json)
exits 1 run diff cube.prt.exr plain.prt.exr
check "diff names the part" grep -q 'error: only one of them has any' <(run diff cube.prt.exr plain.prt.exr || true)
"$add_errors" plain.prt.exr less.prt.exr 0.009
exits 0 run diff cube.prt.exr cube.prt.exr
exits 1 run diff cube.prt.exr less.prt.exr
exits 0 run diff cube.prt.exr less.prt.exr --atol 0.0011

finish
