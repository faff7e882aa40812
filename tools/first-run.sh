#!/bin/sh
# The main job, from nothing: makes .venv, installs cncsub into it and runs a shipped example.
# Further arguments go to `cncsub run` in place of the example: sh tools/first-run.sh job/ -c fanuc-0i-f
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

install '.[cli]'
[ $# -gt 0 ] || set -- examples/gsk/988ta-nested-self-call.nc -c gsk-988ta
exec "$VENV/bin/cncsub" run "$@"
