#!/usr/bin/env bash
# Jobs of many frames: killed at any moment and resumed they are those of an undisturbed run, byte by byte.
# usage: batch_test.sh PROGRAM
. "$(dirname "$0")/program_test.sh"
RANDOM=${SEED:-1}

# there N: what --resume says of the frames that it found
there() { grep -q "^$1 of " err.txt || fail "$2: expected $1 frames to be there, found '$(tail -1 err.txt)'"; }

"$program" sample @tangle --resolution 48 --type f32 -o tangle.nrrd >/dev/null || exit 1
options=(tangle.nrrd --iso-sweep -1:3:24 --size 160x120 --spp 4 --shadows --light 1,-1,2)
mkdir whole killed
"$program" render "${options[@]}" -o whole/f_%04d.png || fail "the undisturbed run"
[[ $(ls whole/f_*.png | wc -l) == 24 && -s whole/f_manifest.json ]] || fail "not all frames, or no manifest"

# SIGKILL at random moments
for ((round = 0; round < 8; ++round)); do
  "$program" render "${options[@]}" --resume -o killed/f_%04d.png 2>/dev/null &
  child=$!
  sleep "0.$((RANDOM % 9))$((RANDOM % 10))"
  kill -9 "$child" 2>/dev/null
  wait "$child" 2>/dev/null
  for file in killed/f_*.png; do [[ ! -e $file ]] || same "$file" "whole/${file#*/}"; done
done
"$program" render "${options[@]}" --resume -o killed/f_%04d.png 2>err.txt || fail "the resumed run"
for file in whole/f_*.png; do same "$file" "killed/${file#*/}"; done
"$program" render "${options[@]}" --resume -o killed/f_%04d.png 2>err.txt
there 24 "after a whole run"

# what is not whole, or not from the same inputs and options, is rendered again
cp killed/f_0003.png kept.png
head -c 500 kept.png >killed/f_0003.png
printf 'x' | dd of=killed/f_0007.png bs=1 seek=300 conv=notrunc status=none
rm killed/f_0011.png
"$program" render "${options[@]}" --resume -o killed/f_%04d.png 2>err.txt
there 21 "three damaged files"
for file in whole/f_*.png; do same "$file" "killed/${file#*/}"; done
"$program" render "${options[@]}" --threads 1 --isa scalar --resume -o killed/f_%04d.png 2>err.txt
there 24 "other threads and instruction set"
"$program" render "${options[@]}" --reflections 2 --resume -o killed/f_%04d.png 2>err.txt
there 0 "another option"
printf '\1' | dd of=tangle.nrrd bs=1 seek=100000 conv=notrunc status=none
"$program" render "${options[@]}" --reflections 2 --resume -o killed/f_%04d.png 2>err.txt
there 0 "another input"
"$program" render "${options[@]}" --reflections 2 --frames 5:9 --resume -o killed/f_%04d.png 2>err.txt
there 5 "some of the frames"

# shards make up the whole, and know each other's frames
"$program" render "${options[@]}" -o whole/f_%04d.png || fail "a second undisturbed run"
mkdir shards
for shard in 1 2 3; do
  "$program" render "${options[@]}" --shard $shard/3 -o shards/f_%04d.png || fail "shard $shard"
  [[ $(ls shards/f_*.png | wc -l) == $((8 * shard)) ]] || fail "shard $shard has not 8 frames"
done
for file in whole/f_*.png; do same "$file" "shards/${file#*/}"; done
"$program" render "${options[@]}" --resume -o shards/f_%04d.png 2>err.txt
there 24 "all shards"

# time over frames, and the frames of a scene file
"$program" render "x^2+y^2+z^2-1-w" --domain -2,2 --time 0:1 --frames 0:4 --size 40x40 -o time_%d.png || fail "--time FROM:TO"
for frame in 0 2 4; do
  "$program" render "x^2+y^2+z^2-1-w" --domain -2,2 --time "$(awk "BEGIN { print $frame / 4 }")" --size 40x40 -o one.png
  same one.png "time_$frame.png"
done
cat >scene.json <<'JSON'
{ "isocast": 1, "size": [40, 30], "cameras": {"a": {"position": [4, -8, 3]}, "b": {"position": [8, -4, 3]}},
  "objects": [{"name": "ball", "type": "formula", "expr": "x^2+y^2+z^2-a", "params": {"a": 1}, "domain": [[-2, 2], [-2, 2], [-2, 2]]}],
  "animation": {"frames": [0, 5], "keys": [{"frame": 0, "params": {"ball.a": 1}, "camera": "a"}, {"frame": 5, "params": {"ball.a": 2}, "camera": "b"}]} }
JSON
"$program" render scene.json -o scene_%02d.png || fail "the frames of a scene"
[[ $(ls scene_*.png | wc -l) == 6 ]] || fail "the scene has not 6 frames"
cmp -s scene_00.png scene_05.png && fail "nothing moves in the scene"
sed -i 's/"ball.a": 2/"ball.a": 3/' scene.json
"$program" render scene.json --resume -o scene_%02d.png 2>err.txt
there 0 "another scene text"

# mistakes
refuse() {
  local words=$1
  shift
  "$program" render "$@" -o bad.png >out.txt 2>err.txt
  local code=$?
  ((code == 2)) && grep -qF -- "$words" err.txt || fail "render $*: exit code $code, '$(cat err.txt)', expected '$words'"
}
refuse "nothing changes from frame to frame" "x" --frames 0:3
refuse "expected FIRST:LAST" "x" --time 0:1 --frames 3:1
refuse "to say how many frames" "x" --time 0:1
refuse "has the frames 0 to 3" "x" --iso-sweep 0:1:4 --frames 2:5
refuse "I from 1 to N" "x" --iso-sweep 0:1:4 --shard 0/3
refuse "I from 1 to N" "x" --iso-sweep 0:1:4 --shard 4/3

refuse "expected --spp above 1" "x" --filter gaussian
end_of_test "jobs are whole"
