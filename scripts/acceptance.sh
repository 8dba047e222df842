#!/usr/bin/env bash
# Release build and the tests of label acceptance, which take too long for the suite: hours are allowed. What they
# measure, their bounds and the date go into docs/validation/acceptance.md.
#
#   scripts/acceptance.sh            all
#   scripts/acceptance.sh REGEX      those whose names match; prints their table and leaves the page alone
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
scripts/build.sh release
if [ $# -gt 0 ]; then
  tests/acceptance/table.py build/release --only "$1"
else
  tests/acceptance/table.py build/release docs/validation/acceptance.md
fi
