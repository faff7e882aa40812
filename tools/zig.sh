# Sourced by the scripts beside it: `zig TARGET` writes and names a C++ compiler for that target, such as
# x86_64-linux-gnu.2.17, and makes build/zig/ar. Zig comes from the package index (pip install ziglang) into build/zig/env,
# unless ZIG names a Python that has it; where there is none it fails.

zig() {
    python=${ZIG:-build/zig/env/bin/python}
    if [ ! -x "$python" ] && [ -z "${ZIG:-}" ]; then
        python3 -m venv build/zig/env >&2 && build/zig/env/bin/python -m pip install --quiet ziglang >&2 || return 1
    fi
    zig=$("$python" -c 'import pathlib, ziglang; print(pathlib.Path(ziglang.__file__).parent / "zig")' 2>/dev/null) || return 1
    mkdir -p build/zig
    # Zig hands a precompiled header to its linker, which knows none: the compiler inside is asked by itself.
    cat >"build/zig/c++-$1" <<END
#!/bin/sh
zig=$zig
case " \$* " in
*" -emit-pch "*) eval "\$("\$zig" c++ -target $1 '-###' "\$@" 2>&1 | grep -e '"-cc1"')" ;;
*) exec "\$zig" c++ -target $1 "\$@" ;;
esac
END
    printf '#!/bin/sh\nexec "%s" ar "$@"\n' "$zig" >build/zig/ar
    chmod +x "build/zig/c++-$1" build/zig/ar
    echo "$PWD/build/zig/c++-$1"
}
