#!/usr/bin/env bash
# Builds scalebreak and runs its main job: a small study of where scaling laws break for glass beads in shear, and what they keep in a
# single collision, into out/. Open out/study/index.html and out/invariance/index.html afterwards.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. .ci/prepare.sh

need "${build_packages[@]}" "${plot_packages[@]}"
configure_and_build -DSCALEBREAK_TESTS=OFF -DSCALEBREAK_BENCHMARKS=OFF
echo "== what each scaling law keeps in a collision; its report will be out/invariance/index.html"
build/release/bin/scalebreak invariance data/scenes/glass_pair.toml --tables out/tables --out out/invariance
echo "== where they break in a flow: data/studies/quick.toml, two and a half minutes on two cores; its report, with maps and plots, will be out/study/index.html"
build/release/bin/scalebreak breakdown data/studies/quick.toml --tables out/tables --out out/study
