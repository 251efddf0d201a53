#!/usr/bin/env bash
# The Debian package: builds it, installs it on a bare Debian 12, and there simplifies a mesh, draws it without a screen
# and opens it in a window. Needs root and debootstrap.
#   test/package/run.sh [BUILD]   leaves the packages in build/package
# BUILD  a finished release build to pack; without, one is made in build/package
# The bare system is made once, in build/bare, with the mirror that debootstrap takes by default.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
packages=build/package bare=build/bare
build=${1:-$packages}

if (($# == 0)); then
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DWHITTLE_TESTS=OFF >/dev/null
  cmake --build "$build"
fi
mkdir -p "$packages"
rm -f "$packages"/*.deb
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$packages"

if [[ ! -e $bare/complete ]]; then
  rm -rf "$bare"
  debootstrap --variant=minbase bookworm "$bare"
  touch "$bare/complete"
fi
# A copy, so that what is installed for one check does not help the next.
root=$(mktemp -d)
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$root"' EXIT
cp -a "$bare/." "$root"
cp "$packages"/*.deb "$root/tmp"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"

chroot "$root" sh -eu <<'INSIDE'
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
cd /tmp
apt-get update -q
dpkg --field whittle_*.deb Depends
apt-get install -y -q --no-install-recommends ./whittle_*.deb >install.log 2>&1 || { cat install.log; exit 1; }
dpkg --status whittle | grep '^Status: install ok installed'
for program in /usr/bin/whittle*; do
  if ldd "$program" | grep 'not found'; then exit 1; fi
done
for program in whittle whittle-bench whittle-viewer; do $program --version; done
test -e /usr/share/man/man1/whittle.1  # the base system has no man to ask
bash -n /usr/share/bash-completion/completions/whittle
test -e /usr/share/zsh/vendor-completions/_whittle
test -e /usr/share/fish/vendor_completions.d/whittle.fish
awk 'BEGIN {
  n = 60
  print "OFF"; print (n + 1)^2, 2 * n^2, 0
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, 2 * sin(i / 7)
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    a = i * (n + 1) + j; b = a + n + 1
    print 3, a, b, b + 1; print 3, a, b + 1, a + 1
  }
}' >waves.off
for result in small.ply small.obj small.glb; do whittle simplify waves.off "$result" --ratio 0.1 --quiet; done
whittle info small.glb

# The renderer and the viewer open what the package only recommends; the viewer wants a screen, which Xvfb is.
if whittle-bench --list-devices; then echo 'whittle-bench found a renderer where none is installed'; exit 1; fi
apt-get install -y -q --no-install-recommends $(dpkg --field whittle_*.deb Recommends | tr -d ,) xvfb xauth >install.log 2>&1 ||
  { cat install.log; exit 1; }
whittle-bench --list-devices
whittle-bench --pictures-only --device software --experiments paper1 --sets vt --model waves.off --out drawn --quiet
ls drawn
xvfb-run -a whittle-viewer small.glb --screenshot window.png
for picture in window.png $(find drawn -name '*.png'); do test "$(head -c 4 "$picture" | tail -c 3)" = PNG; done
apt-get purge -y -q whittle >/dev/null 2>&1
test ! -e /usr/bin/whittle
INSIDE
echo "test/package/run.sh: installed, ran and went again: $(cd "$packages" && ls -- *.deb | tr '\n' ' ')"
