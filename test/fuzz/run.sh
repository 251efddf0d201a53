#!/usr/bin/env bash
# Builds the fuzz targets with clang and runs each for some time, one after the other.
#   test/fuzz/run.sh [SECONDS] [TARGET ...]
# SECONDS  for each target, by the clock; 60 without. The table says how much of that the processor was at it
# TARGET   a reader, obj off ply stl om glb gltf three_mf; draco and gzip, what unpacks them; polygons, what cuts them; soup, all planners and executors on any triangles; seams, modules that move
#          seams on sound meshes with any charts; all without
# What the runs find interesting stays in build/fuzz/corpus, and they begin with it and with test/fuzz/corpus.
# An input that fails is left in build/fuzz/failures, and the exit status is 1.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seconds=${1:-60}
shift || true
formats=("$@")
((${#formats[@]})) || formats=(obj off ply stl om glb gltf three_mf draco gzip polygons soup seams)

build=build/fuzz
mkdir -p "$build"
cmake -S . -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DWHITTLE_FUZZ=ON -DWHITTLE_WERROR=ON \
  -DWHITTLE_BENCH=OFF -DWHITTLE_VIEWER=OFF -DWHITTLE_TESTS=OFF >"$build/configure.log" || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target "${formats[@]/#/fuzz_}"

failed=0
mkdir -p "$build/failures"
TIMEFORMAT='%U %S'
printf '%-8s %8s %12s %8s %10s %8s\n' target 'CPU s' executions corpus coverage result
for format in "${formats[@]}"; do
  corpus=$build/corpus/$format
  log=$build/$format.log
  mkdir -p "$corpus"
  options=(-max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 -print_final_stats=1
           -artifact_prefix="$build/failures/$format-")
  dictionary=test/fuzz/dictionaries/${format/glb/gltf}.dict
  [[ ! -e $dictionary ]] || options+=(-dict="$dictionary")
  kept=(test/fuzz/corpus/"$format")
  [[ -e ${kept[0]} ]] || kept=()
  result=good
  { time "$build/test/fuzz/fuzz_$format" "${options[@]}" "$corpus" "${kept[@]}" >"$log" 2>&1; } 2>"$build/time" || {
    result=FAILED
    failed=1
  }
  cpu=$(awk '{print int($1 + $2)}' "$build/time")
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  coverage=$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$log" | tail -n 1)
  printf '%-8s %8s %12s %8s %10s %8s\n' "$format" "$cpu" "${executions:-?}" "$(find "$corpus" -type f | wc -l)" \
    "${coverage:-?}" "$result"
done
((failed == 0)) || echo "test/fuzz/run.sh: FAILED: see $build/*.log and $build/failures" >&2
exit "$failed"
