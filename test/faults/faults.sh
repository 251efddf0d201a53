#!/usr/bin/env bash
# What the command line does when things go wrong around it.
#   faults.sh WHITTLE killed|batch-killed|file-limit|full-disk|read-only|truncated [FILE ...]
# Exit status 77: cannot be tried here, and a line says why. `truncated` takes further files to cut.
set -euo pipefail

whittle=$(realpath "$1") fault=$2
shift 2
further=("$@")
for i in "${!further[@]}"; do further[i]=$(realpath "${further[i]}"); done

# A file system of its own needs a mount namespace, as root or as a user who may make one.
if [[ $fault == full-disk || $fault == read-only ]] && [[ -z ${WHITTLE_OWN_MOUNTS:-} ]]; then
  for own in "unshare --mount" "unshare --mount --user --map-root-user"; do
    # shellcheck disable=SC2086 # words
    if $own sh -c 'mount -t tmpfs tmpfs /mnt' 2>/dev/null; then
      WHITTLE_OWN_MOUNTS=1 exec $own "${BASH_SOURCE[0]}" "$whittle" "$fault"
    fi
  done
  echo "SKIP: no file system may be mounted here"
  exit 77
fi

folder=$(mktemp -d)
trap 'umount "$folder/disk" 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "FAILED: $*" >&2; exit 1; }

# A wavy square of 2 N^2 faces.
waves() {
  awk -v n="$1" 'BEGIN {
    print "OFF"; print (n + 1)^2, 2 * n^2, 0
    for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j) print i, j, 2 * sin(i / 7) * cos(j / 5)
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
      a = i * (n + 1) + j; b = a + n + 1
      print 3, a, b, b + 1; print 3, a, b + 1, a + 1
    }
  }'
}

# Runs whittle; sets code. What it says on standard error goes to the file err.
try() {
  code=0
  "$whittle" "$@" >out 2>err </dev/null || code=$?
}

# Exit code 2, and one line that says what.
refused() { [[ $code == 2 && $(wc -l <err) == 1 ]] && grep -qi "$1" err || fail "exit code $code: $(cat err)"; }

# The old file is whole and nothing stands beside it.
untouched() {
  cmp -s old "$1/out.ply" || fail "the old file has changed"
  [[ $(ls -A "$1") == out.ply ]] || fail "left behind: $(ls -A "$1")"
}

# The old file for a fault, and a large input whose result does not fit where the old one did.
old_and_large() {
  waves 20 >small.off
  waves 150 >large.off
  try simplify small.off old --format ply --ratio 0.5 --quiet
  [[ $code == 0 ]] || fail "$(cat err)"
}

