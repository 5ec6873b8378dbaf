#!/usr/bin/env bash
# The program as a user meets it: exit codes, one sentence for every mistake, the same bytes always, no half files.
# usage: command_line_test.sh PROGRAM
. "$(dirname "$0")/program_test.sh"

# expect CODE WORDS ARGUMENT...: the exit code, and words that the one sentence on stderr must hold
expect() {
  local code=$1 sentence=$2 status=0
  shift 2
  "$program" "$@" >out.txt 2>err.txt || status=$?
  ((status == code)) || fail "isocast $*: exit code $status, expected $code: $(head -c 300 err.txt)"
  [[ -z $sentence ]] || grep -qF -- "$sentence" err.txt out.txt || fail "isocast $*: says '$(head -c 300 err.txt)', expected '$sentence'"
}

expect 0 "wrote" sample @tangle --resolution 40 --type f32 -o tangle.nrrd
expect 0 "wrote" sample gyroid --resolution 33 --type u8 -o gyroid_33x33x33_uint8.raw
expect 0 "wrote" sample gyroid --resolution 33 --type i16 -o gyroid.mha
expect 0 "wrote" sample gyroid --resolution 33 --type f64 -o gyroid.nii
expect 0 "wrote" sample @tangle --resolution 40 --type f32 -o tangle.vdb
expect 0 "wrote" sample @tangle --resolution 40 --type f32 -o tangle.nvdb
expect 0 "wrote" sample "sqrt(x^2+y^2+z^2)-0.5" --resolution 40 --band 0.1 -o ball.vdb
expect 0 "level set" info ball.vdb
expect 0 '"active_samples": 64000' info tangle.nvdb --json
expect 0 "'tangle'" info tangle.vdb --grid tangle
expect 0 '"suggested_iso"' info tangle.nrrd --json
expect 0 "metaimage" info gyroid.mha
expect 0 '"default"' methods --json
expect 0 '"barth_sextic"' surfaces --json
expect 0 "" surfaces -o sheet.png --size 16
[[ $(head -c 24 sheet.png | tail -c 8 | od -An -tx1 | tr -d ' ') == 0000009000000090 ]] || fail "surfaces -o: the sheet has not 9 x 9 tiles of 16 pixels"
expect 0 "" surfaces -o again.png --size 16 --method amp-sign --set iterations=2 --precision double --time 1
cmp -s sheet.png again.png && fail "surfaces -o: the same sheet with another method at another time"
expect 0 '"left_out"' render tangle.nrrd --iso 0 --size 64x48 -o tangle.png --stats -
expect 0 "" render gyroid_33x33x33_uint8.raw --size 64x48 --iso 100,140 --colors '#ff0000,#00ff00' --ortho 40 -o gyroid.png
expect 0 '"transparency:4"' render tangle.nrrd --iso 0,3 --opacity 0.4,0.8 --size 64x48 -o clear.png --stats -
expect 0 '"components"' render "max(x^2+y^2+z^2-1, 0.3-x^2-y^2)" --domain -1.2,1.2 --color-components --normals difference --size 64x48 -o bead.png --stats -
expect 0 '"reflections:1"' render tangle.nrrd --iso 0 --reflectivity 0.5 --environment clear.png --size 64x48 -o mirror.png --stats -
expect 0 '"lights:3"' render tangle.nrrd --iso 0 --light 1,0,0 --light -1,0,0 --light 0,0,1 --size 64x48 -o lights.png --stats -
expect 0 '"verdict": "right"' probe tangle.nrrd --iso 0 --pixel 32,24 --size 64x48 --json
expect 0 "proved hit" probe "x^2+y^2+z^2-1" --domain -2,2 --pixel 32,24 --size 64x48
expect 0 "" render tangle.nrrd --iso 0 --size 64x48 --aov depth,normal -o one.exr
expect 0 "" render tangle.nrrd --iso 0 --size 64x48 --aov depth,normal --method midpoint -o other.exr
expect 0 "within the tolerance 0" compare one.exr one.exr
expect 3 "BEYOND the tolerance 0.001" compare one.exr other.exr --tolerance 0.001 -o difference.png
expect 3 '"within": false' compare one.exr other.exr --json
expect 0 "" render tangle.nrrd --size 32x32 -o small.exr
[[ -s difference.png ]] || fail "compare -o: no picture of the differences"

