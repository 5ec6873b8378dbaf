#!/usr/bin/env bash
# The viewer's window under an X server in memory, driven by the server's own mouse and keyboard events.
# usage: viewer_script_test.sh PROGRAM
. "$(dirname "$0")/program_test.sh"
# A server for each window. (xvfb-run sometimes fails at its end when the program was short: the server, left by its
# last window, starts again and signals the script while that tidies up.)
view() {
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp -noreset 3>number >/dev/null 2>&1 &
  server=$!
  local number
  read -r -t 60 number <number || fail "Xvfb has not started"
  DISPLAY=:$number timeout 120 "$program" view "$@" >out.txt 2>err.txt
  local status=$?
  kill "$server" && wait "$server"
  return "$status"
}
trap 'kill ${server:-} 2>/dev/null; rm -rf "$folder"' EXIT
mkfifo number
# number KEY.KEY: from stats.json
number() { python3 -c 'import json, sys, functools
print(functools.reduce(lambda part, key: part[key], sys.argv[1].split("."), json.load(open("stats.json"))))' "$1"; }
# pixels PNG: its width and height
pixels() { od -An -j16 -N8 --endian=big -tu4 "$1" | xargs; }

# without a display: one sentence and exit code 2
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$program" view "x^2+y^2-0.5" >out.txt 2>err.txt || status=$?
((status == 2)) && grep -q "isocast render" err.txt && (($(wc -l <err.txt) == 1)) ||
  fail "without a display: exit code $status, $(cat err.txt)"

# skip WHY: the rest needs what this machine lacks
skip() {
  ((failures)) && exit 1
  echo "skipped: $*"
  exit 0
}
command -v Xvfb >/dev/null || skip "there is no Xvfb"
echo quit >quit.txt
view x --script quit.txt || skip "no OpenGL 3.3 under Xvfb: $(cat err.txt)"

MESA_GL_VERSION_OVERRIDE=2.1 view x --script quit.txt
status=$?
((status == 2)) && grep -q "OpenGL 3.3" err.txt || fail "with OpenGL 2.1: exit code $status, $(cat err.txt)"
printf 'wait\nis 3\n' >bad.txt
view x --script bad.txt
status=$?
((status == 2)) && grep -q "bad.txt:2" err.txt || fail "a bad script: exit code $status, $(cat err.txt)"
view nothing.nrrd --script quit.txt
status=$?
((status == 2)) && grep -q "nothing.nrrd" err.txt || fail "a missing file: exit code $status, $(cat err.txt)"

# a volume: its slider, its camera, its methods, and pictures that are those of render
"$program" sample "x^2+y^2+z^2+0.2*sin(9*x)" --resolution 64 --type f32 -o ball.nrrd >/dev/null
cat >volume.txt <<'S'
wait
iso 0.75
wait
save iso.png
orbit 60 30
pan -20 10
zoom 2
method certified
wait
overlay certificate
wait
screenshot certificate.png
overlay none
click 190 227
wait
screenshot probe.png
save moved.png
quit
S
view ball.nrrd --iso 0.5 --window 720x480 --scale 1 --script volume.txt --stats stats.json || fail "volume: $(cat err.txt)"
size=380x454
"$program" render ball.nrrd --iso 0.75 --size $size -o expected.png
same iso.png expected.png "the picture after the slider"
cmp -s moved.png expected.png && fail "orbit, pan and zoom have moved nothing"
cmp -s certificate.png probe.png && fail "the overlay shows nothing"
(($(number scenes) == 1)) || fail "the slider or the camera has built the scene again"
(($(number tiles.after_cancel) <= $(number threads))) || fail "a newer wish waited for more than a tile of each thread"
(($(number pictures.preview) + $(number pictures.final) >= 30)) || fail "the picture does not follow the mouse"
# now and then a software OpenGL compiles a shader in the window's thread
(($(number interface.over_16_ms) <= 2)) || fail "$(number interface.over_16_ms) frames of the window took over 16 ms"

# a formula: typed, with a parameter, and at a time
cat >formula.txt <<'S'
wait
formula "x^2+y^2+z^2-0.4-0.2*sin(9*x+w)"
time 0.25
wait
save typed.png
formula "x^2+y^2-"
wait
screenshot error.png
quit
S
view "a*x^2+y^2+z^2-0.5" --param a=2 --time 0.5 --window 720x480 --scale 1 --script formula.txt --stats stats.json || fail "formula: $(cat err.txt)"
"$program" render "x^2+y^2+z^2-0.4-0.2*sin(9*x+w)" --time 0.25 --size $size -o expected.png
same typed.png expected.png "the picture of a formula that was typed"
cat >parameter.txt <<'S'
wait
param a 3
wait
save parameter.png
quit
S
view "a*x^2+y^2+z^2-0.5" --param a=2 --size 300x200 --window 720x480 --scale 1 --script parameter.txt || fail "parameter: $(cat err.txt)"
"$program" render "a*x^2+y^2+z^2-0.5" --param a=3 --size 300x200 -o expected.png
same parameter.png expected.png "the picture of a changed parameter"

# a scene of several objects: each is edited, and what the command line cannot say is in the file that is copied
cat >three.json <<'S'
{"isocast": 1, "objects": [
  {"name": "ball", "type": "volume", "file": "ball.nrrd", "iso": 0.5},
  {"name": "rod", "type": "formula", "expr": "x^2+y^2-0.01"},
  {"name": "sheet", "type": "formula", "expr": "z", "material": {"color": "#9dbf7a"}}]}
S
cat >scene.txt <<'S'
wait
screenshot before.png
object rod
type iso.value 0.05
object sheet
press objects.eye2
object ball
iso 0.75
method certified
wait
type color.of "x+y"
type color.range "-1,1"
wait
save edited.png
press output.copy
clipboard copied.txt
screenshot scene.png
quit
S
view three.json --window 720x480 --scale 1 --script scene.txt --stats stats.json || fail "scene: $(cat err.txt)"
grep -qx "isocast render edited.scene.json --size $size -o edited.png" copied.txt || fail "copied: $(cat copied.txt)"
"$program" render edited.scene.json --size $size -o expected.png || fail "the copied scene"
same edited.png expected.png "the picture of an edited scene"
grep -q '"visible": false' edited.scene.json || fail "the hidden object is not in the file"
(($(number scenes) == 4)) || fail "a scene was built $(number scenes) times, expected 4: at first, hidden, coloured, in another range"

# an animation: its frames are those of render, cut by a plane that is the scene's, and it plays
cat >moving.json <<'S'
{"isocast": 1, "objects": [
  {"name": "ball", "type": "formula", "expr": "x^2+y^2+z^2-r", "params": {"r": 0.2}},
  {"type": "instance", "of": "ball", "transforms": [{"translate": [1, 0, 0]}]}],
 "animation": {"frames": [2, 12], "keys": [{"frame": 2, "params": {"ball.r": 0.2}}, {"frame": 12, "params": {"ball.r": 0.4}}]}}
S
cat >frames.txt <<'S'
wait
frame 7
press clip.add
wait
save frame.png
press output.copy
clipboard copied.txt
press frame.play
screenshot playing.png
quit
S
view moving.json --window 720x480 --scale 1 --script frames.txt --stats stats.json || fail "animation: $(cat err.txt)"
grep -qx "isocast render frame.scene.json --frames 7:7 --size $size -o frame.png" copied.txt || fail "copied: $(cat copied.txt)"
"$program" render frame.scene.json --frames 7:7 --size $size -o expected.png || fail "the copied frame"
same frame.png expected.png "the picture of a frame"

# another program's file is dropped, what is copied can be pasted elsewhere, and the whole screen is filled
cat >drop.txt <<'S'
wait
drop ball.nrrd
wait
press output.copy
clipboard copied.txt
save dropped.png
key F11
wait
screenshot full.png
key F11
wait
screenshot window.png
quit
S
view x --window 720x480 --scale 1 --script drop.txt || fail "drop: $(cat err.txt)"
"$program" render ball.nrrd --size $size -o expected.png
same dropped.png expected.png "the picture of a dropped file"
grep -qx "isocast render .*/ball.nrrd --size $size -o picture.png" copied.txt || fail "copied: $(cat copied.txt)"
[[ $(pixels full.png) == "1600 1000" ]] || fail "full screen: $(pixels full.png)"
[[ $(pixels window.png) == "720 480" ]] || fail "back in the window: $(pixels window.png)"

# volumes with numbers are frames, what is cut is not left out, and Escape closes a list
cp ball.nrrd ball_2.nrrd
"$program" sample "x^2+y^2+z^2-0.3" --resolution 16 --type f32 -o ball_7.nrrd >/dev/null
cat >numbers.txt <<'S'
wait
frame 7
wait
save number.png
press clip.add
press iso.suggestions
key Escape
method certified
wait
quit
S
view "ball_%d.nrrd" --iso 0.1 --window 720x480 --scale 1 --script numbers.txt --stats stats.json || fail "numbers: $(cat err.txt)"
"$program" render "ball_%d.nrrd" --iso 0.1 --frames 7:7 --size $size -o expected.png
same number.png expected.png "the picture of a numbered volume"
[[ $(number features) == *"clip solids"* && $(number left_out) != *"clip solids"* ]] || fail "what cuts is left out"

end_of_test "the window does what it is told"
