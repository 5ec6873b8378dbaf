#!/usr/bin/env bash
# Layers of EXR files, as other programs read them.
# usage: exr_test.sh PROGRAM
. "$(dirname "$0")/program_test.sh"
layers=depth,z,normal,position,id,object,value,albedo,cost,certificate
options=("x^2+y^2+z^2-1" --domain -2,2 --size 32x24 --method certified --colors '#ff0000' --aov $layers)
"$program" render "${options[@]}" -o plain.exr || fail "render"
"$program" render "${options[@]}" --threads 1 --isa scalar -o again.exr || fail "render again"
"$program" render "${options[@]}" --exr-names compositor -o compositor.exr || fail "render for compositors"
cmp -s plain.exr again.exr || fail "other bytes with other threads and instruction set"
"$program" compare plain.exr compositor.exr >out.txt || fail "compare: the names matter: $(cat out.txt)"
for layer in depth z normal color position value albedo id object certificate cost; do
  grep -q "^$layer " out.txt || fail "compare does not tell of $layer"
done

# names LIST FILE PROGRAM: a program lists all channels and what the file says of itself
plain="R G B A depth z normal.X normal.Y normal.Z position.X position.Y position.Z id object value albedo.R albedo.G albedo.B cost certificate"
compositor="R G B A depth.Z Z N.X N.Y N.Z P.X P.Y P.Z id.X object.X value.X albedo.R albedo.G albedo.B cost.X certificate.X"
names() {
  local found
  found=$("$3" "${@:4}" "$2") || fail "$3 cannot read $2"
  for name in $1; do
    grep -qE "(^|[ ,\"])$name([ ,\",]|$)" <<<"$found" || fail "$3 finds no channel $name in $2"
  done
  for note in isocast:version isocast:scene isocast:method; do
    grep -q "$note" <<<"$found" || fail "$3 finds no $note in $2"
  done
  grep -qiE "$(hostname)|threads|avx" <<<"$found" && fail "$3 finds the machine in $2"
}
tools=0
for tool in oiiotool exrheader; do
  if ! command -v $tool >/dev/null; then
    echo "not installed, not asked: $tool"
    continue
  fi
  tools=$((tools + 1))
  [[ $tool == oiiotool ]] && arguments=(--info -v) || arguments=()
  names "$plain" plain.exr $tool "${arguments[@]}"
  names "$compositor" compositor.exr $tool "${arguments[@]}"
done
((tools > 0)) || echo "skipped: neither oiiotool nor exrheader is installed"

if command -v oiiotool >/dev/null; then
  # the middle of the picture: the first object's sphere in red, proved
  oiiotool compositor.exr --ch albedo.R,albedo.G,object.X,id.X,certificate.X --cut 1x1+16+12 -o middle.exr
  pixel=$(oiiotool --stats middle.exr | grep 'Stats Avg')
  [[ $pixel == *"1.000000 0.000000 1.000000 1.000000 1.000000"* ]] || fail "the middle pixel: $pixel"
fi
end_of_test "others read the layers"