# bench: a formula and a volume from end to end; the report refers to nothing outside itself
for input in "x^2+y^2+z^2-0.5" tangle.nrrd; do
  expect 0 "is right at all rays" bench "$input" --iso 0 --quick --size 20x16 --isa auto --cache none -o bench
  for file in results.csv results.json report.html; do [[ -s bench/$file ]] || fail "bench $input: no $file"; done
  [[ $(head -1 bench/results.csv) == suite,case,method,*,pareto,undecided_reference ]] || fail "bench $input: other columns"
  [[ $(grep -c ',320,' bench/results.csv) -ge 16 ]] || fail "bench $input: too few rows of 20 x 16 rays"
  grep -qE '(src|href)="(http|/)|<script|<link|@import|url\(' bench/report.html && fail "bench $input: the report refers to something outside"
  grep -q 'data:image/png;base64,' bench/report.html || fail "bench $input: a report without pictures"
done

# mistakes
expect 2 "is no verb" paint
expect 2 "there is no such file" render missing.raw -o a.png
expect 2 "missing.nrrd" render missing.nrrd -o a.png
expect 2 "folder" info .
expect 2 ".png or .exr" render tangle.nrrd -o a.jpg
expect 2 "the folder nowhere does not exist" render tangle.nrrd -o nowhere/a.png
expect 2 "the folder nowhere does not exist" render tangle.nrrd -o a.png --stats nowhere/a.json
expect 2 "one of .nrrd .raw .nii .mha .vdb .nvdb" sample gyroid -o a.vol
expect 2 "the nearest is f32" sample gyroid --type f16 -o a.mha
expect 2 "the nearest is i32" sample gyroid --type u8 -o a.vdb
expect 2 "only .vdb and .nvdb" sample gyroid --band 1 -o a.nrrd
expect 2 "no grid 'density', only 'tangle' ('float')" render tangle.vdb --grid density -o a.png
expect 2 "no grid 'density', only 'tangle' (float)" render tangle.nvdb --grid density -o a.png
expect 2 "need an .exr file" render tangle.nrrd -o a.png --aov depth
expect 2 "the method marmitt proves nothing" render tangle.nrrd -o a.exr --aov certificate
cat >scene.json <<'SCENE'
// two objects, two cameras
{ "isocast": 1, "size": [32, 24], "cameras": {"a": {}, "b": {"position": [0, -9, 0]}},
  "objects": [{"name": "v", "type": "volume", "file": "tangle.nrrd", "iso": 0, "transform": {"translate": [5, 0, 0]}},
              {"name": "f", "type": "formula", "expr": "x^2+y^2+z^2-0.5+w"}],
  "animation": {"frames": [1, 2], "keys": [{"frame": 0, "time": 0}, {"frame": 2, "time": 0.4}]} }
SCENE
cat >one.json <<'SCENE'
{ "isocast": 1, "objects": [{"type": "formula", "expr": "x^2+y^2+z^2-0.5", "transform": {"scale": 2}}] }
SCENE
expect 0 '"objects": [' render scene.json -o scene.png --stats -
expect 0 '"objects": [' render scene.json -o scene.png --stats - --camera b --size 16x16
expect 0 "module:embree" render one.json -o one.png --stats - --size 16x16 --method certified --iso 0.1 --colors "#ff0000"
expect 0 "right" probe scene.json --pixel 16,12
expect 0 "right" probe one.json --pixel 512,512
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >corner.obj
expect 0 '"triangles:4"' render corner.obj -o corner.png --size 32x32 --stats -
expect 2 "found options of volumes or formulas for the mesh corner.obj" render corner.obj -o a.png --iso 3
sed 's/f 1 3 2/f 1 3 9/' corner.obj >bad.obj
expect 2 "bad.obj:5: found the vertex 9, expected one of the 4 so far" render bad.obj -o a.png
expect 2 "no camera has the name 'c', expected one of: a, b" render scene.json -o a.png --camera c
expect 2 "found --method for scene.json, a scene of several objects: expected the key 'method'" render scene.json -o a.png --method affine
expect 2 "found --param for scene.json, a scene: expected the key 'params'" render scene.json -o a.png --param a=1
expect 2 "No such file" render none.json -o a.png

