# Sourced by `run`, `nightly` and `quick`: steps that go on after one has failed, and what they have in common.
# shellcheck shell=bash
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2
exec </dev/null
export CI=true CNCSUB_WERROR=ON
export SEED=${SEED:-2026} # of the made programs: what fails here fails again
export PIP_NO_INPUT=1 PIP_DISABLE_PIP_VERSION_CHECK=1 NO_COLOR=1
# The checkout may belong to another user than the one who runs this; pre-commit asks git for the files.
export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=safe.directory GIT_CONFIG_VALUE_0=$PWD

logs=build/ci
failed=()
export logs
minutes=${minutes:-85} # nothing runs on after these, whatever the steps' own limits add up to

# step NAME MINUTES COMMAND...: runs the command and keeps what it prints in build/ci/NAME.log. The minutes are those of a
# slow machine.
step() {
    local name=$1 start=$SECONDS seconds=$(($2 * 60)) left=$((minutes * 60 - SECONDS))
    shift 2
    [ "$seconds" -le "$left" ] || seconds=$left
    [ "$seconds" -ge 1 ] || seconds=1
    echo "== $name: $*"
    if timeout --kill-after=30 "${seconds}s" "$@" 2>&1 | tee "$logs/$name.log"; then
        echo "== $name: passed, $((SECONDS - start)) s"
    else
        failed+=("$name")
        echo "== $name: FAILED, $((SECONDS - start)) s"
    fi
}

# begin: an empty folder for the logs.
begin() {
    rm -rf "$logs"
    mkdir -p "$logs"
}

# The last line of pytest in a log, such as "==== 812 passed in 9.41s ====".
closing_line() {
    grep -E '(passed|failed|error|skipped|no tests ran).* in [0-9.]+s' "$logs/$1.log" | tail -n 1 | grep . ||
        echo "$1: pytest did not come to its end"
}

# finish NAME...: what failed, and the closing lines of these test runs, the main one last. Its status is that of all steps.
finish() {
    local name
    for name in ${failed+"${failed[@]}"}; do
        echo "== the end of what $name printed:"
        tail -n 40 "$logs/$name.log"
    done
    echo
    echo "== $SECONDS s in all; failed: ${failed[*]:-nothing}"
    for name in "$@"; do
        [ "$name" = tests ] || printf '%s: ' "$name"
        closing_line "$name"
    done
    [ ${#failed[@]} -eq 0 ]
}

# debian PROGRAM PACKAGE...: installs packages of the system where the program is missing and that is allowed.
debian() {
    local program=$1
    shift
    command -v "$program" >/dev/null && return
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null || return
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends -y "$@" >/dev/null
}

# Instructions are counted by valgrind, a package of the system.
counted_instructions() {
    debian valgrind valgrind
    if ! command -v valgrind >/dev/null; then
        echo "skipped: there is no valgrind here and none could be installed. On Debian: apt-get install valgrind"
        return 0
    fi
    .venv/bin/python tests/benchmarks/instructions.py
}

# The linters of .pre-commit-config.yaml, over the files named, or over all.
lint() {
    (. tools/environment.sh && pip_install $(requirements project optional-dependencies lint)) &&
        .venv/bin/pre-commit run --show-diff-on-failure "$@"
}

# tidy PATTERN: clang-tidy over the engine's files whose path the pattern finds.
tidy() {
    local commands
    commands=$(ls -t build/cp3*/compile_commands.json | head -n 1)
    mkdir -p build/ci/tidy # without what GCC alone knows
    sed -E 's/ -mmem(cpy|set)-strategy=[^ ]+//g' "$commands" >build/ci/tidy/compile_commands.json
    .venv/bin/run-clang-tidy.py -quiet -j "$(nproc)" -clang-tidy-binary .venv/bin/clang-tidy -p build/ci/tidy \
        -extra-arg=-Wno-unknown-warning-option -extra-arg=-Wno-deprecated-declarations "$1"
}

# clang-tidy over the engine's files that the file `changed` beside the logs lists, and over those beside its headers.
tidy_changed() {
    local sources
    mapfile -t sources < <(sed -nE 's/\.hpp$/.cpp/; /^cpp\/(cncsub|controls)\/.*\.cpp$/p' "$logs/changed" | sort -u)
    echo "${#sources[@]} files of the engine changed"
    [ ${#sources[@]} -eq 0 ] || tidy "($(IFS='|' && echo "${sources[*]//./\\.}"))$"
}

# The package under the sanitizers in .venv-sanitize, and the program that makes programs beside it.
sanitized_build() {
    env VENV=.venv-sanitize CXX=g++ CNCSUB_WERROR=OFF CNCSUB_SANITIZE=address,undefined \
        CMAKE_ARGS="-DCNCSUB_PROGRAMS=ON -DCNCSUB_PRECOMPILE=ON" \
        SKBUILD_BUILD_DIR=build/sanitize SKBUILD_CMAKE_BUILD_TYPE=RelWithDebInfo \
        sh -c '. tools/environment.sh; install ".[test]"'
}

# Python with the module under the sanitizers, whose run-time libraries come first in every process, and before the C++
# library whose exceptions they watch.
sanitized_python() {
    local preload
    preload="$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libstdc++.so)"
    env LD_PRELOAD="$preload" ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 HYPOTHESIS_PROFILE=ci \
        .venv-sanitize/bin/python "$@"
}

sanitized_tests() {
    sanitized_python -m pytest -p no:cacheprovider --numprocesses auto --dist worksteal "$@"
}

# The C++ library from the same build, its examples and every function of the C face; leaks are found too, as no Python is there.
sanitized_library() {
    CNCSUB_SANITIZED=$PWD/build/sanitize .venv/bin/python -m pytest -p no:cacheprovider -q tests/test_library_sanitized.py
}

# Whole programs made from the seed for so many seconds, and held to the laws, under the sanitizers.
made_programs() {
    sanitized_python cpp/fuzz/seeds.py build/sanitize/seeds &&
        build/sanitize/cpp/fuzz/fuzz_programs --seed "$SEED" --count 1000000000 --seconds "$1" build/sanitize/seeds/run
}

export -f debian counted_instructions lint tidy tidy_changed sanitized_build sanitized_python sanitized_tests sanitized_library made_programs
