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
in_root apt-get update -q
in_root apt-get install -q -y --no-install-recommends /tmp/tremolo.deb
in_root sh -c "cd /root && tremolo new trial --like $kind && tremolo run trial/case.toml --threads $(nproc) --report"
mkdir -p "$out"
cp "$root/root/runs/trial/report.html" "$out/"
echo "try_package: installed and run in a bare Debian 12; its report: $out/report.html"
