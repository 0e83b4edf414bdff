#!/usr/bin/env bash
# Physics beside LAMMPS: homogeneous shear, and a gas that cools, from the same states; writes build/peers/physics.md.
# Arguments: RESTITUTION and what `damping tsuji` must be told for it (see README.md); by default 0.81 0.742411. --quick: shorter.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
. "$here/prepare.sh"

spheres=2000 warm=100000 steps=300000 gases=8
[ "${1:-}" = --quick ] && { warm=20000 steps=100000 gases=4; shift; }
restitution=${1:-0.81} told=${2:-0.742411}
need_programs lmp:lammps
build_programs
work=$root/build/peers/physics
mkdir -p "$work"
cd "$work"
lammps() { OMP_NUM_THREADS=1 lmp -log none -screen none -in "$here/decks/lammps_flow.in" -var decks "$here/decks" -var e "$told" "$@"; }

echo "== shear, volume fraction 0.3, 40/s, $spheres spheres"
"$bin/scalebreak_peer_state" S1 shear.data --count $spheres --volume-fraction 0.3
lammps -var state shear.data -var out shear.series -var rate 40 -var warm $warm -var n $steps
"$bin/scalebreak_peer_flow" shear shear.data shear.series --warm-up $warm --steps $steps --restitution "$restitution" >shear.md
cat shear.md

echo "== cooling from 0.1 m/s, volume fraction 0.5, $gases states of $spheres spheres"
states=() series=()
for seed in $(seq $gases); do
  "$bin/scalebreak_peer_state" S1 "gas$seed.data" --count $spheres --seed "$seed"
  lammps -var state "gas$seed.data" -var out "gas$seed.series" -var n 20000 -var every 4000 -var skin 1e-4
  states+=("gas$seed.data") series+=("gas$seed.series")
done
"$bin/scalebreak_peer_flow" cooling --states "${states[@]}" --series "${series[@]}" --restitution "$restitution" >cooling.md
cat cooling.md
{ printf 'Homogeneous shear, restitution %s\n\n' "$restitution"; cat shear.md; printf '\nCooling\n\n'; cat cooling.md; } >../physics.md
