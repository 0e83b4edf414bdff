#!/usr/bin/env bash
# Builds scalebreak and runs all its tests. Arguments go to ctest, like -R Hertz.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. .ci/prepare.sh

need "${build_packages[@]}" "${plot_packages[@]}" "${test_packages[@]}"
configure_and_build -DSCALEBREAK_TESTS=ON -DSCALEBREAK_BENCHMARKS=ON
echo "== testing"
ctest --preset release -j "$(nproc)" "$@"
