#!/usr/bin/env bash
# --isa cuda: with this processor in a device's place the pictures of --isa scalar; without a device one clear sentence;
# with one, its pictures of what basic arithmetic makes are the same too.
# usage: cuda_test.sh PROGRAM
. "$(dirname "$0")/program_test.sh"
export XDG_CACHE_HOME=$PWD/cache

# expect CODE TEXT ARGUMENTS...
expect() {
  local code=$1 text=$2
  shift 2
  "$program" "$@" >out.txt 2>err.txt
  local found=$?
  ((found == code)) || fail "$*: code $found: $(cat err.txt)"
  [[ -z $text ]] || grep -q -e "$text" out.txt err.txt || fail "$*: $(cat err.txt)"
}
# picture NAME ARGUMENTS...: rays one by one, as a device has them, or beams
picture() {
  local name=$1
  shift
  "$program" render "$@" --size 70x50 --isa scalar -o "$name-scalar.exr" || fail "render $name"
  "$program" render "$@" --size 70x50 --isa cuda -o "$name-cuda.exr" || fail "render $name --isa cuda"
  same "$name-scalar.exr" "$name-cuda.exr" "$name"
}
pictures() {
  picture volume tangle.nrrd --iso 0 --aov depth,normal
  picture several gyroid.nrrd --iso 0.3,0,-0.3 --opacity 0.5 --shadows
  picture precise tangle.nrrd --iso 0 --precision double --method certified
  picture formula @tangle --method interval --set beams=0 --set prune=0 --aov depth,certificate
  picture affine @tangle --method affine --set beams=0 --set prune=0 --shadows
  picture marching @tangle --method amp-taylor --set prune=0
  picture beams @tangle --method beam-adaptive --aov depth,certificate
  picture slanted @tangle --method beam-uniform --set form=affine --set depth=1 --aov depth,certificate
}

"$program" sample @tangle --resolution 40 --type f32 -o tangle.nrrd || fail "sample"
"$program" sample gyroid --resolution 33 --type u8 -o gyroid.nrrd || fail "sample"
if "$program" render tangle.nrrd --size 16x16 --isa cuda -o device.png 2>err.txt; then
  device="on a device and "
  pictures
else
  (($? == 2)) || fail "a missing device is not told with code 2"
  grep -q -e "NVIDIA GPU" -e "no CUDA device" err.txt || fail "no device: $(cat err.txt)"
  (($(wc -l <err.txt) == 1)) || fail "a missing device is told in more than a line"
fi
export ISOCAST_CUDA_ENGINE=host
pictures
expect 2 "solves them one by one" render @tangle --method interval --set bisection=k --isa cuda -o a.png
expect 2 "expected an INPUT" bench cells --isa cuda -o bench
expect 0 "" bench @tangle --isa cuda --quick --size 24x16 --method interval,affine --cache none -o bench
grep -q ",cuda," bench/results.csv || fail "no row of the device's kernels"
grep -q ",cuda-wall," bench/results.csv || fail "no row of whole calls"
expect 0 "" render tangle.nrrd --size 16x16 --isa cuda -o a.png --stats a.json
grep -q '"isa": *"cuda"' a.json || fail "--stats does not tell the device"
end_of_test "--isa cuda: the same pictures ${device-}in a device's place"
