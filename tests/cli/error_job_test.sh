#!/usr/bin/env bash
# Bakes that are asked for an error or a time instead of rays, and the standard errors that they store.
# Usage: error_job_test.sh SHPRT WORK_DIR SOURCE_DIR
set -euo pipefail
shprt=$1 work=$2 source=$3
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# figure FILE NAME: the first number of that name. sampling FILE NAME: the first behind "sampling".
figure() { grep -o "\"$2\": [^,]*" "$1" | head -n 1 | sed 's/.*: //' || true; }
sampling() { figure <(sed -n '/"sampling"/,$p' "$1") "$2"; }
# total FILE LIST NAME: the sum of NAME over the list.
total() { awk -v list="\"$2\": " -v name="\"$3\": " '
  index($0, list) { inside = 1; next }
  inside && /\]/ { exit }
  inside && index($0, name) { sub(/.*: /, ""); sum += $0 }
  END { print sum + 0 }' "$1"; }
at_most() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 <= b + 0) }'; }

# --- an error -------------------------------------------------------------------------------------------------------
knot="$source/data/knot.ply --model shadowed --degree 2 --error 0.03 --error-part"
# shellcheck disable=SC2086
run bake $knot -o knot.prt.exr --threads 1 --json knot.json >knot.txt
error=$(sampling knot.json error) bound=$(sampling knot.json errorBound)
check "the error and its confidence" grep -qE '^error  *sampling leaves [0-9.]+% .*at most [0-9.]+% with 95% confidence' knot.txt
check "where the rays went" grep -qE '^rays per vertex .*exact #* ?[0-9]' knot.txt
check "the bound keeps the request ($bound)" at_most "$bound" 0.03
check "and is one ($error)" at_most "$error" "$bound"
check "no more rays than it takes" at_most 0.009 "$error"
check "what was asked for" grep -q '"asked": 0.03' knot.json
check "all together" at_most "$(sampling knot.json errorInAll)" 0.03
check "every vertex has its rays" test "$(total knot.json verticesByRays vertices)" = "$(figure knot.json vertices)"
check "some more, some less" test "$(sed -n '/verticesByRays/,/passes/p' knot.json | grep -c '"rays"')" -ge 3
check "all rays are of some pass" test "$(total knot.json passes rays)" = "$(figure <(sed -n '/"counts"/,$p' knot.json) rays)"
check "more than one pass" test "$(grep -A 99 '"passes"' knot.json | grep -c '"error"')" -ge 2
# shellcheck disable=SC2086
quiet bake $knot -o knot2.prt.exr --threads 2
exits 0 run diff knot.prt.exr knot2.prt.exr                            # one thread, two threads: the same bits
run info knot.prt.exr --json >info.json
check "the asset has the errors" grep -q '"name": "error"' info.json
check "and what was measured" test "$(sampling info.json errorBound)" = "$bound"
check "vertices by rays, too" grep -q '"verticesByRays":\[\[0,86\],' <(tr -d ' \n' <info.json)

# Against many more rays and bounces. 0.8 sqrt(1/(4 pi) + 1/(3 pi) + 5/(64 pi) + 1/(256 pi)): the norm of the unshadowed
# transfer, of 25 coefficients. 50 vertices, so that the true error may exceed its expectation.
run bake corner.obj -o corner.prt.exr --error 0.03 --json corner.json >corner.txt
quiet bake corner.obj -o best.prt.exr --model interreflected --rays 8192 --bounces 30 --seed 9 --json best.json
check "nothing is measured unasked" test -z "$(grep '"sampling"' best.json)"
run diff corner.prt.exr best.prt.exr --json difference.json >/dev/null || true
error=$(awk -v rms="$(figure difference.json rmsError)" 'BEGIN { print 5 * rms / (0.8 * 0.460209) }')
check "the true error keeps the request ($error)" at_most "$error" 0.03
check "bounces have the other half" at_most "$(figure corner.json remainder)" 0.015

# --- a time ---------------------------------------------------------------------------------------------------------
run bake corner.obj -o timed.prt.exr --degree 2 --time 0.5 --json timed.json >timed.txt
check "tells the error" grep -q '^error ' timed.txt
check "which nobody asked for" test -z "$(grep '"asked"' timed.json)"
run bake corner.obj -o short.prt.exr --time 0.01 --error 0.00001 >short.txt 2>note.txt
check "no time for that" grep -q 'the error asked for was not reached: the time was over' note.txt
check "all the same an asset" test -s short.prt.exr

# --- rays that are given stay ---------------------------------------------------------------------------------------
run bake corner.obj -o part.prt.exr --rays 64 --error-part --json part.json >part.txt
check "measured on request" at_most 0.001 "$(sampling part.json error)"
check "of 64 rays" test "$(figure part.json raysPerVertex)" = 64
check "all alike" test -z "$(grep '^rays per vertex' part.txt)"

# --- error bars -----------------------------------------------------------------------------------------------------
run relight part.prt.exr front.json -o bars.csv --error-bars >bars.txt
check "columns of errors" test "$(head -n 1 bars.csv)" = x,y,z,nx,ny,nz,r,g,b,r_error,g_error,b_error
check "every vertex has one" awk -F, 'NR > 1 && !($10 > 0) { exit 1 }' bars.csv
check "told" grep -qE '^standard error +[0-9.]+% of the RMS radiance' bars.txt
quiet bake cube.obj -o exact.prt.exr --error 0.01 --error-part
quiet relight exact.prt.exr front.json -o exact.csv --error-bars
check "none where transfer is exact" awk -F, 'NR > 1 { bad += $10 != 0 || $11 != 0 || $12 != 0 || NF != 12 } END { exit bad || NR != 25 }' exact.csv
# A floor and a wall that send out light, and a cube: an asset each, with the errors of its own vertices.
printf '{"objects":[{"name":"corner","file":"corner.obj","material":{"emission":1}},
  {"name":"cube","file":"cube.obj","transform":{"translate":[2,3,2]}}]}' >lamp.json
quiet bake lamp.json -o lamp.prt.exr --time 600 --error 0.1 --error-part --per-mesh --json lamp_figures.json
check "ends when the error is reached" at_most "$(figure lamp_figures.json totalSeconds)" 100
check "which it is" at_most "$(sampling lamp_figures.json errorInAll)" 0.1
run info lamp_cube.prt.exr >lamp.txt
check "errors of the object's transfer" grep -qE '^part error +24 x 5' lamp.txt
check "and of its emission" grep -qE '^part emissionError +24 x 1' lamp.txt

finish
