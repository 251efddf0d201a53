#!/usr/bin/env bash
# Compiles every header of a folder alone, as the only include. Fails if one of them gives an error or a warning.
#   check.sh COMPILER STANDARD INCLUDE_DIR [SYSTEM_INCLUDE_DIR...]
# The headers are INCLUDE_DIR/whittle/*.hh; two are compiled at a time.
set -euo pipefail

compiler=$1 standard=$2 include=$3
shift 3

flags=(-x c++ -std="$standard" -fsyntax-only -Werror -Wall -Wextra -Wpedantic -Wshadow -Wconversion
       -Wno-sign-conversion -I "$include")
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
headers=(whittle/*.hh)
[[ -f ${headers[0]} ]] || { echo "no headers in $include/whittle" >&2; exit 1; }
printf '%s\0' "${headers[@]}" | xargs -0 -P 2 -I '{}' bash -c 'compile "$@"' bash '{}' "$compiler" "${flags[@]}"
echo "${#headers[@]} headers compile alone with $compiler -std=$standard"
