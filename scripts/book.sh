#!/usr/bin/env bash
# Builds the documentation as a site, with search, without a network: build/book/site/index.html. Search needs a server,
# which may be this machine: python3 -m http.server --directory build/book/site
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh

pages=build/book/pages
rm -rf build/book
mkdir -p "$pages"
cp README.md "$pages/index.md"
git ls-files --cached --others --exclude-standard -z CONTRIBUTING.md CHANGELOG.md 'docs/*.md' 'docs/*.png' \
  'docs/*.json' 'cases/*.md' 'cases/*.png' 'cases/*.toml' 'docs/examples/*' | xargs -0 cp --parents -t "$pages"
mkdocs build --quiet --config-file docs/book/mkdocs.yml
echo "book: $PWD/build/book/site/index.html"
