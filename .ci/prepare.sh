# Sourced by run.sh and test.sh: installs what is missing from Debian's packages and builds the release preset.
# Not root: prints the line to run, and stops.

need() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    echo "These Debian packages are missing; install them, then run this again:" >&2
    echo "  sudo apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  echo "== installing ${missing[*]}"
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

build_packages=(g++ cmake ninja-build git libboost-dev libcli11-dev libeigen3-dev libfmt-dev libgsl-dev nlohmann-json3-dev libtomlplusplus-dev)
plot_packages=(gnuplot-nox fonts-dejavu-core)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev python3 python3-numpy)

configure_and_build() {
  echo "== configuring"
  cmake --preset release "$@" >/dev/null
  echo "== building"
  cmake --build --preset release
}
