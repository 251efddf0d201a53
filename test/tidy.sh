#!/usr/bin/env bash
# clang-tidy over the library's headers, by way of test/headers/everything.cc, and over the sources that a change touches:
# those that differ from where this branch left origin/main or, on main itself, from the commit before.
#   test/tidy.sh
# At most 12 touched sources are looked at, those with the most changed lines; how many are left out is reported. Every
# source: cmake --preset tidy && cmake --build --preset tidy, which takes an hour.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
most=12

cmake --preset tidy >/dev/null
# Version.cc includes a header that the build makes.
cmake --build --preset tidy --target whittle_commit >/dev/null

base=$(git merge-base HEAD origin/main 2>/dev/null || true)
if [[ -z $base || $base == $(git rev-parse HEAD) ]]; then base=$(git rev-parse --verify -q HEAD~1 || true); fi

touched=()
if [[ -n $base ]]; then
  # Only what the build compiles: clang-tidy would guess the flags of the rest.
  while IFS=$'\t' read -r _ _ source; do
    [[ -f $source ]] && grep -q "\"$PWD/$source\"" build/tidy/compile_commands.json && touched+=("$source")
  done < <(git diff --numstat --no-renames "$base" -- '*.cc' | sort -rn)
else
  echo "test/tidy.sh: the history is too short to tell what has changed: only the headers are looked at"
fi
left_out=$((${#touched[@]} > most ? ${#touched[@]} - most : 0))

echo "test/tidy.sh: the library's headers and ${#touched[@]} touched sources$( ((left_out)) && echo " but $left_out")"
# The headers take as long as several sources, so they begin first.
look_at() {
  if [[ $1 == test/headers/everything.cc ]]; then
    clang-tidy --quiet "$1" -- -std=c++17 -I modules -isystem /usr/include/eigen3
  else
    clang-tidy --quiet -p build/tidy "$1"
  fi
}
export -f look_at
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1  # as the presets for clang have it
printf '%s\0' test/headers/everything.cc "${touched[@]:0:most}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'look_at "$1"' bash
