#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tests/style/tidy.sh BUILD_FOLDER
#
# clang-tidy has nothing to say of the sources. It reads each library as one file, for deal.II is much to read. Headers that
# gcc has compiled are left out: clang does not know their form.
set -eu
build=$(CDPATH='' cd -- "$1" && pwd)
cd -- "$(dirname -- "$0")/../.."
if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: .clang-tidy is for clang-tidy 14"
  exit 77
fi
cmake -S . -B "$build/tidy" -G Ninja -DCMAKE_UNITY_BUILD=ON -DORTHOCONE_PRECOMPILED_HEADERS=OFF -DORTHOCONE_TESTS=OFF >/dev/null 2>&1
cmake --build "$build/tidy" --target orthocone_base_revision >/dev/null
sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$build/tidy/compile_commands.json" | sort -u |
  xargs -n 1 -P "$(nproc)" clang-tidy -quiet -p "$build/tidy" 2>/dev/null
