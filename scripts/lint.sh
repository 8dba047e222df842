#!/usr/bin/env bash
# clang-format and clang-tidy over all sources; fails if either has something to say. Needs a Release build
# (scripts/build.sh), whose compile commands it reads.
set -euo pipefail
cd "$(dirname "$0")/.."
commands=build/release/compile_commands.json
[ -f "$commands" ] || { echo "lint: $commands is missing, run scripts/build.sh first" >&2; exit 1; }
scripts/setup.sh lint

git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror
git ls-files -z '*.cpp' | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release
echo "lint: clean"
