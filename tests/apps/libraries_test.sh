#!/usr/bin/env bash
# What a run does not need is not loaded: the libraries of each run, as the dynamic loader reports them.
# usage: libraries_test.sh PROGRAM
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

# Runs the program and sets `loaded` to the libraries of that run, one a line.
run() {
  words="isocast $*"
  rm -f "$folder"/log.*
  LD_DEBUG=files LD_DEBUG_OUTPUT=$folder/log "$program" "$@" >/dev/null
  loaded=$(sed -n 's/.*file=\([^ ]*\) .*generating link map.*/\1/p' "$folder"/log.*)
}

expect_loaded() {
  grep -q "$1" <<<"$loaded" && return
  echo "'$words' does not load $1, but only: $loaded"
  failures=$((failures + 1))
}

expect_not_loaded() {
  local name
  for name in "$@"; do
    ! grep "$name" <<<"$loaded" && continue
    echo "'$words' loads $name"
    failures=$((failures + 1))
  done
}

heavy=(isocast_ OpenImageIO OpenEXR nifti openvdb embree flint mpfr Qt libGL)
run --help
expect_loaded libstdc++
expect_not_loaded "${heavy[@]}"
run sample 'x^2+y^2+z^2-1' --domain -2,2 --resolution 16 --type f32 -o "$folder/ball.raw"
expect_not_loaded "${heavy[@]}"
run info "$folder/ball.raw" --dims 16,16,16 --type f32
expect_not_loaded "${heavy[@]}"
run render "$folder/ball.raw" --dims 16,16,16 --type f32 --iso 0 --size 16x16 -o "$folder/ball.png"
expect_loaded isocast_image
expect_loaded OpenImageIO
expect_not_loaded isocast_nifti nifti embree flint
if [[ -e $(dirname "$program")/../lib/isocast/isocast_embree.so ]]; then
  ball='{"type": "formula", "expr": "x^2+y^2+z^2-1"}'
  echo '{"isocast": 1, "objects": ['"$ball"']}' >"$folder/one.json"
  echo '{"isocast": 1, "objects": ['"$ball, $ball"']}' >"$folder/two.json"
  run render "$folder/one.json" --size 16x16 -o "$folder/one.png"
  expect_not_loaded isocast_nifti embree
  run render "$folder/two.json" --size 16x16 -o "$folder/two.png"
  expect_loaded isocast_embree
fi
run probe 'x^2+y^2+z^2-1' --pixel 8,8 --size 16x16
expect_loaded isocast_reference
expect_loaded flint
expect_not_loaded OpenImageIO nifti embree
run probe "$folder/ball.raw" --dims 16,16,16 --type f32 --iso 0 --pixel 8,8 --size 16x16
expect_not_loaded "${heavy[@]}"

((failures == 0)) && echo "each run loaded what it needed"
exit $((failures > 0))
