#!/usr/bin/env bash
# The main job on inputs written here: bake, project, relight, convert, diff, info; the numbers against closed forms.
# Usage: main_job_test.sh SHPRT WORK_DIR
set -euo pipefail
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"

# near FILE VALUE TOLERANCE: columns r, g, b of every CSV row.
near() {
  awk -F, -v want="$2" -v tolerance="$3" '
    NR > 1 { for (i = 7; i <= 9; ++i) if ($i - want > tolerance || want - $i > tolerance) bad = 1 }
    END { exit bad || NR < 2 }' "$1"
}

# --- bake -----------------------------------------------------------------------------------------------------------
quiet bake cube.obj -o cube.prt.exr --albedo 1 --json cube_bake.json
quiet bake cube.obj -o cube_unshadowed.prt.exr --albedo 1 --model unshadowed
quiet bake corner.obj -o corner.prt.exr --threads 1 --rays 64
quiet bake corner.obj -o corner2.prt.exr --threads 2 --rays 64
quiet bake corner.obj -o other_albedo.prt.exr --albedo 0.5 --rays 64
quiet bake corner.obj -o other_seed.prt.exr --seed 7 --rays 64
quiet bake corner.obj -o coloured.prt.exr --albedo 0.2,0.4,0.6 --rays 64 --half --compression zip --degree 2
exits 0 run diff corner.prt.exr corner2.prt.exr                       # one thread, two threads: the same bits
exits 0 run diff cube.prt.exr cube_unshadowed.prt.exr --atol 1e-6     # a convex mesh has no shadows
exits 1 run diff corner.prt.exr other_albedo.prt.exr
exits 1 run diff corner.prt.exr other_seed.prt.exr
exits 0 run diff corner.prt.exr other_seed.prt.exr --atol 0.05
exits 2 run diff corner.prt.exr cube.prt.exr                          # other vertices
exits 2 run diff corner.prt.exr coloured.prt.exr                      # other degree
exits 2 run diff corner.prt.exr probe.pfm
exits 2 run diff corner.prt.exr missing.prt.exr
check "a closed cube sees everything" grep -q '"meanVisibility": 1.0' cube_bake.json
check "hard edges: 24 vertices" grep -q '"vertices": 24' cube_bake.json
check "bake says what it did" run bake corner.obj -o corner_again.prt.exr >summary.txt
for word in '50 vertices' '64 triangles' 'Mrays/s' '0.8 grey' 'mean visibility' 'interreflection' 'corner_again.prt.exr'; do
  check "the summary mentions $word" grep -q "$word" summary.txt
done
quiet bake cube.obj -o nothing.prt.exr >quiet.txt 2>&1
check "--quiet prints nothing" test ! -s quiet.txt

# --- relight: numbers -----------------------------------------------------------------------------------------------
# Constant radiance 1 on albedo 1: radiance 1 everywhere, to the rounding of float.
quiet relight cube.prt.exr constant.json -o constant.csv
check "header" test "$(head -n 1 constant.csv)" = x,y,z,nx,ny,nz,r,g,b
check "a line per vertex" test "$(wc -l <constant.csv)" = 25
check "a white furnace" near constant.csv 1 1e-6
# A directional light of irradiance pi from above: (1/4 + 1/2 + 5/16 - 9/96) = 0.96875 at degree 4 on the top, the sum of
# A_l (2l+1)/(4 pi) P_l(1).
quiet relight cube.prt.exr above.json -o above.csv
awk -F, 'NR == 1 || $5 > 0.9' above.csv >top.csv
check "the top has four vertices" test "$(wc -l <top.csv)" = 5
check "radiance of the top" near top.csv 0.96875 1e-6
# Two lights add up; exposure doubles.
quiet relight cube.prt.exr constant.json constant.json -o twice.csv
quiet relight cube.prt.exr constant.json -o doubled.csv --exposure 1
check "lights add up" near twice.csv 2 2e-6
check "one stop doubles" near doubled.csv 2 2e-6
# Standard output carries the data and nothing else.
run relight cube.prt.exr constant.json -o - >stdout.csv 2>stderr.txt
check "csv on standard output" cmp constant.csv stdout.csv
check "results for people go elsewhere" grep -q 'cube.prt.exr' stderr.txt
quiet relight cube.prt.exr constant.json -o - --format json >stdout.json
quiet relight cube.prt.exr constant.json -o constant_radiance.json
check "json on standard output" cmp constant_radiance.json stdout.json
check "json has its format" grep -q '"format":"shprt-radiance","version":1,"vertexCount":24' stdout.json
check "positions, normals, radiance: 24 each" test "$(grep -c '^\[' stdout.json)" = 72
quiet relight cube.prt.exr constant.json -o one_thread.csv --threads 1
quiet relight cube.prt.exr constant.json -o two_threads.csv --threads 2
check "threads do not matter" cmp one_thread.csv two_threads.csv
# Where degrees differ, it says so and uses what both have.
quiet project-probe above.json -o above1.json --degree 1
run relight cube.prt.exr above1.json -o above1.csv >/dev/null 2>note.txt
check "the note on degrees" grep -q 'above1.json has degree 1, the asset 4' note.txt
awk -F, 'NR == 1 || $5 > 0.9' above1.csv >top1.csv
check "degree 1 gives 1/4 + 1/2" near top1.csv 0.75 1e-6