case $fault in
  killed)
    old_and_large
    mkdir to
    begun=$(date +%s%N)
    try simplify large.off to/out.ply --ratio 0.9 --quiet
    whole_run=$(($(date +%s%N) - begun))
    finished=0 kills=0
    for part in $(seq 10); do
      cp old to/out.ply
      "$whittle" simplify large.off to/out.ply --ratio 0.9 --quiet 2>err &
      child=$!
      sleep "$(awk -v part="$part" -v whole="$whole_run" 'BEGIN { print whole * part / 10e9 }')"
      kill -KILL "$child" 2>/dev/null && kills=$((kills + 1))
      wait "$child" 2>/dev/null || true
      if ! cmp -s old to/out.ply; then
        try info to/out.ply --quiet
        [[ $code == 0 ]] || fail "half a file: $(cat err)"
        finished=$((finished + 1))
      fi
    done
    ((kills > 0)) || fail "none was killed"
    try simplify large.off to/out.ply --ratio 0.9 --quiet
    [[ $code == 0 ]] || fail "afterwards: $(cat err)"
    echo "killed $kills times; $finished new files of 10 were there already"
    ;;
  batch-killed)
    mkdir scans
    for i in $(seq 12); do waves $((100 + i)) >"scans/m$i.off"; done
    setsid "$whittle" batch scans --out small --ratio 0.3 --jobs 2 --quiet >out 2>err &
    child=$!
    until compgen -G 'small/*.off' >/dev/null; do sleep 0.01; kill -0 "$child" || fail "$(cat err)"; done
    kill -KILL -- "-$child" || fail "was done too soon"
    wait "$child" 2>/dev/null || true
    before=$(find small -name '*.off' -not -path '*/.whittle/*' | wc -l)
    for result in small/*.off; do
      try info "$result" --quiet
      [[ $code == 0 ]] || fail "half a file: $result"
    done
    try batch scans --out small --ratio 0.3 --jobs 2 --resume --quiet
    [[ $code == 0 ]] || fail "resumed: $(cat err)"
    [[ $(find small -name '*.off' -not -path '*/.whittle/*' | wc -l) == 12 ]] || fail "not all are there"
    [[ -z $(find small/.whittle/claims small/.whittle/work -type f) ]] || fail "left behind: $(find small/.whittle)"
    echo "$before of 12 were done when the batch was killed"
    ;;
  file-limit)
    old_and_large
    mkdir to
    cp old to/out.ply
    code=0
    (ulimit -f 100; trap '' XFSZ; exec "$whittle" simplify large.off to/out.ply --ratio 0.9 --quiet) >out 2>err || code=$?
    refused "File too large"
    untouched to
    # Without a word for the signal it is killed in the middle of writing.
    code=0
    (ulimit -c 0; ulimit -f 100; exec "$whittle" simplify large.off to/out.ply --ratio 0.9 --quiet) >out 2>err || code=$?
    ((code > 128)) || fail "was not killed: exit code $code"
    untouched to
    ;;
  full-disk)
    old_and_large
    mkdir disk
    mount -t tmpfs -o size=256k tmpfs disk
    cp old disk/out.ply
    try simplify large.off disk/out.ply --ratio 0.9 --quiet
    refused "No space left"
    untouched disk
    try lods large.off --levels 3 --ratio 0.2 --samples 100 --out disk/l.ply --quiet
    refused "No space left"
    untouched disk
    try simplify small.off disk/out.ply --ratio 0.7 --quiet
    [[ $code == 0 ]] || fail "there is room for this: $(cat err)"
    mkdir scans
    cp large.off small.off scans
    try batch scans --out disk --ratio 0.9 --jobs 1 --quiet
    [[ $code == 1 || $code == 2 ]] || fail "batch: exit code $code"
    [[ -e disk/small.off && ! -e disk/large.off ]] || fail "batch left $(ls disk)"
    ;;
  read-only)
    old_and_large
    mkdir disk
    mount -t tmpfs tmpfs disk
    cp old disk/out.ply
    mount -o remount,ro disk
    for target in out.ply new.ply; do
      try simplify small.off "disk/$target" --ratio 0.9 --quiet
      refused "Read-only file system"
    done
    try batch small.off --out disk/new --ratio 0.9
    [[ $code == 2 ]] || fail "batch: exit code $code"
    untouched disk
    ;;
  truncated)
    waves 12 >in.off
    for file in w.obj w.off w.ply w.stl w.om w.glb; do "$whittle" simplify in.off "$file" --ratio 0.8 --quiet; done
    for file in t.ply t.stl; do "$whittle" simplify in.off "$file" --ratio 0.8 --ascii --quiet; done
    runs=0
    for file in [wt].* "${further[@]}"; do
      size=$(stat -c %s "$file") cut=cut.${file##*.}
      for percent in 0 $(seq 3 12 99); do  # the readers' own tests cut at every byte
        head -c $((size * percent / 100)) "$file" >"$cut"
        rm -f result.ply
        try simplify "$cut" result.ply --ratio 0.5 --quiet
        runs=$((runs + 1))
        case $code in
          0 | 1) [[ -e result.ply ]] ;;
          2) [[ $(wc -l <err) == 1 && ! -e result.ply ]] ;;
          *) false ;;
        esac || fail "$file cut at $percent %: exit code $code: $(cat err)"
      done
      # A cut that no reader notices everywhere would mean that nothing was cut.
      [[ $code == 2 || $file == *.obj ]] || fail "$file without its last percent: exit code $code"
    done
    echo "$runs cut files"
    ;;
  *)
    fail "no such fault: $fault"
    ;;
esac
