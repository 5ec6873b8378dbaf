#!/usr/bin/env bash
# Every example scene follows the published schema and renders at 64x64, to the same bytes with Embree and without.
# usage: scenes_test.sh ISOCAST SCENES SCHEMA
set -euo pipefail
isocast=$(realpath "$1") scenes=$(realpath "$2") schema=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$scenes"/* "$folder"
cd "$folder"
./make_volumes.sh "$isocast" . >/dev/null

if ! diff <("$isocast" schema) "$schema"; then
  echo "the published schema is not what 'isocast schema' prints"
  exit 1
fi
count=0
for scene in "$scenes"/*.json; do
  scene=$(basename "$scene")
  frame=()
  if grep -q '"animation"' "$scene"; then frame=(--frames 5:5); fi
  rm -f with.png without.png
  ISOCAST_EMBREE=1 "$isocast" render "$scene" --size 64x64 "${frame[@]}" -o with.png --stats stats.txt
  ISOCAST_EMBREE=0 "$isocast" render "$scene" --size 64x64 "${frame[@]}" -o without.png
  if ! cmp with.png without.png; then
    echo "$scene: other bytes without Embree"
    exit 1
  fi
  hits=$(grep -o '"hits": [0-9]*' stats.txt | grep -o '[0-9]*')
  if ((hits < 300)); then
    echo "$scene: only $hits rays hit"
    exit 1
  fi
  count=$((count + 1))
done
if ((count < 12)); then
  echo "only $count scenes"
  exit 1
fi
if python3 -c "import jsonschema" 2>/dev/null; then
  python3 - "$schema" "$scenes"/*.json <<'PYTHON'
import json, re, sys
import jsonschema
validator = jsonschema.Draft202012Validator(json.load(open(sys.argv[1])))
for name in sys.argv[2:]:
    scene = json.loads(re.sub(r"(?m)^\s*//.*$", "", open(name).read()))
    validator.validate(scene)
    scene["objects"][0]["colour"] = 1
    assert not validator.is_valid(scene), name
PYTHON
fi
echo "$count scenes"
