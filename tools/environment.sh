# Sourced by the scripts beside it: `install WHAT` makes the environment $VENV where there is none, and installs WHAT.
# Needs Python 3.11 or newer with its headers and a C++ compiler; everything else comes from the package index.

VENV=${VENV:-.venv}
PYTHON=${PYTHON:-python3}

stop() {
    echo "$*" >&2
    exit 1
}

check_machine() {
    command -v "$PYTHON" >/dev/null || stop "There is no $PYTHON here. On Debian: apt-get install python3 python3-venv python3-dev"
    "$PYTHON" -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "cncsub needs Python 3.11 or newer; $PYTHON is $("$PYTHON" -V 2>&1). Name another one with PYTHON=..."
    "$PYTHON" -c '
import pathlib, sys, sysconfig
sys.exit(not pathlib.Path(sysconfig.get_path("include"), "Python.h").exists())' ||
        stop "The headers of $PYTHON are missing. On Debian: apt-get install python3-dev"
    [ -z "${CXX:-}" ] || return 0
    for compiler in c++ g++ clang++; do
        CXX=$(command -v "$compiler") && export CXX && return
    done
    stop "There is no C++ compiler here. On Debian: apt-get install g++"
}

# Debian keeps what `python3 -m venv` needs in a package of its own; without it the machine's pip fills the environment.
make_environment() {
    if "$PYTHON" -c 'import ensurepip' 2>/dev/null; then
        "$PYTHON" -m venv --clear "$VENV"
    elif "$PYTHON" -m pip --version >/dev/null 2>&1; then
        "$PYTHON" -m venv --clear --without-pip "$VENV"
        "$PYTHON" -m pip --python "$VENV/bin/python" install --quiet pip
    else
        stop "$PYTHON can make no environment. On Debian: apt-get install python3-venv"
    fi
}

# requirements KEY...: the requirements listed at that place of pyproject.toml.
requirements() {
    "$VENV/bin/python" -c '
import functools, pathlib, sys, tomllib
project = tomllib.loads(pathlib.Path("pyproject.toml").read_text(encoding="utf-8"))
print(*functools.reduce(dict.__getitem__, sys.argv[1:], project))' "$@"
}

# The build tools stay in the environment, so that a second install compiles only what changed.
install() {
    check_machine
    "$VENV/bin/python" -m pip --version >/dev/null 2>&1 || make_environment
    echo "Building and installing $1 into $VENV (a few minutes the first time)"
    pip_install $(requirements build-system requires) cmake ninja
    pip_install --no-build-isolation "$1"
}

pip_install() {
    "$VENV/bin/python" -m pip install --quiet --disable-pip-version-check "$@"
}
