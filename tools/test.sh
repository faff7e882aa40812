#!/bin/sh
# Makes .venv, installs cncsub with what its tests need, and runs them on all cores. Arguments go to pytest:
# sh tools/test.sh -k calls
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

install '.[test]'
exec "$VENV/bin/python" -m pytest --numprocesses auto --dist worksteal "$@"
