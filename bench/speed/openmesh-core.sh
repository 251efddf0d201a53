#!/usr/bin/env bash
# Builds the core library of the installed OpenMesh without assertions, for comparison with Debian's, which has them.
#   bench/speed/openmesh-core.sh [FOLDER]      FOLDER defaults to build/openmesh-ndebug
# The source is Debian's own source package of the installed version; the library has Debian's soname, so that
#   LD_LIBRARY_PATH=FOLDER whittle-speed …
# runs on it. Safe to run again: what is there and of the installed version stays.
set -euo pipefail
export LC_ALL=C

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=${1:-build/openmesh-ndebug}

fail() {
  echo "openmesh-core: $*" >&2
  exit 1
}

# dpkg's version may end in +bN, a rebuild of the same source; the field source:Version leaves that out.
version=$(dpkg-query -W -f '${source:Version}' libopenmesh-dev 2>/dev/null) ||
  fail "libopenmesh-dev is not installed; run ./bootstrap.sh"
if [[ -f $target/version && $(<"$target/version") == "$version" ]]; then
  echo "openmesh-core: $target holds OpenMesh $version already"
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/sources" "$work/source"

# The machine's own package sources, asked for source packages: no list of the system is touched.
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [[ -f $file ]] && sed -n 's/^deb \(.*\)/deb-src \1/p' "$file" >>"$work/sources/machine.list"
done
for file in /etc/apt/sources.list.d/*.sources; do
  [[ -f $file ]] && sed 's/^Types:.*/Types: deb-src/' "$file" >"$work/sources/$(basename "$file")"
done
options=(
  -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/sources" -o Dir::State::Lists="$work/lists"
  -o Dir::Cache::pkgcache="" -o Dir::Cache::srcpkgcache="" -o APT::Sandbox::User=root
)

# step MESSAGE COMMAND...: runs a command; if it fails, shows the end of what it said.
step() {
  local message=$1
  shift
  "$@" >"$work/log" 2>&1 || {
    tail -n 5 "$work/log" >&2
    fail "$message"
  }
}
echo "openmesh-core: fetching the source package openmesh $version"
step "cannot read the package lists" apt-get "${options[@]}" update -q
(cd "$work/source" && step "cannot download the source package openmesh $version" \
  apt-get "${options[@]}" source --download-only -q "openmesh=$version")
# Unpacked with Debian's patches; dpkg-source comes with build-essential.
step "cannot unpack the source package" dpkg-source --no-check -x "$work"/source/*.dsc "$work/openmesh"

core=$work/openmesh/src/OpenMesh/Core
[[ -d $core ]] || fail "the source package has no src/OpenMesh/Core"
debian_core=$(ldconfig -p | sed -n 's/.*libOpenMeshCore\.so\.[^ ]* .* => //p' | head -n 1)
[[ -n $debian_core ]] || fail "the installed libOpenMeshCore cannot be found"
soname=$(objdump -p "$debian_core" | sed -n 's/^ *SONAME *//p')
[[ -n $soname ]] || fail "the installed libOpenMeshCore has no soname"

echo "openmesh-core: compiling $soname with -O2 -DNDEBUG"
compiler=${CXX:-c++} include=$work/openmesh/src
mapfile -t sources < <(find "$core" -name '*.cc' ! -name '*T_impl.cc' | sort)
export compiler include
compile() {  # SOURCE OBJECT
  "$compiler" -std=c++17 -O2 -DNDEBUG -DOPENMESHDLL -DBUILDOPENMESHDLL -fPIC -w -I"$include" -c "$1" -o "$2"
}
export -f compile
for source in "${sources[@]}"; do
  object=${source#"$core/"}
  printf '%s\0%s\0' "$source" "$work/${object//\//_}.o"
done | xargs -0 -n 2 -P "$(nproc)" bash -c 'compile "$0" "$1"' || fail "OpenMesh's core does not compile"
"$compiler" -shared -Wl,-soname,"$soname" -o "$work/$soname" "$work"/*.o || fail "OpenMesh's core does not link"
! objdump -T "$work/$soname" | grep -q __assert_fail || fail "the new library still has assertions"

mkdir -p "$target"
rm -f "$target/version"
mv "$work/$soname" "$target/$soname"
echo "$version" >"$target/version"
echo "openmesh-core: wrote $target/$soname"
