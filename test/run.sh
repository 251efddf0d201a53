#!/usr/bin/env bash
# The whole check: packages, test models, formatting, then build and tests, plain and under the sanitizers.
#   test/run.sh [--no-setup] [--quick|--thread]
# --no-setup  leave out bootstrap.sh and the download of the bunny
# --quick     leave out the sanitizers
# --thread    under the thread sanitizer instead, which the plain run leaves out
set -euo pipefail

setup=1
presets=(release asan+ubsan)
for option in "$@"; do
  case $option in
    --no-setup) setup=0 ;;
    --quick) presets=(release) ;;
    --thread) presets=(tsan) ;;
    *)
      echo "usage: test/run.sh [--no-setup] [--quick|--thread]" >&2
      exit 2
      ;;
  esac
done

cd "$(dirname "${BASH_SOURCE[0]}")/.."
step="setup"
trap 'result=$?; ((result == 0)) || echo "test/run.sh: FAILED in: $step" >&2' EXIT

note=""
if ((setup)); then
  ./bootstrap.sh
  assets/fetch.sh bunny || note=" (without the bunny: the tests that need it were skipped)"
fi

step="formatting"
mapfile -d '' -t sources < <(git ls-files -z --cached --others --exclude-standard -- \
  'modules/*.hh' 'modules/*.cc' 'apps/*.hh' 'apps/*.cc' 'bench/*.hh' 'bench/*.cc' 'test/*.hh' 'test/*.cc')
existing=()
for source in "${sources[@]}"; do
  [[ -f $source ]] && existing+=("$source")
done
clang-format --dry-run --Werror "${existing[@]}"
echo "test/run.sh: ${#existing[@]} sources are formatted"

for preset in "${presets[@]}"; do
  step="$preset: configure"
  cmake --preset "$preset"
  step="$preset: build"
  cmake --build --preset "$preset"
  step="$preset: tests"
  ctest --preset "$preset" -j "$(nproc)"
done

echo "test/run.sh: all passed: formatting, ${presets[*]}$note"
