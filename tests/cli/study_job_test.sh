#!/usr/bin/env bash
# shprt study: a page and figures, command lines that keep what they claim, and going on after Ctrl-C.
# Usage: study_job_test.sh SHPRT WORK_DIR SOURCE_DIR
set -euo pipefail
shprt=$1 work=$2 source=$3
source "$(dirname "${BASH_SOURCE[0]}")/checks.sh"
mkdir bin
ln -s "$shprt" bin/shprt

figure() { grep -o "\"$2\": [^,]*" "$1" | head -n 1 | sed 's/.*: //'; }
# commands FILE: what the study recommends, a line each: TARGET COMMAND.
commands() {
  awk -F'": "' '/"for":/ { sub(/",?$/, "", $2); target = $2 }
    /"command": "shprt bake/ { sub(/"$/, "", $2); print target "\t" $2 }' "$1"
}
# relative_error A.csv B.csv: RMS of the difference of radiance over RMS of B.
relative_error() {
  awk -F, 'FNR == 1 { next }
    NR == FNR { for (i = 7; i <= 9; ++i) a[FNR, i] = $i; next }
    { for (i = 7; i <= 9; ++i) { d = $i - a[FNR, i]; difference += d * d; norm += $i * $i } }
    END { print sqrt(difference / norm) }' "$1" "$2"
}
# at_most A B, within A B TOLERANCE: of numbers; the tolerance is relative.
at_most() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a <= b) }'; }
within() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !(a - b <= t * b && b - a <= t * b) }'; }

# --- what is written ------------------------------------------------------------------------------------------------
run study corner.obj probe.pfm -o made/corner --quick --json corner.json >corner.txt 2>notes.txt
check "the page" test -s made/corner/index.html
check "the figures" test -s made/corner/study.json
check "headlines" grep -q '"seconds for an error of 10%"' corner.json
check "and what they rest on" test -n "$(figure corner.json pareto.0.1.error)"
check "says what is studied" grep -q '^scene  *corner.obj' corner.txt
check "says where the page is" grep -q 'made/corner/index.html' corner.txt
check "ten lines or a few more" test "$(wc -l <corner.txt)" -le 20

# --- command lines --------------------------------------------------------------------------------------------------
quiet bake corner.obj -o best.prt.exr --model interreflected --degree 12 --rays 16384 --seed 99 --bounces 30
quiet relight best.prt.exr probe.pfm -o best.csv
commands corner.json >commands.txt
check "one for the defaults and for some targets" test "$(wc -l <commands.txt)" -ge 3
while IFS=$'\t' read -r target command; do
  case $target in
    defaults) name=default ;;
    *%) name=$(awk -v percent="${target%\%}" 'BEGIN { printf "%g", percent / 100 }') ;;
    *) continue ;;
  esac
  PATH=$work/bin:$PATH bash -c "$command --quiet" || fail "does not run: $command"
  asset=${command#* -o } asset=${asset%% *}
  quiet relight "$asset" probe.pfm -o row.csv
  error=$(relative_error row.csv best.csv)
  # What the two references leave uncertain is far below a thousandth here. Both have degree 12.
  check "$target has the error claimed ($error)" \
    at_most "$(awk -v a="$error" -v b="$(figure corner.json "pareto.$name.error")" 'BEGIN { d = a - b; print d < 0 ? -d : d }')" 0.001
  if [ "$name" != default ]; then check "$target is reached" at_most "$error" "$name.1"; fi
  # The asset's own history (sources, notes) comes on top.
  check "$target has the size claimed" \
    at_most "$(($(stat -c %s "$asset") - $(figure corner.json "pareto.$name.bytes" | sed 's/\..*//')))" 2048
done <commands.txt

# --- nothing to shadow ----------------------------------------------------------------------------------------------
quiet study cube.obj probe.pfm -o cube --quick --json cube.json
check "a convex mesh needs no rays" test "$(figure cube.json pareto.0.001.rays)" = 0.0
check "and is unshadowed" grep -q 'model unshadowed' <(commands cube.json)

# --- without a light, and options that go into command lines --------------------------------------------------------
cp corner.obj 'a corner.obj'
quiet study 'a corner.obj' -o alone --quick --degree 2 --rays 64 --albedo 0.5,0.25,0.25 --two-sided --seed 7 --json alone.json
check "quotes, loading options and seed" \
  grep -q "^shprt bake 'a corner.obj' --albedo 0.5,0.25,0.25 --two-sided -o .* --degree 2 .*--seed 7" <(commands alone.json | cut -f 2)

# --- going on -------------------------------------------------------------------------------------------------------
cp made/corner/study-journal.json kept.json
run study corner.obj probe.pfm -o made/corner --quick >again.txt 2>/dev/null
check "nothing is measured again" cmp -s kept.json made/corner/study-journal.json
check "and the table is the same" diff corner.txt again.txt
run study corner.obj probe.pfm -o made/corner --quick --restart -q
check "--restart measures anew" test -n "$(cmp kept.json made/corner/study-journal.json)"
run study corner.obj probe.pfm -o made/corner --quick --rays 64 -q
check "so do other options" grep -q 'rays 64' made/corner/study-journal.json

# Ctrl-C, as a terminal sends it: background jobs of scripts ignore it otherwise.
boxes="study $source/data/cornell_box.obj $source/data/studio.hdr -o boxes --quick"
# shellcheck disable=SC2086
env --default-signal=INT "$shprt" $boxes >/dev/null 2>stopped.txt &
study=$!
for _ in {1..600}; do [ -s boxes/study-journal.json ] && break; sleep 0.05; done
kill -INT $study
code=0
wait $study || code=$?
check "ends with 130 ($code)" test $code = 130
check "says that it can go on" grep -q 'goes on' stopped.txt
check "no page yet" test ! -e boxes/index.html
measured=$(grep -c '^   *"' boxes/study-journal.json)
# shellcheck disable=SC2086
run $boxes --json boxes.json -q
check "the page" test -s boxes/index.html
check "goes on with what was measured" grep -q '"duration": .* measurements were there' boxes.json
check "which was something" test "$measured" -ge 1
finish
