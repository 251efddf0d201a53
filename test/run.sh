#!/usr/bin/env bash
# The whole check: packages, test models, formatting, clang-tidy, then the programs, built as users have them, with the tests
# that run them, then the library, what the programs share and the command line, with every test, under the sanitizers.
#   test/run.sh [--no-setup] [--quick|--thorough|--thread]
# --no-setup  leave out bootstrap.sh and the download of the bunny
# --quick     leave out clang-tidy and the sanitizers, and run every test in the first build
# --thorough  also whittle-viewer, whittle-bench and whittle-speed under the sanitizers, and the library's inner headers each
#             as the only include, which the plain run leaves out
# --thread    everything under the thread sanitizer instead
set -euo pipefail

setup=1
presets=(ci asan+ubsan)
tidy=1 ci_options=() sanitizer_options=()
for option in "$@"; do
  case $option in
    --no-setup) setup=0 ;;
    --quick) presets=(ci) tidy=0 ci_options=(-DWHITTLE_UNIT_TESTS=ON) ;;
    --thorough) ci_options=(-DWHITTLE_EACH_HEADER=ON) sanitizer_options=(-DWHITTLE_DRAWING=ON) ;;
    --thread) presets=(tsan) tidy=0 ;;
    *)
      echo "usage: test/run.sh [--no-setup] [--quick|--thorough|--thread]" >&2
      exit 2
      ;;
  esac
done

cd "$(dirname "${BASH_SOURCE[0]}")/.."
step="setup"
trap 'result=$?; ((result == 0)) || echo "test/run.sh: FAILED in: $step" >&2' EXIT
begin() {
  step=$1
  printf 'test/run.sh: %d min %02d s: %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$step"
}

note=""
if ((setup)); then
  begin setup
  ./bootstrap.sh
  assets/fetch.sh bunny || note=" (without the bunny: the tests that need it were skipped)"
fi

begin formatting
mapfile -d '' -t sources < <(git ls-files -z --cached --others --exclude-standard -- \
  'modules/*.hh' 'modules/*.cc' 'apps/*.hh' 'apps/*.cc' 'bench/*.hh' 'bench/*.cc' 'test/*.hh' 'test/*.cc')
existing=()
for source in "${sources[@]}"; do
  [[ -f $source ]] && existing+=("$source")
done
clang-format --dry-run --Werror "${existing[@]}"
echo "test/run.sh: ${#existing[@]} sources are formatted"

if ((tidy)); then
  begin clang-tidy
  test/tidy.sh
fi

for preset in "${presets[@]}"; do
  begin "$preset: configure"
  options=("${sanitizer_options[@]}")
  [[ $preset == ci ]] && options=("${ci_options[@]}")
  cmake --preset "$preset" "${options[@]}"
  begin "$preset: build"
  cmake --build --preset "$preset"
  begin "$preset: tests"
  ctest --preset "$preset" -j "$(nproc)"
done

begin "end"
checked="formatting"
((tidy)) && checked+=", clang-tidy"
echo "test/run.sh: all passed: $checked, ${presets[*]}$note"