expect 2 "midpoint, linear, neubauer, schwarze, marmitt" render tangle.nrrd -o a.png --method newton
expect 2 "no option 'eps'" render tangle.nrrd -o a.png --set eps=1
expect 2 "WIDTHxHEIGHT" render tangle.nrrd -o a.png --size 0x0
expect 2 "formula:1:5" render "x^2+" -o a.png
expect 2 "parameter" render @sphere --param none=1 -o a.png
expect 2 "expected them for a formula" render tangle.nrrd --time 1 -o a.png
expect 2 "interval, affine" render "x^2-1" --method marmitt -o a.png
expect 2 "--opacity: found 1.5, expected numbers from 0 to 1" render tangle.nrrd --opacity 0.5,1.5 -o a.png
expect 2 "found --color-components for a volume, expected it for a formula" render tangle.nrrd --color-components -o a.png
expect 2 "--reflectivity: found 'much'" render tangle.nrrd --reflectivity much -o a.png
expect 2 "not in range 1 to 64" render tangle.nrrd --transparency-depth 0 -o a.png
expect 2 "not in range 0 to 16" render tangle.nrrd --reflections 17 -o a.png
expect 2 "expected a direction" render tangle.nrrd --light 0,0,0 -o a.png
expect 2 "found 9 lights, expected at most 8" render tangle.nrrd --light={1,2,3,4,5,6,7,8,9},0,0 -o a.png
expect 2 "sky.exr: No such file" render tangle.nrrd --environment sky.exr -o a.png
expect 2 "ends with .exr, .hdr, .png or .jpg" render tangle.nrrd --environment tangle.nrrd -o a.png
expect 2 "expected X,Y from 0,0 (the upper left pixel) to 63,47" probe tangle.nrrd --pixel 64,0 --size 64x48
expect 2 "found --set without --method" probe tangle.nrrd --pixel 0,0 --set iterations=2
expect 2 "midpoint, linear, neubauer, schwarze, marmitt" probe tangle.nrrd --pixel 0,0 --method newton
expect 2 "the same size was expected" compare one.exr small.exr
expect 2 "is not an OpenEXR file" compare one.exr tangle.nrrd
expect 2 "missing.exr: No such file" compare one.exr missing.exr
expect 2 "expected a number of at least 0" compare one.exr one.exr --tolerance -1
expect 2 "ends with .png" compare one.exr one.exr -o a.exr
expect 2 "is no suite" bench everything -o bench
expect 2 "found --iso with a suite, expected it with an INPUT" bench volumes --iso 1 -o bench
expect 2 "interval, affine" bench @tangle --method marmitt -o bench --cache none
expect 2 "at most 1048576" bench @tangle --size 2048x2048 -o bench
expect 2 "found --set without --method" bench @tangle --set eps-rel=0.1 -o bench
expect 2 "found --precision or --method with the suite cells" bench cells --method marmitt -o bench
expect 2 "found --precision or --method with the suite papers" bench papers --precision float -o bench
expect 2 "found --data, expected it with the suites papers and all only" bench volumes --data . -o bench
expect 2 "found --isa with the suite papers" bench papers --isa scalar -o bench
expect 2 "found no folder 'nowhere'" bench papers --data nowhere -o bench
expect 2 "a name that ends with .png" surfaces -o a.exr
expect 2 "the folder nowhere does not exist" surfaces -o nowhere/a.png
expect 2 "interval, affine" surfaces -o a.png --method marmitt
expect 2 "no option 'trim'" surfaces -o a.png --method interval --set trim=1
expect 2 "not in range 16 to 1024" surfaces -o a.png --size 0
expect 2 "--time" surfaces -o a.png --time soon
expect 2 "requires -o" surfaces --size 32
expect 2 "excludes" surfaces --json -o a.png
[[ -e a.png || -e a.exr ]] && fail "a failed run left a picture"

