#!/bin/sh
# Builds the documentation in build/docs/site, with warnings as errors. The site needs no network, and opens from the disk:
# build/docs/site/index.html. `sh tools/docs.sh --serve` shows it at http://localhost:8000 instead.
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

install '.[docs]'
PYTHONPATH=docs "$VENV/bin/python" -m generator build/docs
if [ "${1:-}" = --serve ]; then
    exec "$VENV/bin/zensical" serve --config-file build/docs/mkdocs.yml
fi
# It shows Python's traceback where it stops for a warning; what it has found stands above that.
"$VENV/bin/zensical" build --strict --clean --config-file build/docs/mkdocs.yml
# The page for trying programs, where `sh tools/playground.sh` has made it.
[ ! -d build/playground/page ] || cp -r build/playground/page build/docs/site/playground
exec "$VENV/bin/python" tools/check_site.py build/docs/site
