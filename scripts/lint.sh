#!/usr/bin/env bash
# clang-format and clang-tidy over all sources; fails if either has something to say. clang-tidy reads the compile
# commands of the preset "lint", in which each file is compiled alone and without precompiled headers; nothing is built.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
scripts/setup.sh lint
cmake --preset lint

git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror
git ls-files -z '*.cpp' | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/lint
echo "lint: clean"
