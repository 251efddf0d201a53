#!/usr/bin/env bash
# The speed benchmark from nothing: packages, models, build, OpenMesh's core without assertions, the runs, one page.
#   bench/speed/run.sh [--peers] [options of whittle-speed]
# --peers installs CGAL and VTK, too (heavy). Other options go to every run, for example --rounds 3 or --threads 1.
# Results go to results/speed/. All in all it takes about an hour on two cores; let nothing else run meanwhile.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."

setup=()
if [[ ${1:-} == --peers ]]; then
  setup=(--peers)
  shift
fi
./bootstrap.sh "${setup[@]}"
assets/fetch.sh bunny
models=(assets/cache/bunny.obj)
if assets/fetch.sh dragon; then
  models+=(assets/cache/dragon.ply)
else
  echo "run: the dragon cannot be had; the bunny stands alone, and growth is measured on it subdivided" >&2
fi
bench/speed/openmesh-core.sh build/openmesh-ndebug

# A folder of its own: the release preset's would remember that the tests are off.
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-speed

speed=build/reproduce/bench/speed/whittle-speed
out=results/speed
"$speed" "${models[@]}" --suite all --out "$out" --name with-assertions "$@"
# The other core matters only to what runs on OpenMesh; meshopt_simplify stays as the measure of it.
LD_LIBRARY_PATH=build/openmesh-ndebug "$speed" "${models[@]}" --suite figures --out "$out" --name without-assertions \
  --only '^(copy|arrays|OpenMesh|sweep|lazy|DecimaterT|McDecimaterT|compact|garbage|meshopt_simplify )' "$@"
"$speed" --report "$out/with-assertions.json" "$out/without-assertions.json" --out "$out" --name speed
