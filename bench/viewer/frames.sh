#!/usr/bin/env bash
# How long the viewer's window is busy at a time while somebody works with a large mesh: on a display in memory with
# software OpenGL, the slowest that a user can have. Needs xvfb.
#   bench/viewer/frames.sh [MODEL [BUILD]]    by default the dragon, and build/release
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
model=$(realpath "${1:-$root/assets/cache/dragon.ply}")
viewer=$(realpath "${2:-$root/build/release}")/apps/viewer/whittle-viewer
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

names=()
# phase NAME COMMAND ...: the commands, and what the window did meanwhile by this name.
phase() {
  names+=("$1")
  shift
  printf '%s\n' "$@" "frame-times $folder/${#names[@]}.json" >> "$folder/script.txt"
}
turn=("drag left 0.3 0.5 0.7 0.6" "drag left 0.7 0.6 0.5 0.3" "scroll 0.5 0.5 3" "drag right 0.5 0.5 0.4 0.4")

phase "start" wait
phase "open, decimate, measure" "open '$model'" "shading smooth" wait
phase "turn, zoom, pan: shaded" "${turn[@]}"
phase "and come to rest" wait
phase "heat map" "heat on" "${turn[@]}" wait
phase "wire over shaded" "heat off" "shading wires-over" "${turn[@]}" wait
phase "wireframe" "shading wires" "${turn[@]}" wait
phase "feature edges, other angles" "shading smooth" "edges feature on" \
  "feature-angle 30" "feature-angle 50" "feature-angle 70" "${turn[@]}" wait
phase "plan" "edges feature off" "plan on" wait "${turn[@]}" wait
phase "split line" "plan off" "layout split" wait "drag left 0.5 0.9 0.2 0.9" "drag left 0.2 0.9 0.7 0.9" wait
phase "slider, live" "slide 1 radius 0.5 1.2 20" wait
phase "larger window" "resize 1600 1000" wait
echo close >> "$folder/script.txt"

Xvfb -displayfd 1 -screen 0 1920x1200x24 -nolisten tcp > "$folder/display" 2> /dev/null &
server=$!
trap 'kill "$server"; rm -rf "$folder"' EXIT
until [[ -s $folder/display ]]; do sleep 0.1; done
DISPLAY=:$(< "$folder/display") LIBGL_ALWAYS_SOFTWARE=1 "$viewer" --size 1440x900 --script "$folder/script.txt"

row="%-28s %6s %9s %8s %8s %9s %9s\n"
printf "$row" "milliseconds" times median p95 longest sketches pictures
for ((i = 1; i <= ${#names[@]}; ++i)); do
  field() { sed -n "s/.*\"$1\": \([0-9]*\.\?[0-9]\?\).*/\1/p" "$folder/$i.json"; }
  printf "$row" "${names[i - 1]}" "$(field times)" "$(field median_ms)" "$(field p95_ms)" "$(field max_ms)" \
    "$(field sketches)" "$(field pictures)"
done
