#!/usr/bin/env bash
# Speed beside LAMMPS, LIGGGHTS and Yade: makes the start states, runs all engines in turn, writes build/peers/speed.csv and speed.md.
# --quick: one run on one core, 5000 spheres, without Yade (a minute or two). --spheres N. What else there is: peers.py --help.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
. "$here/prepare.sh"

spheres=20000
arguments=()
yade=yade:yade
while [ $# -gt 0 ]; do
  case $1 in
    --spheres) spheres=${2:?--spheres wants a number}; shift ;;
    --quick) arguments+=(--quick); [ "$spheres" = 20000 ] && spheres=5000; yade= ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
need_programs lmp:lammps liggghts:liggghts ${yade:+"$yade"} mpirun:openmpi-bin python3:python3 taskset:util-linux
build_programs

work=$root/build/peers/$spheres
mkdir -p "$work"
made() { [ -s "$work/$1.data" ] || { echo "== making the state $1 of $spheres spheres"; false; }; }
made gas || "$bin/scalebreak_peer_state" S1 "$work/gas.data" --count "$spheres"
made thin || "$bin/scalebreak_peer_state" S3 "$work/thin.data" --count "$spheres"
if ! made bed; then  # settles over 0.1 s
  "$bin/scalebreak_peer_state" S4 "$work/column.data" --count "$spheres"
  "$bin/scalebreak_peer_scene" S4 "$work/column.data" --threads "$(nproc)" --warm-up 15000 --save "$work/bed.data"
fi
for state in gas thin bed; do  # LIGGGHTS takes no remark behind a section's name
  sed 's/^Atoms # sphere/Atoms/' "$work/$state.data" >"$work/$state.liggghts.data"
done
/usr/bin/env python3 "$here/peers.py" --work "$work" --bin "$bin" "${arguments[@]}"
