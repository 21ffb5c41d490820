#!/usr/bin/env bash
# What codegen prints: to a file as to standard output, with the command that makes it again, and with a light.
# Usage: codegen_test.sh SHPRT WORK_DIR
shprt=$1 work=$2
source "$(dirname "${BASH_SOURCE[0]}")/inputs.sh"
set -euo pipefail
rm -rf "$work"
make_inputs "$work"
cd "$work"
fail() { echo "FAILED: $*"; exit 1; }

for language in glsl hlsl wgsl c; do
  "$shprt" codegen --language $language --degree 3 -o code.txt --json figures.json >said.txt 2>notes.txt
  grep -q "^wrote" said.txt || fail "$language: no summary"
  [ ! -s notes.txt ] || fail "$language: $(cat notes.txt)"
  grep -q '"degree": 3' figures.json || fail "$language: figures"
  [ "$(wc -c <code.txt)" -eq "$(sed -n 's/.*"bytes": \([0-9]*\).*/\1/p' figures.json)" ] || fail "$language: size"
  "$shprt" codegen --language $language --degree 3 --quiet | cmp - code.txt || fail "$language: standard output differs"
  # The command in the opening comment makes the same file.
  command=$(sed -n 's,^//   shprt ,,p' code.txt)
  eval "\"\$shprt\" $command" 2>/dev/null | cmp - code.txt || fail "$language: the command in the comment makes other code"
done

"$shprt" codegen --language glsl --degree 9 >nine.txt 2>notes.txt
grep -q 'rotation' notes.txt || fail "no note on rotation"
! grep -q shRotate nine.txt || fail "rotation at degree 9"
"$shprt" codegen --language glsl --what basis >basis.txt 2>/dev/null
! grep -q 'shRadiance\|shRotate' basis.txt || fail "more than asked for"

# The light's degree, its numbers, and a name that a shell would take apart.
"$shprt" project-probe front.json -o "a 'light' \\.json" --degree 3 --quiet
"$shprt" codegen --language c --type double --light "a 'light' \\.json" -o light.h --quiet
grep -q 'static const double shLight\[48\]' light.h || fail "not the light's degree"
command=$(sed -n 's,^//   shprt ,,p' light.h)
eval "\"\$shprt\" $command" 2>/dev/null | cmp - light.h || fail "the quoted command makes other code"
"$shprt" codegen --language c --light "a 'light' \\.json" --degree 1 -o small.h --quiet
grep -q 'shLight\[12\]' small.h || fail "bands were not dropped"
# Headers that hold different things refuse to be included together.
mark() { sed -n 's/^#define SHPRT_CODE //p' "$1"; }
[ -n "$(mark light.h)" ] && [ "$(mark light.h)" != "$(mark small.h)" ] || fail "two headers with one mark"
grep -q "^#elif SHPRT_CODE != $(mark light.h)$" light.h || fail "no refusal of another header"
echo "passed"
