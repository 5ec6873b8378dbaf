#!/usr/bin/env bash
# What features cost that a scene names but does not use: instructions of a picture against those of the same picture
# without them, counted by valgrind. Ends with 1 if one of them costs more than a hundredth.
# usage: count_instructions.sh ISOCAST [SIZE]
set -euo pipefail
isocast=$(realpath "${1:?usage: count_instructions.sh ISOCAST [SIZE]}")
size=${2:-256x256}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# scene NAME MORE KEYS: a formula with more in its object, and more keys in the scene
scene() {
  echo '{"isocast": 1, "objects": [{"name": "a", "type": "surface", "id": "barth_sextic", "method": "affine"'"$2"'}]'"$3"'}' >"$1.json"
}
# instructions SIZE ARGUMENT...
instructions() {
  valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null "$isocast" render "${@:2}" \
    --size "$1" --isa avx2 --threads 1 -o picture.png 2>&1 | awk '/I *refs:/ {gsub(",", "", $NF); print $NF}'
}

worst=0
# compare FEATURE BASE ARGUMENT...: prints the share of what the picture takes beyond the program's start
compare() {
  local count
  count=$(instructions "$size" "${@:3}")
  awk -v feature="$1" -v base="$2" -v start="$start" -v count="$count" 'BEGIN {
    share = 100 * (count - base) / (base - start)
    printf "%-28s %14d  %+.3f %%\n", feature, count, share
    exit share > 1 }' || worst=1
}

start=$(instructions 1x1 @barth_sextic --method affine)
printf "%-28s %14d\n" "the start of the program" "$start"
base=$(instructions "$size" @barth_sextic --method affine)
printf "%-28s %14d\n" "the picture alone" "$base"
scene plain "" ""
compare "a scene file" "$base" plain.json
compare "--transparency-depth" "$base" @barth_sextic --method affine --transparency-depth 32
compare "--reflections" "$base" @barth_sextic --method affine --reflections 8
compare "--opacity 1" "$base" @barth_sextic --method affine --opacity 1 --reflectivity 0
compare "--shadows, no light" "$base" @barth_sextic --method affine --shadows
compare "--ambient-occlusion 0" "$base" @barth_sextic --method affine --ambient-occlusion 0

base=$(instructions "$size" plain.json)
scene one ', "transform": {"scale": 1, "rotate": [0, 0, 1, 0], "translate": [0, 0, 0]}' ''
compare "transform: identity" "$base" one.json
scene one ', "clip": []' ''
compare "clip: nothing" "$base" one.json
scene one ', "material": {"color": "#d9b38c", "opacity": 1, "reflectivity": 0, "specular": 0.12}' ''
compare "material: the default" "$base" one.json
scene one "" ', "animation": {"frames": [0, 0], "keys": []}'
compare "animation: no keys" "$base" one.json
scene one "" ', "cameras": {"a": {}, "b": {"fov": 30}}'
compare "cameras: another one" "$base" one.json
scene one "" ', "lights": [], "background": [1, 1, 1], "time": 0, "spp": 1'
compare "lights: none" "$base" one.json
exit "$worst"
