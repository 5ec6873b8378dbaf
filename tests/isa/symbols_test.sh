#!/usr/bin/env bash
# Every weak symbol of a kernel object lies in the namespace of its instruction set: else the linker keeps one build of a
# shared inline function, and an old processor meets AVX-512.
# usage: symbols_test.sh INSTRUCTION_SET OBJECT...
set -euo pipefail
isa=$1
shift
symbols=$(nm -C "$@")
if ! grep -q "isocast::$isa::" <<<"$symbols"; then
  echo "no symbol of isocast::$isa in $*"
  exit 1
fi
if foreign=$(grep -E ' [WVu] ' <<<"$symbols" | grep -v "isocast::$isa::"); then
  echo "weak symbols outside isocast::$isa: $foreign"
  exit 1
fi
