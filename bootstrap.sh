#!/usr/bin/env bash
# Installs what Whittle is built and tested with, on Debian 12, by package name. Safe to run again.
#   bootstrap.sh [--peers]
# --peers  also CGAL and VTK, which the speed benchmark compares with where they are installed: some 200 packages more
set -euo pipefail

packages=(
  # Compilers and tools; clang for clang-tidy and the sanitizers' builds.
  build-essential clang clang-format clang-tidy lld cmake ninja-build ccache git pkg-config
  # The sanitizers of clang, and what names the lines in their reports.
  libclang-rt-14-dev llvm
  # The library: OpenMesh's headers lean on Eigen.
  libopenmesh-dev libeigen3-dev
  # The programs: command line, JSON, glTF and its compressions, gzip, distances (the Embree package brings TBB), PNG; meshoptimizer is a peer too.
  libcli11-dev nlohmann-json3-dev libtinygltf-dev libmeshoptimizer-dev libdraco-dev zlib1g-dev libembree-dev libpng-dev
  # Rendering: EGL without a window system, the software renderer, the viewer's window.
  libegl-dev libegl1 libgl1-mesa-dri libepoxy-dev libglfw3-dev libimgui-dev libfreetype-dev
  # A font that can be read; a display for tests, and a mouse on it.
  fonts-dejavu-core xvfb libxcb1-dev
  # Tests, which open the report in a browser, run batches in parallel and calculate with rationals, and certificates for
  # those who fetch over HTTPS.
  catch2 ca-certificates chromium parallel libgmp-dev
  # The API reference.
  doxygen
)

case ${1:-} in
  "") ;;
  --peers) packages+=(libcgal-dev libvtk9-dev) ;;
  *)
    echo "usage: bootstrap.sh [--peers]" >&2
    exit 2
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  echo "bootstrap: all ${#packages[@]} packages are installed; nothing to do"
  exit 0
fi
echo "bootstrap: installing ${missing[*]}"

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "bootstrap: needs root: run it as root, or install sudo" >&2
    exit 1
  fi
  as_root=(sudo)
fi

"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
echo "bootstrap: done"
