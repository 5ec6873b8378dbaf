#!/usr/bin/env bash
# The viewer's window under an X server in memory, driven by the server's own mouse and keyboard events.
# usage: viewer_script_test.sh PROGRAM
set -uo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail() {
  echo "$*"
  failures=$((failures + 1))
}
view() { timeout 120 xvfb-run -a -s "-screen 0 1600x1000x24" "$program" view "$@" >out.txt 2>err.txt; }
# number KEY.KEY: from stats.json
number() { python3 -c 'import json, sys, functools
print(functools.reduce(lambda part, key: part[key], sys.argv[1].split("."), json.load(open("stats.json"))))' "$1"; }
same() { cmp -s "$1" "$2" || fail "$3: $1 and $2 differ"; }

# without a display: one sentence and exit code 2
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$program" view "x^2+y^2-0.5" >out.txt 2>err.txt || status=$?
((status == 2)) && grep -q "isocast render" err.txt && (($(wc -l <err.txt) == 1)) ||
  fail "without a display: exit code $status, $(cat err.txt)"

if ! command -v xvfb-run >/dev/null || ! command -v xauth >/dev/null; then
  ((failures)) && exit 1
  echo "skipped: there is no xvfb-run"
  exit 0
fi
echo quit >quit.txt
if ! view x --script quit.txt; then
  ((failures)) && exit 1
  echo "skipped: no OpenGL 3.3 under Xvfb: $(cat err.txt)"
  exit 0
fi

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
click 280 280
wait
screenshot probe.png
save moved.png
quit
S
view ball.nrrd --iso 0.5 --window 900x600 --scale 1 --script volume.txt --stats stats.json || fail "volume: $(cat err.txt)"
size=560x574
"$program" render ball.nrrd --iso 0.75 --size $size -o expected.png
same iso.png expected.png "the picture after the slider"
cmp -s moved.png expected.png && fail "orbit, pan and zoom have moved nothing"
cmp -s certificate.png probe.png && fail "the overlay shows nothing"
(($(number scenes) == 1)) || fail "the slider or the camera has built the scene again"
(($(number tiles.after_cancel) <= $(number threads))) || fail "a newer wish waited for more than a tile of each thread"
(($(number pictures.preview) + $(number pictures.final) >= 30)) || fail "the picture does not follow the mouse"

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
view "a*x^2+y^2+z^2-0.5" --param a=2 --time 0.5 --window 900x600 --scale 1 --script formula.txt --stats stats.json || fail "formula: $(cat err.txt)"
"$program" render "x^2+y^2+z^2-0.4-0.2*sin(9*x+w)" --time 0.25 --size $size -o expected.png
same typed.png expected.png "the picture of a formula that was typed"
cat >parameter.txt <<'S'
wait
param a 3
wait
save parameter.png
quit
S
view "a*x^2+y^2+z^2-0.5" --param a=2 --size 300x200 --window 900x600 --scale 1 --script parameter.txt || fail "parameter: $(cat err.txt)"
"$program" render "a*x^2+y^2+z^2-0.5" --param a=3 --size 300x200 -o expected.png
same parameter.png expected.png "the picture of a changed parameter"

((failures == 0)) && echo "the window does what it is told"
exit $((failures > 0))
