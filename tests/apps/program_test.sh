# The beginning of scripts that test the program, to be sourced with their arguments: PROGRAM. They go on in a folder
# of their own, which is gone at the end, count failures, and end with end_of_test.
set -uo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail() {
  echo "$*"
  failures=$((failures + 1))
}
# same A B [WHAT]: the same bytes
same() { cmp -s "$1" "$2" || fail "${3:+$3: }$1 and $2 differ"; }
# end_of_test WHAT: says so if nothing has failed
end_of_test() {
  ((failures == 0)) && echo "$1"
  exit $((failures > 0))
}
