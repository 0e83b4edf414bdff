#!/bin/sh
# Writes sweep.csv: the largest stable steps of elastic flows and of collisions, over laws, speeds, densities, sizes. In the project's folder, with build/release/bin in
# the path: sh docs/measured/stability/sweep.sh > docs/measured/stability/sweep.csv
dir=$(mktemp -d)
header=1
# label, value, input, settings...: the rows of one command
sweep() {
  label=$1 value=$2 input=$3
  shift 3
  if scalebreak stability "$input" --quiet --threads 1 --out "$dir" "$@" > /dev/null; then
    if [ $header = 1 ]; then header=0; sed -n 's/^law,/sweep,value,law,/p' "$dir/stability.csv"; fi
    sed "1d; s/^/$label,$value,/" "$dir/stability.csv"
  fi
}
box=data/failures/heating.toml
laws='study.laws=["none","rps","sup","overlap_kept","force_cubed","sakai","chen_elliott","thakur"]'
linear='study.laws=["none","rps","sup","overlap_kept","force_cubed","sakai","thakur"]'
factors='study.factors=[0.1,0.01,2,4]'
sweep laws_hertz 0 $box --set run.replicas=2 --set "$laws" --set "$factors"
sweep laws_linear 0 $box --set run.replicas=2 --set "$linear" --set "$factors" --set contact.normal=linear --set material.spring_constant=650
few='study.laws=["rps"]'
for speed in 0.01 0.03 0.1 0.3 1; do
  sweep speed $speed $box --set run.replicas=2 --set particles.speed=$speed --set "$few" --set 'study.factors=[0.01]'
done
for fraction in 0.1 0.2 0.3 0.4 0.5 0.55; do
  sweep volume_fraction $fraction $box --set run.replicas=2 --set particles.volume_fraction=$fraction --set "$few" --set 'study.factors=[0.01]'
done
for ratio in 1.01 2 3 4 6; do
  large=$(awk "BEGIN { print $ratio * 0.25e-3 }")
  sweep size_ratio $ratio $box --set run.replicas=2 --set particles.size=bidisperse --set particles.large_radius=$large --set particles.large_mass_fraction=0.8 \
    --set "$few" --set 'study.factors=[0.01]'
done
pair="data/scenes/glass_pair.toml --set study.integrators=[\"verlet\",\"synchronized\"] --set study.factors=[0.01,2]"
bare="--set material.surface_energy=0 --set contact.adhesion_range=touch --set contact.damping_on=overlap"
for speed in 0.02 0.2 2; do
  sweep collision_jkr $speed $pair --set "$laws" --set impact.normal_speed=$speed
  sweep collision_hertz $speed $pair --set "$laws" --set impact.normal_speed=$speed --set contact.normal=hertz $bare
done
sweep collision_linear 0.02 $pair --set "$linear" --set contact.normal=linear --set material.spring_constant=1e5 --set impact.normal_speed=0.02 $bare
rm -r "$dir"
