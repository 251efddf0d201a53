#!/usr/bin/env bash
# What gltfpack and gltf-transform make of the models of the suite `textured`, for --compare of whittle-speed.
#   bench/speed/textured-peers.sh DIR [REGEX]
# DIR    gets models/MODEL.glb, gltfpack/MODEL-PERCENT.glb and gltf-transform/MODEL-PERCENT.glb; what is there stays
# REGEX  only models in whose name it is found
# The commands are those of GLTFPACK and GLTF_TRANSFORM, as in GLTFPACK=node_modules/.bin/gltfpack; without the
# variables gltfpack and gltf-transform, and a program that is not there is left out. WHITTLE_SPEED is whittle-speed.
set -euo pipefail

dir=${1:?bench/speed/textured-peers.sh DIR [REGEX]}
speed=${WHITTLE_SPEED:-$(dirname "${BASH_SOURCE[0]}")/../../build/release/bench/speed/whittle-speed}
"$speed" --suite textured --only "${2:-.}" --export "$dir/models" --quiet

# peer NAME COMMAND FUNCTION: runs FUNCTION COMMAND MODEL RESULT RATIO for each model and share
peer() {
  if ! command -v "$2" >/dev/null; then
    echo "textured-peers: $1 is not there (\"$2\"), and is left out" >&2
    return
  fi
  mkdir -p "$dir/$1"
  for model in "$dir"/models/*.glb; do
    for percent in 50 25 10 5 2; do
      result=$dir/$1/$(basename "$model" .glb)-$percent.glb
      [[ -e $result ]] || "$3" "$2" "$model" "$result" "$(awk "BEGIN { print $percent / 100 }")" >/dev/null ||
        echo "textured-peers: $1 fails on $model" >&2
    done
  done
}
# No bound on the error, nothing quantised, attributes kept.
with_gltfpack() { "$1" -i "$2" -o "$3" -si "$4" -se 1 -noq -kv; }
with_gltf_transform() { "$1" simplify "$2" "$3" --ratio "$4" --error 1; }

peer gltfpack "${GLTFPACK:-gltfpack}" with_gltfpack
peer gltf-transform "${GLTF_TRANSFORM:-gltf-transform}" with_gltf_transform
