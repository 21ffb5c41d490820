#!/usr/bin/env bash
# Lights on the command line: high degrees, other tools' conventions and back, windows, the dominant light.
# Usage: light_job_test.sh SHPRT WORK_DIR CHECK_DIRECTIONAL SHARED_DIR
set -euo pipefail
shprt=$1 work=$2 check_directional=$3 reference=$4/reference/sh_eval.json
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# sun FILE X Y Z: a directional light of irradiance 2.
sun() { echo "{\"lights\":[{\"type\":\"directional\",\"direction\":[$2,$3,$4],\"irradiance\":[2,2,2]}]}" >"$1"; }
is_sun() { "$check_directional" "$@" >/dev/null; }

# --- high degrees ---------------------------------------------------------------------------------------------------
sun tilted.json 0.3 -0.5 0.8
quiet project-probe tilted.json -o tilted60.json --degree 60
check "degree 60 is evaluateSh" is_sun tilted60.json 0.3 -0.5 0.8 2 1e-15
exits 1 "$check_directional" tilted60.json 0.3 -0.5 0.8001 2 1e-15
exits 1 "$check_directional" tilted60.json 0.3 -0.5 0.8 2.0001 1e-15
# Turned by half a turn about y and a quarter turn about x, the sun is where its direction is.
quiet convert tilted60.json -o half.json --rotate axis:0,1,0,180
quiet convert tilted60.json -o quarter.json --rotate axis:1,0,0,90
check "half a turn at degree 60" is_sun half.json -0.3 -0.5 -0.8 2 1e-13
check "a quarter turn at degree 60" is_sun quarter.json 0.3 -0.8 -0.5 2 1e-13
quiet project-probe tilted.json -o turned.json --degree 60 --rotate axis:1,0,0,90
check "turned before or after" is_sun turned.json 0.3 -0.8 -0.5 2 1e-13
run project-probe tilted.json --degree 60 >high.txt
check "high bands are summed up" grep -q 'energy above' high.txt
check "no line for band 33" test "$(grep -c 'energy of band' high.txt)" = 33
exits 2 run project-probe probe.pfm --degree 33
exits 1 run project-probe tilted.json --degree 60 --window auto
echo '{"lights":[{"type":"probe","file":"probe.pfm"}]}' >image_list.json
exits 1 run project-probe image_list.json --degree 33
exits 0 run project-probe image_list.json --degree 32
if [ -f "$reference" ]; then
  # Of the band's scale; sh/basis.h promises 3e-14 and the file rounds nothing.
  reference_sun() { # NAME X Y Z
    sun "$1.json" "$2" "$3" "$4"
    quiet project-probe "$1.json" -o high.json --degree 1000
    check "$1 at degree 1000" is_sun high.json "$2" "$3" "$4" 2 5e-14 "$reference" "$1"
    rm high.json
  }
  reference_sun random0 0.9376193694218604 -0.340701264240243 0.06922836579071423
  reference_sun pole+_tilt_1e-8 9.38432720586074e-09 -3.454620513651529e-09 1.0
  # The light of +Z, turned to random0: a thousand times the rounding of the angles.
  sun above.json 0 0 1
  quiet project-probe above.json -o above_high.json --degree 1000
  quiet convert above_high.json -o turned_high.json --rotate euler:zyz,-19.969546006975378,86.03033168468286,0
  check "turned at degree 1000" is_sun turned_high.json 0.9376193694218604 -0.340701264240243 0.06922836579071423 2 1e-12 "$reference" random0
  rm above_high.json turned_high.json
  sun other.json 0.9376193694218604 -0.340701264240243 0.07
  quiet project-probe other.json -o other_high.json --degree 200
  exits 1 "$check_directional" other_high.json 0.9376193694218604 -0.340701264240243 0.07 2 5e-14 "$reference" random0
else
  echo "SKIPPED: no reference values in $reference"
fi

# --- conventions ----------------------------------------------------------------------------------------------------
quiet project-probe probe.pfm -o probe2.json --degree 2
quiet project-probe probe.pfm -o probe6.json --degree 6
for name in condon-shortley l1-vector three.js unity unreal filament gltf; do
  quiet convert probe2.json -o "$name.json" --convention $name
  check "$name names itself" grep -q "\"convention\": \"$name\"" "$name.json"
  quiet convert "$name.json" -o back.json
  exits 0 run diff probe2.json back.json --atol 1e-14
done
exits 2 run diff probe2.json unity.json                              # not read as this project's own
# From one convention to another, turned on the way: Unity's file of the turned light.
quiet convert filament.json -o both.json --convention unity --rotate axis:1,0,0,90
quiet convert probe2.json -o turned2.json --rotate axis:1,0,0,90
quiet convert both.json -o back.json
exits 0 run diff turned2.json back.json --atol 1e-14
# Constant light is 1 in premultiplied conventions, sqrt(4 pi) in others; a sun along +X is where engines expect it.
quiet project-probe constant.json -o constant_sh.json
quiet convert constant_sh.json -o - --convention unity | tr -d ' \n' >unity_constant.txt
check "premultiplied constant" grep -qE '"coefficients":\[\[(1.0|0.9999999999999999?[0-9]*|1.000000000000000[0-9]*),' unity_constant.txt
quiet convert constant_sh.json -o - --convention three.js | tr -d ' \n' >three_constant.txt
check "plain constant" grep -q '"coefficients":\[\[3.54490770181103' three_constant.txt
# Bands that have no place are dropped, with a word; condon-shortley holds them all.
run convert probe6.json -o cut.json --convention filament --json cut_figures.json >/dev/null 2>cut_note.txt
check "a note on dropped bands" grep -q 'filament holds bands 0 to 2.*of the light' cut_note.txt
check "a figure of dropped energy" grep -q '"energyDropped"' cut_figures.json
run convert probe6.json -o all.json --convention condon-shortley >/dev/null 2>all_note.txt
check "nothing dropped, nothing said" test ! -s all_note.txt
quiet convert all.json -o back.json
exits 0 run diff probe6.json back.json
# Layouts of fixed size are padded.
quiet project-probe probe.pfm -o probe1.json --degree 1
quiet convert probe1.json -o padded.json --convention unreal
check "unreal always has nine" test "$(grep -c '^    \[' padded.json)" = 9

# --- windows and the dominant light ---------------------------------------------------------------------------------
for window in gaussian auto auto-radiance; do
  run project-probe tilted.json -o window.json --degree 4 --window $window >"$window.txt"
  check "$window is told" grep -q "window  *$window, strength" "$window.txt"
done
check "auto-radiance leaves none negative" grep -qE 'least radiance +[0-9.]+(e-[0-9]+)? of' auto-radiance.txt
check "auto leaves the radiance ringing" grep -q 'least radiance  *-.*--window auto-radiance mends that' auto.txt
cat >sky.json <<'JSON'
{"lights":[{"type":"directional","direction":[0,3,4],"irradiance":[3,2,1]},{"type":"constant","radiance":[0.25,0.5,1]}]}
JSON
run project-probe sky.json -o sky_sh.json >sky.txt
check "the dominant light" grep -qE 'dominant light +3 +2 +1$' sky.txt
check "its ambient rest" grep -qE 'ambient rest +0.25 +0.5 +1$' sky.txt
for command in "info sky_sh.json" "convert sky_sh.json -o same.json"; do
  check "$command shows it" grep -qE 'dominant light +3 +2 +1$' <(run $command)
done
check "the figures have it" grep -q '"dominantLight"' <(run info sky_sh.json --json)
check "even light has none" grep -q 'dominant light *none' <(run info constant.json)

finish
