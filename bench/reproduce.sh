#!/usr/bin/env bash
# The render benchmark from nothing: packages, the bunny, the build, the run. Results go to results/.
#   bench/reproduce.sh [options of whittle-bench]
# The sets, the size and the repetitions suit Mesa's software renderer on two cores: about three minutes of drawing.
# Options given here win, for example: bench/reproduce.sh --size 512 --repetitions 10, or --sets all, which takes
# two and a half times as long, or --sets all --pictures-only.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

# whittle-bench adds up what --sets is given in several goes, so ours must not stand beside yours.
sets=(--sets original,fad-30,fad-150,ivdd-0.0011,ivdd-0.0013)
for argument in "$@"; do
  [[ $argument == --sets || $argument == --sets=* ]] && sets=()
done

./bootstrap.sh
assets/fetch.sh bunny || echo "reproduce: the bunny cannot be had; a generated mesh takes its place" >&2

# A folder of its own: the release preset's would remember that the tests are off.
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-bench

build/reproduce/bench/whittle-bench --size 256 --repetitions 3 --out results "${sets[@]}" "$@"
