#!/usr/bin/env bash
# Runs the command lines of the pages in a folder with small meshes. Of programs that take long or need a screen, and
# of lines with placeholders, only the options are looked up in the program's help or in the script.
#   [SANITIZE=NAMES] commands.sh PROGRAMS SOURCE COMMANDS [SHELL_SCRIPT ...]
# PROGRAMS are folders, joined by colons; COMMANDS is what blocks.awk leaves: PLACE, a tab, the line.
# SANITIZE: what the programs are built with; sanitizers need more address space than any sensible limit leaves.
set -uo pipefail
export PATH=$1:$PATH
source=$2 commands=$3
shift 3

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

# A torus of 2,400 faces, as OBJ and, with colours, as PLY.
awk -v obj=bunny.obj -v ply=scan.ply 'BEGIN {
  n = 60; m = 20; pi = atan2(0, -1)
  print "ply\nformat ascii 1.0\nelement vertex " n * m > ply
  print "property float x\nproperty float y\nproperty float z" > ply
  print "property uchar red\nproperty uchar green\nproperty uchar blue" > ply
  print "element face " 2 * n * m "\nproperty list uchar int vertex_indices\nend_header" > ply
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
    u = 2 * pi * i / n; v = 2 * pi * j / m; r = 0.7 + 0.3 * cos(v)
    p = sprintf("%.6f %.6f %.6f", r * cos(u), r * sin(u), 0.3 * sin(v))
    print "v " p > obj
    print p, 4 * i, 12 * j, 100 > ply
  }
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
    a = i * m + j; b = (i + 1) % n * m + j; c = (i + 1) % n * m + (j + 1) % m; d = i * m + (j + 1) % m
    print "f", a + 1, b + 1, c + 1 "\nf", a + 1, c + 1, d + 1 > obj
    print 3, a, b, c "\n" 3, a, c, d > ply
  }
}'
gzip -k scan.ply
mkdir -p scans/inner small
cp scan.ply scans/a.ply
cp bunny.obj scans/inner/b.obj

failed=0 ran=0 looked_up=0
fail() {
  echo "$1: $2" >&2
  failed=1
}

# Options of a line: known PLACE HELP LINE
known() {
  local option
  for option in $(grep -oE -- '(^|[ [|])--[a-z][a-z-]*' <<<"$3" | grep -oE -- '--[a-z-]+'); do
    grep -qE -- "$option([^a-z-]|$)" <<<"$2" || fail "$1" "no option $option: $3"
  done
  looked_up=$((looked_up + 1))
}

# Checks one line without its comment: check PLACE LINE
check() {
  local place=$1 line=$2 program command output
  read -r program command _ <<<"$line"
  [[ -n ${SANITIZE:-} ]] && line=$(sed -E 's/ --memory-limit [0-9]+//' <<<"$line")
  case $line in
    "whittle "*[][A-Z]* | *"build/release/"*)
      # A synopsis, or a line with a placeholder.
      line=${line#*cli/}
      read -r program command _ <<<"$line"
      known "$place" "$(whittle "$command" --help 2>&1)" "$line"
      ;;
    "whittle "* | "zcat "* | "find scans "*)
      output=$(eval "$line" 2>&1) || fail "$place" "$line: $output"
      ran=$((ran + 1))
      # What a simplification leaves can be read.
      [[ $line == "whittle simplify "* ]] && { whittle info "$(cut -d' ' -f4 <<<"$line")" --quiet || fail "$place" "$line"; }
      [[ $line == *">"* ]] && { whittle info "${line##*> }" --quiet || fail "$place" "$line"; }
      ;;
    "parallel "*"'"*"'"*)
      line=${line#*"whittle "}
      known "$place" "$(whittle "${line%% *}" --help 2>&1)" "whittle ${line%%"'"*}"
      ;;
    whittle-*)
      command -v "$program" >/dev/null && known "$place" "$("$program" --help 2>&1; "$program" report --help 2>&1)" "$line"
      ;;
    "bench/reproduce.sh"*)  # hands its options on
      command -v whittle-bench >/dev/null && known "$place" "$(cat "$source/$program"; whittle-bench --help)" "$line"
      ;;
    bench/*.sh* | test/*.sh* | assets/*.sh* | ./bootstrap.sh*)
      if [[ -x $source/$program ]]; then known "$place" "$(cat "$source/$program")" "$line"
      else fail "$place" "no such script: $program"; fi
      ;;
  esac
}

# A line that is indented further goes on with the one before.
place="" line=""
while IFS=$'\t' read -r next_place text; do
  text=${text%%  #*}
  if [[ $text == " "* ]]; then
    line+=" $text"
    continue
  fi
  [[ -n $line ]] && check "$place" "$line"
  place=$next_place line=$text
done <"$commands"
[[ -n $line ]] && check "$place" "$line"

for script in "$@"; do
  rm -rf small
  output=$(sh "$script" 2>&1) || fail "$script" "$output"
  ran=$((ran + 1))
done

echo "$ran command lines ran, the options of $looked_up others are known"
((ran >= 10 && looked_up >= 10)) || fail commands.sh "hardly any command lines were found"
exit $failed
