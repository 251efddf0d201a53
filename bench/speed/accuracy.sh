#!/usr/bin/env bash
# Errors of mq against meshopt_simplify's and CGAL's Lindstrom-Turk's over two sets of models of CGAL's data: those that
# parameters were chosen on, and those that were only looked at in the end. Packages, models, build, two runs, two pages.
#   bench/speed/accuracy.sh [options of whittle-speed]
# Results go to results/speed/accuracy-{chosen-on,looked-at}.{json,md}. It takes about three minutes on two cores; times in the
# pages are of a single round.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."

./bootstrap.sh --peers
assets/fetch.sh cgal
cmake --preset release -B build/reproduce -DWHITTLE_TESTS=OFF
cmake --build build/reproduce --target whittle-speed

run() {
  local name=$1 models=()
  shift
  for model in $1; do models+=("assets/cache/cgal/$model.off"); done
  shift
  build/reproduce/bench/speed/whittle-speed "${models[@]}" --suite truth --rounds 1 --only '^(bulk mq|meshopt|CGAL)[^:]*$' \
    --out results/speed --name "$name" "$@"
}
run accuracy-chosen-on "bunny00 diplodocus man mannequin-devil camel lion fandisk_large" "$@"
run accuracy-looked-at "refined_elephant armadillo bear ChineseDragon-10kv blade cheese lion-head turbine" "$@"
