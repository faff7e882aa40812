#!/bin/sh
# Compiles the engine and its self-test for other systems and with other compilers, and runs the self-test where this
# machine can: sh tools/ports.sh [PORT...]
#
#   libc++         Linux with Clang and LLVM's own library                      runs
#   mingw          Windows, Debian's cross compiler                             runs under Wine
#   windows        Windows, Clang and libc++ as Zig brings them                 runs under Wine
#   aarch64        Linux on ARM                                                 runs under qemu-user
#   musl           Linux with musl, x86_64                                      runs
#   musl-aarch64   Linux with musl on ARM                                       runs under qemu-user
#   old-glibc      Linux with glibc 2.17, x86_64                                runs
#   macos          macOS on Apple's processors                                  compiled and linked only
#   macos-x86_64   macOS on Intel's                                             compiled and linked only
#
# Zig comes from the package index (pip install ziglang) into build/zig, unless ZIG names a Python that has it. What
# this machine cannot do is told as SKIPPED; the exit status is 1 where anything failed, and 77 where all was skipped.
set -u
cd "$(dirname "$0")/.."
. tools/zig.sh

ALL="libc++ mingw windows aarch64 musl musl-aarch64 old-glibc macos macos-x86_64"
ROWS=${ROWS:-build/ports/selftest.rows}
CMAKE=$(command -v cmake || echo .venv/bin/cmake)
NINJA=$(command -v ninja || echo "$PWD/.venv/bin/ninja")
FLAGS=${FLAGS:--O1} # of the compiler: what is looked for is not speed
export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER:-}" WINEDEBUG=-all
mkdir -p build/ports
failed="" skipped="" done=""

skip() {
    echo "== $1: SKIPPED: $2"
    skipped="$skipped $1"
}

has() { command -v "$1" >/dev/null; }

# build PORT SYSTEM COMPILER OPTION...: the self-test, in build/ports/PORT.
build() {
    port=$1 system=$2 compiler=$3
    shift 3
    "$CMAKE" -S . -B "build/ports/$port" -G Ninja -DCMAKE_MAKE_PROGRAM="$NINJA" -DCMAKE_SYSTEM_NAME="$system" \
        -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Ports -DCMAKE_CXX_FLAGS_PORTS="$FLAGS" \
        -DCNCSUB_PYTHON=OFF -DCNCSUB_SELFTEST=ON -DCNCSUB_WERROR=ON -DCNCSUB_PRECOMPILE=OFF "$@" >"build/ports/$port.log" 2>&1 &&
        "$CMAKE" --build "build/ports/$port" --target selftest >>"build/ports/$port.log" 2>&1 ||
        { tail -n 30 "build/ports/$port.log"; return 1; }
}

# with_zig PORT SYSTEM TARGET
with_zig() {
    if ! compiler=$(zig "$3"); then
        skip "$1" "there is no Zig here; pip install ziglang, or ZIG=.../python that has it"
        return 77
    fi
    build "$1" "$2" "$compiler" -DCNCSUB_PRECOMPILE=ON -DCMAKE_CXX_FLAGS=-g0 -DCMAKE_AR="$PWD/build/zig/ar" -DCMAKE_RANLIB=/bin/true \
        -DCMAKE_SYSTEM_PROCESSOR="${3%%-*}" -DCMAKE_INSTALL_NAME_TOOL=/bin/true -DCMAKE_OSX_SYSROOT=/ \
        -DCMAKE_HAVE_LIBC_PTHREAD=ON
}

# run PORT [RUNNER...]: the self-test on the rows, by a runner such as wine64.
run() {
    port=$1
    shift
    program=build/ports/$port/cpp/selftest/selftest
    [ -f "$program" ] || program=$program.exe
    "$@" "$program" "$ROWS" || return 1
    # A test that notices nothing is none: one step of one row is another one here.
    awk -F '\t' -v OFS='\t' '$1 == "step" && !done { $3 += 1; done = 1 } { print } NR > 999 && $1 == "end" { exit }' \
        "$ROWS" >build/ports/$port.wrong
    if "$@" "$program" build/ports/$port.wrong >build/ports/$port.wrong.log; then
        echo "the self-test does not notice a wrong row"
        return 1
    fi
    grep -q ', 1 failed' build/ports/$port.wrong.log
}

wine_is() { has wine64 || [ -x /usr/lib/wine/wine64 ]; }
wine() { # a home of its own, and no window
    WINEPREFIX=$PWD/build/ports/wine WINEDLLOVERRIDES=mscoree,mshtml= "$(command -v wine64 || echo /usr/lib/wine/wine64)" "$@"
}

# port NAME: compiles and runs one; 77 where it is skipped.
port() {
    case $1 in
    libc++)
        clang=$(command -v clang++ || command -v clang++-16) || { skip "$1" "there is no Clang; apt-get install clang-16"; return 77; }
        echo '#include <version>' | "$clang" -stdlib=libc++ -x c++ -fsyntax-only - 2>/dev/null ||
            { skip "$1" "Clang has no libc++; apt-get install libc++-16-dev libc++abi-16-dev"; return 77; }
        build "$1" Linux "$clang" -DCMAKE_CXX_FLAGS=-stdlib=libc++ && run "$1" ;;
    mingw)
        has x86_64-w64-mingw32-g++-posix || { skip "$1" "apt-get install g++-mingw-w64-x86-64-posix"; return 77; }
        build "$1" Windows x86_64-w64-mingw32-g++-posix && under "$1" wine ;;
    windows) with_zig "$1" Windows x86_64-windows-gnu && under "$1" wine ;;
    aarch64) with_zig "$1" Linux aarch64-linux-gnu && under "$1" qemu ;;
    musl) with_zig "$1" Linux x86_64-linux-musl && run "$1" ;;
    musl-aarch64) with_zig "$1" Linux aarch64-linux-musl && under "$1" qemu ;;
    old-glibc) with_zig "$1" Linux x86_64-linux-gnu.2.17 && run "$1" ;;
    macos) with_zig "$1" Darwin aarch64-macos ;;
    macos-x86_64) with_zig "$1" Darwin x86_64-macos ;;
    *)
        echo "there is no port $1; there are: $ALL" >&2
        return 2 ;;
    esac
}

# under PORT wine|qemu: runs it where that is installed.
under() {
    case $2 in
    wine)
        wine_is || { skip "$1 (compiled)" "it cannot run here; apt-get install wine64"; return 77; }
        run "$1" wine ;;
    qemu)
        has qemu-aarch64 || { skip "$1 (compiled)" "it cannot run here; apt-get install qemu-user"; return 77; }
        arm=/usr/aarch64-linux-gnu # of Debian's libc6-arm64-cross
        if [ -d $arm ] || [ "$1" = musl-aarch64 ]; then
            run "$1" qemu-aarch64 -L $arm
        else
            skip "$1 (compiled)" "it cannot run here; apt-get install libc6-arm64-cross"
            return 77
        fi ;;
    esac
}

if [ ! -f "$ROWS" ]; then
    .venv/bin/python tools/selftest_rows.py "$ROWS" || exit 1
fi
for name in ${*:-$ALL}; do
    echo "== $name"
    start=$(date +%s)
    port "$name"
    case $? in
    0) done="$done $name"; echo "== $name: passed, $(($(date +%s) - start)) s" ;;
    77) ;;
    *) failed="$failed $name"; echo "== $name: FAILED" ;;
    esac
done
echo "== passed:${done:- none}; skipped:${skipped:- none}; failed:${failed:- none}"
[ -z "$failed" ] || exit 1
[ -n "$done" ] || exit 77
