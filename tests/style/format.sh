#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# Every source is as clang-format writes it. Each version writes a little differently: Debian 12's decides.
set -eu
cd -- "$(dirname -- "$0")/../.."
if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: .clang-format is for clang-format 14"
  exit 77
fi
find source include tests tools examples -name '*.cc' -o -name '*.h' | xargs clang-format --dry-run -Werror
