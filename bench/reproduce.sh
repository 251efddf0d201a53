#!/usr/bin/env bash
# The render benchmark from nothing: packages, the bunny, the build, the run. Results go to results/.
#   bench/reproduce.sh [options of whittle-bench]
# The size and the repetitions suit Mesa's software renderer on two cores: about three minutes of drawing. Options
# given here come last and win, for example: bench/reproduce.sh --size 512 --repetitions 10
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

./bootstrap.sh
assets/fetch.sh bunny || echo "reproduce: the bunny cannot be had; a generated mesh takes its place" >&2

# A folder of its own: the release preset's would remember that the tests are off.
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-bench

build/reproduce/bench/whittle-bench --size 256 --repetitions 3 --out results "$@"
