#!/usr/bin/env bash
# Makes the Debian package, installs it in a minimal Debian 12 of its own, and there makes, runs and reports a case.
# As root, with debootstrap, from the mirror that this machine's apt uses. The report stays in the folder that is named.
#
#   scripts/try_package.sh [OUT [KIND]]     OUT: runs/package unless said otherwise; KIND: a case of `tremolo new`, slope
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-runs/package}
kind=${2:-slope}

scripts/setup.sh
scripts/build.sh release
work=$(mktemp -d)
root=$work/root
leave() {
  umount -q "$root/dev/shm" "$root/proc" 2> /dev/null || true
  rm -rf "$work"
}
trap leave EXIT

cpack --config build/release/CPackConfig.cmake -B "$work/package"
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | head -1)
debootstrap --variant=minbase bookworm "$root" "$mirror"
cp /etc/apt/sources.list "$root/etc/apt/" 2> /dev/null || true
cp -r /etc/apt/sources.list.d /etc/apt/apt.conf.d /etc/apt/keyrings "$root/etc/apt/" 2> /dev/null || true
cp /etc/resolv.conf "$root/etc/"
mount -t proc proc "$root/proc"
mkdir -p "$root/dev/shm"
mount -t tmpfs tmpfs "$root/dev/shm"

cp "$work"/package/*.deb "$root/tmp/tremolo.deb"
in_root() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
times=()
step() { # step WHAT COMMAND ...: does it in the minimal root, and notes how long it took
  local begin=$SECONDS
  in_root "${@:2}"
  times+=("$((SECONDS - begin)) s: $1")
}
in_root apt-get update -q
step "install the package and what it needs" apt-get install -q -y --no-install-recommends /tmp/tremolo.deb
step "tremolo new" sh -c "cd /root && tremolo new trial --like $kind"
step "tremolo explain" sh -c "cd /root && tremolo explain trial/case.toml"
step "tremolo run" sh -c "cd /root && tremolo run trial/case.toml --threads $(nproc)"
step "tremolo plot" sh -c "cd /root && tremolo plot runs/trial"
step "tremolo report" sh -c "cd /root && tremolo report runs/trial"
mkdir -p "$out"
cp "$root/root/runs/trial/report.html" "$out/"
printf '%s\n' "${times[@]}"
echo "try_package: installed and run in a bare Debian 12; its report: $out/report.html"