# --- rotation -------------------------------------------------------------------------------------------------------
# A quarter turn about +y takes +z to +x.
quiet project-probe front.json -o front_sh.json
quiet project-probe right.json -o right_sh.json
quiet project-probe front.json -o front_turned.json --rotate axis:0,1,0,90
quiet convert front_sh.json -o front_converted.json --rotate quat:1,0,1,0
exits 0 run diff front_turned.json right_sh.json --atol 1e-12
exits 0 run diff front_converted.json right_sh.json --atol 1e-12
exits 1 run diff front_sh.json right_sh.json
echo 'matrix:0,0,1,0,1,0,-1,0,0' >turn.txt
quiet relight corner.prt.exr front_sh.json -o rotated.csv --rotate @turn.txt
run convert front_sh.json -o mended.json --rotate 'matrix:1,0,1e-4,0,1,0,-1e-4,0,1' >/dev/null 2>note.txt
check "a matrix off by rounding is told" grep -q 'the matrix is off by 5e-09' note.txt
quiet relight corner.prt.exr right_sh.json -o right.csv
awk -F, 'NR == FNR { for (i = 1; i <= 9; ++i) a[FNR, i] = $i; next }
         FNR > 1 { for (i = 1; i <= 9; ++i) if (a[FNR, i] - $i > 1e-6 || $i - a[FNR, i] > 1e-6) bad = 1 }
         END { exit bad }' rotated.csv right.csv || fail "rotating the light equals the rotated light"
quiet convert front_sh.json -o front0.json --degree 0
check "convert cuts bands" grep -q '"degree": *0' front0.json
quiet convert front_sh.json -o same.json
exits 0 run diff front_sh.json same.json

# --- probes ---------------------------------------------------------------------------------------------------------
run project-probe probe.pfm -o probe.json --json probe_figures.json >probe.txt
check "the average of 1 and 1/2" grep -qE 'average radiance +0.75 +0.75 +0.75' probe.txt
check "the light comes from above" grep -qE 'dominant direction +[-0-9.e]+ +1 ' probe.txt
check "the layout and why" grep -q 'layout latlong' probe.txt
for field in averageRadiance dominantDirection directionality bandEnergy energyMissed solidAngle; do
  check "figures have $field" grep -q "\"$field\"" probe_figures.json
  check "the light file has $field" grep -q "\"$field\"" probe.json
done
run project-probe probe.pfm -o - --quiet >probe_stdout.json
check "light on standard output" cmp probe.json probe_stdout.json
quiet project-probe probe.pfm -o bright.json --exposure 1
quiet relight cube.prt.exr probe.json -o from_light.csv --exposure 1
quiet relight cube.prt.exr bright.json -o from_bright.csv
quiet relight cube.prt.exr probe.pfm -o from_image.csv --exposure 1
check "exposure here or there" cmp from_light.csv from_bright.csv
check "image or light file" cmp from_light.csv from_image.csv
quiet project-probe probe.pfm --window hann -o hann.json
exits 1 run diff probe.json hann.json

