#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test: optimised, then under the address and undefined-behaviour
# sanitizers. Options: --long also runs the checks that take minutes; --no-asan skips the sanitizer run.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/packages.sh

long=OFF
asan=yes
for argument in "$@"; do
  case "$argument" in
    --long) long=ON ;;
    --no-asan) asan=no ;;
    *) echo "usage: tools/test.sh [--long] [--no-asan]"; exit 2 ;;
  esac
done

echo "== Packages"
ensure_packages "${packages[@]}" "${test_packages[@]}"

echo "== Optimised build and tests"
configure_and_build release -DSHPRT_LONG_TESTS=$long
ctest --test-dir build/release --output-on-failure -j2

if [ $asan = yes ]; then
  echo "== Sanitizer build and tests"
  configure_and_build asan -DSHPRT_LONG_TESTS=OFF
  ctest --test-dir build/asan --output-on-failure -j2
fi
