#!/usr/bin/env bash
# The papers' experiments from nothing: packages, models, the build, the run. Results go to results/; open
# results/report.html.
#   bench/reproduce.sh [options of whittle-bench]
# On a software renderer the run is --quick, some four minutes on two cores; --paper takes all frames and repetitions
# of the papers, some twenty minutes. On a graphics card --paper is the default. After an interruption:
#   bench/reproduce.sh --resume
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

./bootstrap.sh
assets/fetch.sh bunny || echo "reproduce: the bunny cannot be had; a generated mesh takes its place" >&2
# Exported by Debian's blender, which this installs where it is missing: over a hundred packages.
assets/fetch.sh suzanne || echo "reproduce: Suzanne cannot be had; Paper 2's experiment is left out" >&2

# A folder of its own: the release preset's would remember that the tests are off.
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-bench

build/reproduce/bench/whittle-bench --out results "$@"
