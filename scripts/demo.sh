#!/usr/bin/env bash
# Set-up, Release build, the slope under an SV wave that comes in at 15 degrees, its pictures and its report.
set -euo pipefail
cd "$(dirname "$0")/.."

out=runs/demo # a run does not overwrite another one: demo-2, demo-3, ...
for ((n = 2; ; n++)); do
  [ -e "$out" ] || break
  out=runs/demo-$n
done

scripts/setup.sh
scripts/build.sh release tremolo tremolo-wave tremolo-column tremolo-domain
build/release/bin/tremolo run cases/slope_oblique/case.toml --angle 15 --threads "$(nproc)" --out "$out" --report
build/release/bin/tremolo plot "$out"
echo "demo: results in $PWD/$out (run.h5; run.xdmf opens in ParaView), pictures:"
ls "$PWD/$out"/pictures/*.png
echo "demo: the report, for any browser: $PWD/$out/report.html"
