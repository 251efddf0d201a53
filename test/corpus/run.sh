#!/usr/bin/env bash
# Every mesh in the data of Debian's libcgal-demo through every module with two thresholds, guarantees checked.
#   test/corpus/run.sh   leaves results/corpus.md; the exit status is 1 if something does not hold
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=build/corpus-data
if [[ ! -e $folder/complete ]]; then
  rm -rf "$folder" && mkdir -p "$folder"
  (
    cd "$folder"
    apt-get download -q -o APT::Sandbox::User=root libcgal-demo
    dpkg-deb -x libcgal-demo_*.deb deb
    # An archive within the package; the demos and examples beside it bring no meshes of their own.
    find deb -name data.tar.gz -exec tar -xzf {} \;
    touch complete
  )
fi
cmake --preset release >/dev/null
cmake --build --preset release --target whittle_corpus >&2
mkdir -p results
build/release/test/corpus/whittle_corpus "$folder/data" | tee results/corpus.md
