# Sourced by the scripts beside it: which Debian or Ubuntu packages shprt needs, and how they get there.

packages=(build-essential cmake ninja-build pkg-config
  libembree-dev libopenmesh-dev libopenimageio-dev openimageio-tools libopenexr-dev libimath-dev
  libcli11-dev nlohmann-json3-dev libtbb-dev libspdlog-dev libfmt-dev libssl-dev)
test_packages=(glslang-tools libgtest-dev libbenchmark-dev python3 python3-openimageio python3-numpy gnuplot-nox)
# Looked for at run time, never needed: `shprt study` draws its charts with gnuplot, and shows tables without.
optional_packages=(gnuplot-nox)

# ensure_packages NAME...: installs those that are missing, after saying so. Needs root only when something is missing.
ensure_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    echo "All packages are there; nothing to install."
    return
  fi
  echo "Installing from the distribution: ${missing[*]}"
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Not root and no sudo: run  apt-get install ${missing[*]}  as root, then again."; exit 1; }
    root=(sudo)
  fi
  "${root[@]}" apt-get update -qq
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# offer_packages NAME...: says which are missing and how to get them; installs nothing.
offer_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] || echo "Optional, for plots: apt-get install ${missing[*]}"
}

# configure_and_build PRESET [cmake options...]
configure_and_build() {
  local preset=$1
  shift
  local launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake --preset "$preset" -G Ninja "${launcher[@]}" "$@" >"build-$preset.log" 2>&1 || { cat "build-$preset.log"; exit 1; }
  rm -f "build-$preset.log"
  cmake --build "build/$preset"
}
