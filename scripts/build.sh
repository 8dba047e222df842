#!/usr/bin/env bash
# Configures one of the presets of CMakePresets.json and builds it, or some of its targets, into build/PRESET.
#
#   scripts/build.sh [PRESET [TARGET ...]]     release and everything unless said otherwise
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
targets=("${@:2}")

cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)" ${targets:+--target "${targets[@]}"}
