#!/bin/sh
# Compiles the engine for browsers and for Node, and puts two things together: the page for trying programs,
# build/playground/page/index.html, which opens from the disk, and the package for JavaScript, build/playground/package.
# The self-test is compiled too; tests/test_javascript.py runs it. Needs Emscripten (Debian: apt-get install emscripten, 900 MB) and takes minutes the first time.
# Without it the exit status is 77.
set -eu
cd "$(dirname "$0")/.."
VENV=${VENV:-.venv}
PATH=$PWD/$VENV/bin:$PATH
build=build/playground/wasm
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} # where Debian keeps what Emscripten needs of Node

if ! command -v em++ >/dev/null; then
    echo "skipped: there is no Emscripten here. On Debian: apt-get install emscripten" >&2
    exit 77
fi
toolchain=$(dirname "$(readlink -f "$(command -v em++)")")/cmake/Modules/Platform/Emscripten.cmake
[ -f "$toolchain" ] || toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
cmake -S . -B $build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-Os -DNDEBUG" -DCNCSUB_PYTHON=OFF -DCNCSUB_PRECOMPILE=OFF -DCNCSUB_SELFTEST=ON >build/playground.log 2>&1 &&
    cmake --build $build --target cncsub selftest ${JOBS:+-j "$JOBS"} >>build/playground.log 2>&1 || { tail -n 30 build/playground.log; exit 1; }
python3 tools/javascript.py $build/cpp/wasm build/playground/package
python3 tools/playground.py $build/cpp/wasm build/playground/page
