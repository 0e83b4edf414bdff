#!/usr/bin/env bash
# Builds scalebreak and runs its main job: the collision tables and the invariance of every scaling law, for a latex
# sphere on quartz and for two glass spheres, and a small flow, into out/. Open out/index.html
# and out/flow/index.html afterwards.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. .ci/prepare.sh

need "${build_packages[@]}" "${plot_packages[@]}"
configure_and_build -DSCALEBREAK_TESTS=OFF -DSCALEBREAK_BENCHMARKS=OFF
echo "== collision tables of every kind of contact"
build/release/bin/scalebreak table --all --tables out/tables --out out/tables
echo "== what each scaling law keeps"
build/release/bin/scalebreak invariance data/scenes/latex_on_quartz.toml data/scenes/glass_pair.toml --tables out/tables --out out
echo "== one collision"
build/release/bin/scalebreak collide data/scenes/glass_pair.toml --out out/collision
echo "== a flow: glass beads in shear, softened by RPS to a hundredth of their stiffness"
build/release/bin/scalebreak run data/scenes/shear_glass.toml --set scaling.law=rps --set scaling.factor=1e-2 --out out/flow
echo "== done: open out/index.html"
