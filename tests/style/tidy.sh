#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tests/style/tidy.sh BUILD_FOLDER
#
# clang-tidy has nothing to say of the sources. It reads each library as a few files, for deal.II is much to read. Headers that
# gcc has compiled are left out: clang does not know their form. A file of which it had nothing to say is not read again until
# it, a header, the compiler's options or the rules are others: BUILD_FOLDER/tidy/clean has a name for each such state.
set -eu
build=$(CDPATH='' cd -- "$1" && pwd)
cd -- "$(dirname -- "$0")/../.."
if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: .clang-tidy is for clang-tidy 14"
  exit 77
fi
cmake -S . -B "$build/tidy" -G Ninja -DCMAKE_UNITY_BUILD=ON -DORTHOCONE_PRECOMPILED_HEADERS=OFF -DORTHOCONE_TESTS=OFF >/dev/null 2>&1
cmake --build "$build/tidy" --target orthocone_base_revision >/dev/null
mkdir -p "$build/tidy/clean"
common=$({ find . \( -path ./build -o -path ./output \) -prune -o -name '*.h' -print; echo .clang-tidy; } | sort | xargs cat |
  cat - /var/lib/dpkg/status | sha256sum | cut -c -64)
export build common

# One file of the compiler: its options and what it includes, beside what all have in common.
sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$build/tidy/compile_commands.json" | sort -u | xargs -n 1 -P "$(nproc)" sh -c '
  sources=$(sed -n "s/^#include \"\(.*\)\"/\1/p" "$1")
  state=$({ echo "$common"; grep -F -B 1 -- "\"$1\"" "$build/tidy/compile_commands.json"; cat "$1" $sources; } | sha256sum | cut -c -64)
  [ ! -e "$build/tidy/clean/$state" ] || exit 0
  clang-tidy -quiet -p "$build/tidy" "$1" 2>/dev/null && : >"$build/tidy/clean/$state"' tidy
