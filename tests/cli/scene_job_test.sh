#!/usr/bin/env bash
# Scenes on the command line: several meshes, roles, materials, light of the scene's own, plans, refinement and fits, with
# numbers that can be worked out by hand.
# Usage: scene_job_test.sh SHPRT WORK_DIR
set -euo pipefail
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# near FILE VALUE TOLERANCE: columns r, g, b of every CSV row.
near() {
  awk -F, -v want="$2" -v tolerance="$3" '
    NR > 1 { for (i = 7; i <= 9; ++i) if ($i - want > tolerance || want - $i > tolerance) bad = 1 }
    END { exit bad || NR < 2 }' "$1"
}
figure() { grep -o "\"$2\": [^,]*" "$1" | head -n 1 | sed 's/.*: //'; }

# A floor of two triangles, and a lid above it; the lid faces down with `f 1 2 3 4`.
printf 'v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nf 1 2 3 4\n' >floor.obj
printf 'v -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nf 1 2 3 4\n' >lid.obj
cat >room.json <<'JSON'
{"objects": [
  {"file": "floor.obj", "material": {"albedo": 0.5}},
  {"name": "lamp", "file": "lid.obj", "role": "blocker", "material": {"albedo": 0, "emission": [2, 1, 0]}}]}
JSON
cat >two.json <<'JSON'
{"objects": [
  {"name": "left", "file": "cube.obj", "transform": {"translate": [-5, 0, 0]}, "material": {"albedo": [0.2, 0.4, 0.8]}},
  {"name": "right", "file": "cube.obj", "transform": {"translate": [5, 0, 0], "scale": [1, 2, -1]}}]}
JSON

# --- plan -----------------------------------------------------------------------------------------------------------
run plan cube.obj >plan.txt
check "a convex mesh calls for nothing" grep -q '^bake: unshadowed' plan.txt
run plan corner.obj --json plan.json >plan.txt
check "a corner calls for bounces" grep -q '^bake: interreflected' plan.txt
check "the table has its lines" test "$(grep -cE '^(shadows|interreflection|emission|degree|colour|near field|glossy|translucency) ' plan.txt)" = 8
check "plan is JSON with effects" grep -q '"effects"' plan.json
run plan corner.obj --albedo 0 >black.txt
check "black surfaces bounce nothing" grep -q '^bake: shadowed' black.txt
run plan corner.obj constant.json --degree auto >constant.txt
check "constant light calls for degree 0" grep -q 'degree 0,' constant.txt

# --- effects --------------------------------------------------------------------------------------------------------
quiet bake cube.obj -o convex.prt.exr --json convex.json
check "a convex mesh traces nothing" test "$(figure convex.json rays)" = 0
check "and says what it is" test "$(figure convex.json model)" = '"unshadowed"'
quiet bake cube.obj -o everything.prt.exr --effects all --json everything.json
check "all traces" test "$(figure everything.json raysSpared)" = 0
check "all is interreflected" test "$(figure everything.json model)" = '"interreflected"'
exits 0 run diff convex.prt.exr everything.prt.exr --atol 1e-6
quiet bake corner.obj -o auto.prt.exr --rays 64
quiet bake corner.obj -o named.prt.exr --rays 64 --effects shadows,interreflection
exits 0 run diff auto.prt.exr named.prt.exr                 # the plan changes what is simulated, not how
quiet bake corner.obj -o once.prt.exr --rays 64 --model interreflected --bounces 1
exits 1 run diff auto.prt.exr once.prt.exr
quiet bake corner.obj -o none.prt.exr --rays 64 --effects none
quiet bake corner.obj -o open.prt.exr --rays 64 --model unshadowed
exits 0 run diff none.prt.exr open.prt.exr
quiet bake corner.obj -o small.prt.exr --rays 64 --memory 1K --json small.json
exits 0 run diff auto.prt.exr small.prt.exr                 # little memory, the same bits
check "and traces anew" test "$(figure small.json retracedPoints)" -gt 0
quiet bake corner.obj -o light.prt.exr --degree auto --light constant.json
check "degree for a light" grep -q 'degree 0' <(run info light.prt.exr)
check "the asset tells the plan" grep -q '^plan interreflection  *needed' <(run info auto.prt.exr)

