# shellcheck shell=bash
# Bad input: one clear line on standard error, the right exit code, nothing on standard output, no file left behind.
# Sourced by the bad_*_test.sh with the variables shprt and work set; it makes the inputs, and ends in an empty folder.
source "$(dirname "${BASH_SOURCE[0]}")/inputs.sh"
set -euo pipefail
rm -rf "$work"
make_inputs "$work/in"
cd "$work/in"
"$shprt" bake corner.obj -o asset.prt.exr --rays 16 --quiet
"$shprt" project-probe front.json -o light.json --quiet
: >empty.obj
: >empty.prt.exr
: >empty.json
: >empty.hdr
mkdir -p folder locked
head -c 1500 asset.prt.exr >truncated.prt.exr
head -c "$(($(stat -c %s asset.prt.exr) - 100))" asset.prt.exr >cut_at_the_end.prt.exr
printf 'v nan 0 0\nv 1 nan 0\nv 0 1 inf\nf 1 2 3\n' >nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >no_faces.obj
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n' >no_area.obj
printf '{"format":"shprt-light","version":1,' >broken.json
printf '{"format":"shprt-light","version":99,"degree":0,"coefficients":[[1,1,1]]}' >newer.json
printf '{"lights":[{"type":"laser"}]}' >unknown_light.json
printf '{"something":"else"}' >neither.json
printf '{"lights":[{"type":"probe","file":"probe.pfm"}]}' >image_list.json
printf '{"format":"shprt-convention","version":1,"convention":"godot","degree":2,"coefficients":[]}' >unknown_convention.json
printf '{"format":"shprt-convention","version":1,"convention":"unity","degree":2,"coefficients":[[1,1,1]]}' >short_convention.json
"$shprt" convert light.json -o unity.json --convention unity --quiet 2>/dev/null
printf 'matrix:1,0,0,0,1,0,0,0,-1' >mirror.txt
echo 'axis:0,1,0,90' >turn.txt
printf '{"lights":[{"type":"constant","radiance":[2e300,2e300,2e300]}]}' >bright.json
"$shprt" project-probe bright.json -o bright_light.json --degree 2 --quiet
sed 's/e+300/e+307/g' bright_light.json >brighter_light.json
printf '{"lights":[{"type":"probe","file":"light.json","layout":"latlong"}]}' >layout_list.json
ln -s /dev/full full.prt.exr
for suffix in csv json png ply; do ln -s /dev/full "full.$suffix"; done
mkdir "$work/case"
cd "$work/case"

failures=0 cases=0
in=../in a=../in/asset.prt.exr l=../in/light.json
fail() {
  echo "FAILED: $*"
  sed 's/^/    stderr: /' ../stderr.txt
  failures=$((failures + 1))
}
# refused CODE ARGUMENTS...: see above.
refused() {
  local expected=$1 code=0
  shift
  cases=$((cases + 1))
  "$shprt" "$@" >../stdout.txt 2>../stderr.txt || code=$?
  [ $code -eq "$expected" ] || fail "exit code $code, not $expected: shprt $*"
  [ "$(wc -l <../stderr.txt)" -eq 1 ] || fail "not one line: shprt $*"
  grep -q '^shprt: ....' ../stderr.txt || fail "says nothing: shprt $*"
  if [ "$expected" -eq 2 ] && [ "${1:-}" != diff ]; then
    grep -q -e '--help' ../stderr.txt || fail "no hint at --help: shprt $*"
  fi
  [ ! -s ../stdout.txt ] || fail "writes to standard output: shprt $*"
  if [ -n "$(ls -A .)" ]; then
    fail "leaves $(ls -A .): shprt $*"
    rm -rf ./* ./.[!.]*
  fi
  if [ -n "$(find ../in -name '.*' -type f)" ]; then
    fail "leaves a temporary file: shprt $*"
    find ../in -name '.*' -type f -delete
  fi
}
# says TEXT: the last refusal mentions it.
says() { grep -qF -e "$1" ../stderr.txt || fail "does not mention '$1'"; }

# A disk that fills up while writing: the temporary file goes, nothing appears under the name asked for.
# (A limit on file size stands in for the disk; it is in blocks of 1024 bytes.)
full_disk() {
  (
    failures=0
    trap '' XFSZ
    ulimit -f 2
    refused 1 "$@"
    [ $failures -eq 0 ]
  ) || failures=$((failures + 1))
  cases=$((cases + 1))
}

finish() {
  [ $failures -eq 0 ] || { echo "$failures of $cases cases failed"; exit 1; }
  echo "$cases cases passed"
}
