#!/usr/bin/env bash
# Three batches at once on one folder, started by GNU parallel: each mesh is done once, by whoever comes first.
#   parallel.sh WHITTLE PARALLEL
set -euo pipefail

whittle=$1 parallel=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir scans
{
  echo "OFF 4 4 0"
  printf '%s\n' "0 0 0" "1 0 0" "0 1 0" "0 0 1" "3 0 2 1" "3 0 1 3" "3 0 3 2" "3 1 2 3"
} >scans/first.off
for i in $(seq 30); do cp scans/first.off "scans/copy$i.off"; done

seq 3 | HOME=$folder "$parallel" -n0 --jobs 3 \
  "'$whittle' batch scans --out small --module ivdd:distance=0.1 --jobs 1 --resume --quiet"

results=$(find small -name '*.off' | wc -l)
lines=$(cat small/.whittle/log/*.jsonl | wc -l)
echo "parallel: $results results, $lines of them worked on"
[[ $results == 31 && $lines == 31 ]]
