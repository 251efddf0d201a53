#!/usr/bin/env bash
# Error and time of mq, against meshopt_simplify and CGAL's Lindstrom-Turk: packages, models, build, one run, one page.
#   bench/speed/truth.sh [options of whittle-speed]
# Results go to results/speed/truth.{json,md}. It takes about a quarter of an hour on two cores; let nothing else run meanwhile.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."

./bootstrap.sh --peers
for model in bunny armadillo fandisk dragon; do assets/fetch.sh "$model"; done
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-speed
cache=assets/cache
build/reproduce/bench/speed/whittle-speed "$cache/bunny.obj" "$cache/armadillo.off" "$cache/fandisk.off" "$cache/dragon.ply" \
  --suite truth --out results/speed --name truth "$@"