# --- scenes ---------------------------------------------------------------------------------------------------------
quiet bake two.json -o two.prt.exr
check "both cubes" grep -q '48 vertices' <(run info two.prt.exr)
quiet relight two.prt.exr constant.json -o two.csv
check "placed" awk -F, 'NR > 1 { x = $1 < 0 ? -$1 : $1; if (x < 4 || x > 6) exit 1 }' two.csv
check "albedo by object" awk -F, 'NR > 1 { want = $1 < 0 ? 0.4 : 0.8; d = $8 - want; if (d < -0.02 || d > 0.02) exit 1 }' two.csv
quiet bake two.json -o two.prt.exr --per-mesh
check "one asset each" test -s two_left.prt.exr -a -s two_right.prt.exr
quiet relight two_left.prt.exr constant.json -o left.csv
check "of its own object" awk -F, 'NR > 1 && $1 > 0 { exit 1 }' left.csv
check "with all its vertices" test "$(wc -l <left.csv)" = 25

run info two.json >two.txt
check "info tells objects and materials" test "$(grep -cE 'left: OBJ|right: OBJ|^material ' two.txt)" -ge 4

# --- light of the scene's own ---------------------------------------------------------------------------------------
# The lamp's square above the corner of a floor as large, side 2, at height 1: point form factor 0.20776 (A = B = 2 in
# F = (1/2 pi) (A/sqrt(1+A^2) atan(B/sqrt(1+A^2)) + B/sqrt(1+B^2) atan(A/sqrt(1+B^2)))). Radiance = 0.5 F emission.
run bake room.json -o room.prt.exr --rays 4096 >room.txt
check "the lamp is not baked" grep -q '4 vertices, 2 triangles' <(run info room.prt.exr)
check "emission is told" grep -q '^emission  *0' <(run info room.prt.exr)
quiet relight room.prt.exr -o alone.csv
check "form factor" awk -F, 'NR > 1 { d = $7 - 0.20776; e = $8 - 0.10388; if (d < -0.002 || d > 0.002 || e < -0.001 || e > 0.001 || $9 != 0) exit 1 }' alone.csv
quiet relight room.prt.exr -o half.csv --emission 0.5
check "emission scales" awk -F, 'NR == FNR { r[FNR] = $7; next } FNR > 1 { d = $7 - r[FNR] / 2; if (d < -1e-6 || d > 1e-6) exit 1 }' alone.csv half.csv
quiet relight room.prt.exr constant.json -o both.csv
quiet relight room.prt.exr constant.json -o sky.csv --emission 0
check "emission adds up" awk -F, 'FILENAME == "alone.csv" { e[FNR] = $7; next } FILENAME == "sky.csv" { s[FNR] = $7; next }
  FNR > 1 { d = $7 - e[FNR] - s[FNR]; if (d < -1e-5 || d > 1e-5) exit 1 }' alone.csv sky.csv both.csv
check "what the lamp hides" awk -F, 'NR > 1 { d = $7 - 0.5 * (1 - 0.20776); if (d < -0.002 || d > 0.002) exit 1 }' sky.csv
quiet relight room.prt.exr constant.json -o spin.png --turntable 2 --size 32x32 --emission 2
quiet bake room.json -o dark.prt.exr --model unshadowed
quiet relight dark.prt.exr constant.json -o dark.csv
check "unshadowed" near dark.csv 0.5 1e-6
check "and says that the lamp lights nothing" grep -q 'lamps' <(run bake room.json -o dark.prt.exr --model unshadowed 2>&1)

# --- refinement, fit ------------------------------------------------------------------------------------------------
quiet bake room.json -o fine.prt.exr --max-edge 0.5 --json fine.json
check "edges split" test "$(figure fine.json vertices)" -ge 25
quiet relight fine.prt.exr -o fine.csv
check "no edge of the floor is longer than a half" test "$(wc -l <fine.csv)" -ge 26
quiet bake room.json -o adaptive.prt.exr --max-edge auto
check "refinement is told" grep -q 'refined' <(run bake room.json -o again.prt.exr --max-edge auto)
quiet bake room.json -o fitted.prt.exr --fit --rays 64
exits 0 run diff room.prt.exr fitted.prt.exr --atol 0.3
exits 1 run diff room.prt.exr fitted.prt.exr
quiet bake room.json -o one.prt.exr --rays 64 --threads 1
quiet bake room.json -o many.prt.exr --rays 64 --threads 2
exits 0 run diff one.prt.exr many.prt.exr

finish
