#!/usr/bin/env bash
# An installation is a usable package: the example builds and runs against it, with CMake and with pkg-config, and each component
# brings what it needs.
# usage: install_test.sh SOURCE_FOLDER BUILD_FOLDER [pictures]     (environment: CXX, CMAKE_GENERATOR, CMAKE_BUILD_TYPE)
set -euo pipefail
source=$1 build=$2 pictures=${3-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/moved/isocast
failures=0

fail() {
  echo "$*"
  failures=$((failures + 1))
}

# Runs a command; shows what it printed only when it fails.
quietly() {
  "$@" >"$folder/log" 2>&1 && return
  cat "$folder/log"
  fail "failed: $*"
}

# run_example PROGRAM: what it prints, and that it takes its module from the installation
run_example() {
  local said expected="5300 of 76800 rays hit, depth at the centre 122.578 (a perfect ball: 122.571)"
  said=$("$1" 2>&1) || fail "$1: exit code $?"
  [[ $said == "$expected" ]] || fail "$1 says '$said', expected '$expected'"
  [[ $pictures ]] || return 0
  LD_DEBUG=files LD_DEBUG_OUTPUT=$1.log "$1" "$1.png" >/dev/null || fail "$1 draws no picture"
  grep -q "calling init: $prefix/.*/isocast_image.so" "$1".log.* || fail "$1 does not open the installed module"
}

# installed in one place, used in another
quietly cmake --install "$build" --prefix "$folder/isocast"
mkdir "$folder/moved"
mv "$folder/isocast" "$prefix"
export CMAKE_PREFIX_PATH=$prefix
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name isocast.pc)")
export PKG_CONFIG_PATH

example=$source/docs/examples/render_from_memory
quietly cmake -S "$example" -B "$folder/example"
quietly cmake --build "$folder/example"
run_example "$folder/example/render_from_memory"

read -ra options <<<"$(pkg-config --cflags --libs isocast)"
quietly "$CXX" "$example/main.cpp" "${options[@]}" -o "$folder/by_pkg_config"
run_example "$folder/by_pkg_config"

quietly cmake -S "$source/tests/install/components" -B "$folder/components"

"$prefix/bin/isocast" --help >/dev/null || fail "the installed program does not run"
for header in $(cd "$source" && find src volume implicit data_gen apps/scene_build -name '*.h'); do
  [[ -f $prefix/include/isocast/${header#src/} ]] || fail "$header is not installed"
done
grep -rIP "(?<![\w.}-])(\Q$source\E|\Q$build\E|\Q$folder\E)(?!\w)" "$prefix" && fail "installed files name folders of this build"

((failures == 0)) && echo "the installation is usable"
exit $((failures > 0))
