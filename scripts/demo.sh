#!/usr/bin/env bash
# Set-up, Release build, the slope under an SV wave that comes in at 15 degrees, and its pictures.
set -euo pipefail
cd "$(dirname "$0")/.."
out=runs/slope_15

scripts/setup.sh
scripts/build.sh release
build/release/bin/tremolo run cases/slope_oblique/case.toml --out "$out"
build/release/bin/tremolo plot "$out"
echo "demo: results in $out/run.h5 (run.xdmf for ParaView), pictures in $out/pictures:"
ls "$out"/pictures/*.png
