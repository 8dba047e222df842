#!/usr/bin/env bash
# Configures and builds one of the presets of CMakePresets.json into build/PRESET.
#
#   scripts/build.sh [PRESET]     release unless said otherwise
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}

cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)"