# formulas: the same picture for every number of threads and instruction set
expect 0 '"undecided"' render @tangle --size 64x48 --aov certificate,depth -o tangle_formula.exr --stats -
expect 0 "" render "-x^2-y^2/2-z^2+a" --param a=0.5 --iso 0,0.25 --size 64x48 --isa scalar --threads 1 -o formula.png
for isa in sse4 avx2 avx512; do
  "$program" render "-x^2-y^2/2-z^2+a" --param a=0.5 --iso 0,0.25 --size 64x48 --isa "$isa" --threads 2 -o again.png 2>err.txt || { grep -q "lacks it" err.txt && continue; }
  cmp -s formula.png again.png || fail "another picture of a formula with $isa"
done

# dense or sparse, the same picture
view=(--iso 0 --size 70x50 --camera-position 4,-6,3 --camera-target 0,0,0 --light 1,-1,2 --shadows)
for file in tangle.nrrd tangle.vdb tangle.nvdb; do
  "$program" render "$file" "${view[@]}" -o "$file.png" || fail "no picture of $file"
  cmp -s tangle.nrrd.png "$file.png" || fail "$file differs from tangle.nrrd"
done

# the same bytes for 1, 2 and 7 threads and every instruction set
picture=(render tangle.nrrd --iso 0,2 --size 70x50 --light 1,-1,2 --shadows --spp 2 --aov depth,z,normal,position,id,value,cost)
"$program" "${picture[@]}" --isa scalar --threads 1 -o expected.exr || fail "no picture"
"$program" render tangle.nrrd --size 70x50 --isa scalar --threads 1 -o expected.png || fail "no picture"
for isa in sse4 avx2 avx512; do
  "$program" "${picture[@]}" --isa "$isa" -o a.exr 2>err.txt || { grep -q "lacks it" err.txt && continue; }
  cmp expected.exr a.exr || fail "another picture with $isa"
done
for threads in 2 7; do
  "$program" "${picture[@]}" --threads "$threads" -o a.exr && cmp expected.exr a.exr || fail "another picture with $threads threads"
  "$program" render tangle.nrrd --size 70x50 --threads "$threads" -o a.png && cmp expected.png a.png || fail "another picture with $threads threads"
done

# and so with transparency, reflections, several lights and an environment, of a formula
picture=(render @tangle --iso 0,2 --size 70x50 --light 1,-1,2 --light -1,0,1 --shadows --opacity 0.4,0.7 --reflectivity 0.3 --reflections 2 --environment clear.png)
"$program" "${picture[@]}" --isa scalar --threads 1 -o expected.exr || fail "no picture"
for isa in sse4 avx2 avx512; do
  "$program" "${picture[@]}" --isa "$isa" --threads 7 -o a.exr 2>err.txt || { grep -q "lacks it" err.txt && continue; }
  cmp expected.exr a.exr || fail "another picture with $isa"
done

# Ctrl-C: exit code 130, nothing half written, what was there stays
rm -f a.png && echo old >kept.png
set -m
"$program" render tangle.nrrd --iso 0 --size 4096x4096 --spp 64 -o kept.png 2>err.txt &
sleep 1
kill -INT $!
wait $!
((status = $?)) || true
((status == 130)) || fail "Ctrl-C: exit code $status, expected 130"
[[ $(cat kept.png) == old ]] || fail "Ctrl-C: the old picture is gone"
"$program" surfaces -o kept.png --size 1024 2>err.txt &
sleep 1
kill -INT $!
wait $!
((status = $?)) || true
((status == 130)) || fail "Ctrl-C: exit code $status of surfaces, expected 130"
[[ $(cat kept.png) == old ]] || fail "Ctrl-C: the old picture is gone"
compgen -G ".*part*" >/dev/null && fail "Ctrl-C: a half file is left"

end_of_test "every run did what was expected"
