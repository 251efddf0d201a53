#!/usr/bin/env bash
# Compiles headers with the warnings of a careful project, all of them errors.
#   check.sh alone    COMPILER STANDARD INCLUDE_DIR [SYSTEM_INCLUDE_DIR...]
#   check.sh each     COMPILER STANDARD INCLUDE_DIR [SYSTEM_INCLUDE_DIR...]
#   check.sh together COMPILER STANDARD INCLUDE_DIR [SYSTEM_INCLUDE_DIR...]
# alone     each header that users include, those in INCLUDE_DIR/whittle and its planners, as the only include, two at a
#           time
# each      the same for every header under INCLUDE_DIR/whittle
# together  everything.cc beside this script, which includes every header that users include: those right in
#           INCLUDE_DIR/whittle
set -euo pipefail

mode=$1 compiler=$2 standard=$3 include=$4
shift 4
everything=$(realpath "$(dirname "${BASH_SOURCE[0]}")")/everything.cc

flags=(-x c++ -std="$standard" -fsyntax-only -Werror -Wall -Wextra -Wpedantic -Wshadow -Wconversion
       -Wsign-conversion -I "$include")
for directory in "$@"; do
  # GCC looks there anyway, and its own headers break if the place in the search order changes.
  [[ $directory == /usr/include ]] || flags+=(-isystem "$directory")
done

compile() {
  local header=$1
  shift
  printf '#include "%s"\n' "$header" | "$@" - || {
    echo "$header does not compile alone: $*" >&2
    return 1
  }
}
export -f compile

cd "$include"
if [[ $mode == together ]]; then
  for header in whittle/*.hh; do
    grep -q "<$header>" "$everything" || { echo "$everything does not include $header" >&2; exit 1; }
  done
  "$compiler" "${flags[@]}" "$everything"
  echo "the headers compile together with $compiler -std=$standard"
  exit
fi
folders=(whittle whittle/planners) depth=(-maxdepth 1)
[[ $mode == each ]] && folders=(whittle) depth=()
mapfile -d '' -t headers < <(find "${folders[@]}" "${depth[@]}" -name '*.hh' -print0 2>/dev/null | sort -z)
((${#headers[@]})) || { echo "no headers in $include/whittle" >&2; exit 1; }
printf '%s\0' "${headers[@]}" | xargs -0 -P 2 -I '{}' bash -c 'compile "$@"' bash '{}' "$compiler" "${flags[@]}"
echo "${#headers[@]} headers compile alone with $compiler -std=$standard"
