# shellcheck shell=bash
# Checks that count their failures, for the scripts that watch commands succeed. Sourced with the variables shprt and work
# set; makes the inputs and ends in their folder.
source "$(dirname "${BASH_SOURCE[0]}")/inputs.sh"
rm -rf "$work"
make_inputs "$work"
cd "$work"

failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
# check NAME COMMAND...: the command must succeed.
check() {
  local name=$1
  shift
  "$@" || fail "$name"
}
# exits CODE COMMAND...: the command must end with that code.
exits() {
  local expected=$1 code=0
  shift
  "$@" >/dev/null 2>&1 || code=$?
  [ $code -eq "$expected" ] || fail "exit code $code, not $expected: $*"
}
run() { "$shprt" "$@"; }
quiet() { "$shprt" "$@" --quiet; }
finish() {
  check "no temporary files" test -z "$(find . -name '.*' -type f)"
  [ $failures -eq 0 ] || { echo "$failures checks failed"; exit 1; }
  echo "all checks passed"
}
