#!/usr/bin/env bash
# Set-up, Release build and the whole test suite; the exit status is that of the tests.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
scripts/build.sh release
ctest --preset release --parallel "$(nproc)"