# --- pictures -------------------------------------------------------------------------------------------------------
run relight corner.prt.exr front_sh.json -o corner.png --size 64x48 --samples 4 >picture.txt
ev=$(sed -n 's/.*--exposure \(-\?[0-9.]*\) repeats it.*/\1/p' picture.txt)
check "automatic exposure is told" test -n "$ev"
quiet relight corner.prt.exr front_sh.json -o again.png --size 64x48 --samples 4 --exposure "$ev"
exits 0 run diff corner.png again.png --atol 0.02
check "size of the picture" grep -q '"width": 64' <(run info corner.png --json)
quiet relight corner.prt.exr front_sh.json -o corner.exr --size 64x48 --samples 4 --threads 1
quiet relight corner.prt.exr front_sh.json -o corner2.exr --size 64x48 --samples 4 --threads 2
exits 0 run diff corner.exr corner2.exr
quiet relight corner.prt.exr probe.pfm -o behind.exr --size 64x48 --samples 4 --background
quiet relight corner.prt.exr probe.pfm -o plain.exr --size 64x48 --samples 4 --background-color 0.75,0.5,0.25
exits 1 run diff behind.exr plain.exr
quiet relight corner.prt.exr front_sh.json -o orbit.png --size 32x32 --camera orbit:60,30,1.5
exits 2 run diff orbit.png corner.png                                  # other size
quiet relight corner.prt.exr front_sh.json -o spin.png --size 64x48 --samples 4 --exposure 0 --turntable 4
check "four frames" test "$(ls spin_*.png | tr '\n' ' ')" = 'spin_0001.png spin_0002.png spin_0003.png spin_0004.png '
quiet relight corner.prt.exr front_sh.json -o still.png --size 64x48 --samples 4 --exposure 0
quiet relight corner.prt.exr front_sh.json -o quarter.png --size 64x48 --samples 4 --exposure 0 --rotate axis:0,1,0,90
exits 0 run diff spin_0001.png still.png --atol 0.01
exits 0 run diff spin_0002.png quarter.png --atol 0.01
exits 1 run diff spin_0003.png still.png --atol 0.01
quiet relight corner.prt.exr front_sh.json -o corner.ply
check "ply has colours" grep -qa 'property uchar red' corner.ply
check "ply has radiance" grep -qa 'property float radiance_r' corner.ply
check "the ply is a mesh again" grep -q '"triangles": 64' <(run info corner.ply --json)

# --- info, version, help --------------------------------------------------------------------------------------------
check "info of an asset" grep -q '"kind": "asset"' <(run info corner.prt.exr --json)
check "a convex mesh sees the sky" grep -q 'sky seen  *1.0000 on average, 1.0000 to 1.0000' <(run info cube.prt.exr)
check "even light has no direction" grep -q 'dominant direction *none' <(run info constant.json)
quiet convert probe.json -o same.json --degree 4
check "what stays as it was keeps its figures" grep -q energyMissed same.json
check "info of a light" grep -q '"kind": "light"' <(run info probe.json --json)
check "info tells how a light was made" grep -qE '^layout +"latlong"' <(run info probe.json)
check "info of a list" grep -q '"kind": "light list"' <(run info above.json --json)
check "info of a mesh" grep -q '"kind": "mesh"' <(run info cube.obj --json)
check "info of an image" grep -q '"layout": "latlong"' <(run info probe.pfm --json)
hash=$(sha256sum cube.obj | cut -d' ' -f1)
check "the source and its hash" grep -q "$hash" <(run info cube.prt.exr)
check "--version" grep -qE '^shprt [0-9]+\.[0-9]+\.[0-9]+$' <(run --version)
for command in bake project-probe relight convert diff info; do
  check "$command --help has examples" grep -q "^  shprt $command" <(run $command --help)
done
run diff corner.prt.exr other_albedo.prt.exr --json difference.json >difference.txt || true
check "diff writes JSON" grep -q '{' difference.json
run diff corner.prt.exr corner2.prt.exr --json - >diff_stdout.json 2>/dev/null
check "JSON alone on standard output" test "$(head -c 1 diff_stdout.json)" = '{'

finish
