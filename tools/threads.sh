#!/bin/sh
# Runs one library in many threads under the thread sanitizer: sh tools/threads.sh
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

install .
PATH=$PWD/$VENV/bin:$PATH
cmake --preset threads
cmake --build --preset threads
exec build/threads/cpp/fuzz/threads
