# Sourced by run_peers.sh and compare_physics.sh: asks for the packages, builds the programs of this folder. $here and $root are set.

need_programs() {
  local missing=() pair
  for pair in "$@"; do
    command -v "${pair%%:*}" >/dev/null || missing+=("${pair##*:}")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "These Debian packages are missing; install them with: apt-get install ${missing[*]}" >&2
  exit 1
}

build_programs() {
  bin=$root/build/release/bin
  cmake -S "$root" --preset release -DSCALEBREAK_BENCHMARKS=ON >/dev/null
  (cd "$root" && cmake --build --preset release --target scalebreak_peer_state scalebreak_peer_scene scalebreak_peer_flow >/dev/null)
}
