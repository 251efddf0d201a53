#!/usr/bin/env bash
# Every mesh in the data of Debian's libcgal-demo through every module with two thresholds, guarantees checked.
#   test/corpus/run.sh   leaves results/corpus.md
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=build/corpus-data
if [[ ! -d $folder/data ]]; then
  rm -rf "$folder" && mkdir -p "$folder"
  (
    cd "$folder"
    apt-get download -q -o APT::Sandbox::User=root libcgal-demo
    dpkg-deb -x libcgal-demo_*.deb deb
    # Archives within the package hold the demos and their data.
    find deb -name '*.tar.gz' -print0 | while IFS= read -r -d '' archive; do tar -xzf "$archive"; done
    mkdir data
    find . -path ./data -prune -o -type f \( -name '*.off' -o -name '*.ply' -o -name '*.obj' -o -name '*.stl' \) -print0 |
      while IFS= read -r -d '' mesh; do
        name=${mesh#./}
        cp "$mesh" "data/${name//\//_}"
      done
  )
fi
cmake --preset release >/dev/null
cmake --build --preset release --target whittle_corpus
mkdir -p results
build/release/test/corpus/whittle_corpus "$folder/data" | tee results/corpus.md
