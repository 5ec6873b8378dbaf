#!/usr/bin/env bash
# Builds and runs one fuzzer. usage: fuzz.sh TARGET SECONDS SEEDS [BUILD]
# TARGET  nrrd nhdr metaimage nifti vti nvdb vdb_header openvdb
# SEEDS   whole files of all formats, as the test hostile_files makes them (tests/hostile/corpus/whole in a build)
# BUILD   of the preset `fuzz`; what was found and learnt lies in BUILD/found and BUILD/learnt
set -euo pipefail
target=$1 seconds=$2 seeds=$(realpath "$3") build=${4-build-fuzz}
cd "$(dirname "$0")/../.."
command -v clang++ >/dev/null || { echo "skipped: clang is not installed"; exit; }

[[ -f $build/build.ninja ]] || cmake --preset fuzz -B "$build" >/dev/null
cmake --build "$build" --target "fuzz_$target" | tail -n 1

case $target in
  metaimage) extensions=(mha mhd) ;;
  nifti) extensions=(nii nii.gz) ;;
  vdb_header | openvdb) extensions=(vdb) ;;
  *) extensions=("$target") ;;
esac
learnt=$build/learnt/$target
mkdir -p "$learnt" "$build/found"
for extension in "${extensions[@]}"; do
  cp -n "$seeds"/*."$extension" "$learnt/" 2>/dev/null || true
done

options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=3000 -print_final_stats=1
  -artifact_prefix="$build/found/$target-")
fuzzer=$build/tests/fuzz/bin/fuzz_$target
if [[ $target != openvdb ]]; then
  exec "$fuzzer" "${options[@]}" "$learnt"
fi
# A fault counts only where it is in our own code: the first or second frame of its stack.
"$fuzzer" "${options[@]}" -fork=1 -ignore_crashes=1 -ignore_ooms=1 -ignore_timeouts=1 -detect_leaks=0 "$learnt" \
  >"$build/found/openvdb.log" 2>&1 || true
tail -n 1 "$build/found/openvdb.log"
! grep -E '^ *#[01] 0x[0-9a-f]+ in isocast::' "$build/found/openvdb.log"
