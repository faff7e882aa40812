#!/bin/sh
# Fuzzes the engine: builds the targets under the sanitizers, writes the seeds, and runs each target for so many seconds
# (60 without an argument): sh tools/fuzz.sh 3600. What it learned stays in build/fuzz/corpus for the next time, and an input
# that broke the engine in build/fuzz/found; `build/fuzz/cpp/fuzz/fuzz_run FILE` runs one again. Inputs and whole programs are
# made from the number SEED, today's date where it is not set.
# Needs Clang with libFuzzer; exit status 77 where there is none.
set -eu
cd "$(dirname "$0")/.."
. tools/environment.sh

has_fuzzer() {
    command -v "$1" >/dev/null &&
        echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
        "$1" -fsanitize=fuzzer,address -x c++ - -o /dev/null 2>/dev/null
}

find_clang() {
    for compiler in clang++ clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15; do
        has_fuzzer "$compiler" && echo "$compiler" && return
    done
    echo "There is no Clang with libFuzzer here. On Debian: apt-get install clang-16 libclang-rt-16-dev" >&2
    return 77
}

seconds=${1:-60}
seed=${SEED:-$(date +%Y%m%d)}
clang=$(find_clang) || exit $?
install .
PATH=$PWD/$VENV/bin:$PATH
cmake --preset fuzz -DCMAKE_CXX_COMPILER="$clang"
cmake --build --preset fuzz

build=build/fuzz
mkdir -p $build/found $build/corpus/read $build/corpus/run
"$VENV/bin/python" cpp/fuzz/seeds.py $build/seeds
failed=0
for target in read run; do
    echo "== fuzzing: $target, $seconds s"
    $build/cpp/fuzz/fuzz_$target -seed="$seed" -max_total_time="$seconds" -max_len=4096 -timeout=25 -rss_limit_mb=2560 \
        -dict=$build/seeds/nc.dict -artifact_prefix=$build/found/$target- -print_final_stats=1 -verbosity=1 \
        $build/corpus/$target $build/seeds/$target >$build/$target.log 2>&1 || failed=1
    grep -E 'ERROR|SUMMARY|not so:|runtime error|Test unit written|^stat::' $build/$target.log || true
done
echo "== whole programs, $seconds s"
timeout $((seconds + 120)) $build/cpp/fuzz/fuzz_programs --seed "$seed" --count 1000000000 --seconds "$seconds" \
    $build/seeds/run >$build/programs.log 2>&1 || failed=1
tail -n 60 $build/programs.log
exit $failed
