#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tests/style/tidy.sh BUILD_FOLDER [all]
#
# clang-tidy has nothing to say of base and of the law of one node, which it reads within a minute. With `all` of
# everything, which takes an hour: Eigen and deal.II are much to read.
set -eu
build=$(CDPATH='' cd -- "$1" && pwd)
cd -- "$(dirname -- "$0")/../.."
if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: .clang-tidy is for clang-tidy 14"
  exit 77
fi
# The compiler's words for each file, not for groups of them.
cmake -S . -B "$build/tidy" -G Ninja -DCMAKE_UNITY_BUILD=OFF -DORTHOCONE_TESTS=OFF >/dev/null 2>&1
cmake --build "$build/tidy" --target orthocone_base_revision >/dev/null
folders="source/base source/contact/law"
[ "${2-}" != all ] || folders=source
# shellcheck disable=SC2086
find $folders -name '*.cc' | xargs -n 3 clang-tidy -quiet -p "$build/tidy" 2>/dev/null
