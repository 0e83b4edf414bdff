#!/usr/bin/env bash
# Physics beside LAMMPS: homogeneous shear, and a gas that cools, from the same states; writes build/peers/physics.md.
# Arguments: RESTITUTION and what `damping tsuji` must be told for it (see README.md); by default 0.81 0.742411. --quick: shorter.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
. "$here/prepare.sh"

spheres=2000 warm=40000 steps=60000 count=8
[ "${1:-}" = --quick ] && { warm=20000 steps=20000 count=4; shift; }
restitution=${1:-0.81} told=${2:-0.742411}
need_programs lmp:lammps
build_programs
work=$root/build/peers/physics
mkdir -p "$work"
cd "$work"

# compare NAME STATE_OPTIONS LAMMPS_VARIABLES: the table of $count states.
compare() {
  local name=$1 seed states=() series=()
  for seed in $(seq $count); do
    "$bin/scalebreak_peer_state" S1 "$name$seed.data" --count $spheres --seed "$seed" $2
    OMP_NUM_THREADS=1 lmp -log none -screen none -in "$here/decks/lammps_flow.in" -var decks "$here/decks" -var e "$told" \
      -var state "$name$seed.data" -var out "$name$seed.series" $3
    states+=("$name$seed.data") series+=("$name$seed.series")
  done
  "$bin/scalebreak_peer_flow" "$name" --states "${states[@]}" --series "${series[@]}" --restitution "$restitution" >"$name.md"
  cat "$name.md"
}

echo "== homogeneous shear at 40/s, volume fraction 0.3, $count states of $spheres spheres, restitution $restitution"
compare shear "--volume-fraction 0.3" "-var rate 40 -var warm $warm -var n $steps"
echo "== cooling from 0.1 m/s, volume fraction 0.5, $count states of $spheres spheres"
compare cooling "" "-var n 20000 -var every 4000 -var skin 1e-4"
{ printf 'Homogeneous shear, restitution %s\n\n' "$restitution"; cat shear.md; printf '\nCooling\n\n'; cat cooling.md; } >../physics.md
