#!/bin/sh
# Builds the documentation in build/site, with warnings as errors; the site needs no network: sh tools/docs.sh
# Arguments go to `mkdocs build`. `SERVE=1 sh tools/docs.sh` shows it at http://127.0.0.1:8000 and builds again what changes.
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

install '.[docs]'
export NO_MKDOCS_2_WARNING=1 PYTHONPATH=docs
[ -z "${SERVE:-}" ] || exec "$VENV/bin/mkdocs" serve
"$VENV/bin/mkdocs" build --strict --quiet "$@"
exec "$VENV/bin/python" tools/check_site.py build/site
