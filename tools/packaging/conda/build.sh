#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# Called by conda build, which sets PREFIX, PYTHON and CMAKE_ARGS. The targets are those of tools/setup.sh.
set -eu
# shellcheck disable=SC2086
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release $CMAKE_ARGS -DCMAKE_INSTALL_PREFIX="$PREFIX" -DORTHOCONE_TESTS=OFF \
  -DORTHOCONE_PYTHON="$PYTHON"
cmake --build build --target orthocone orthocone_python orthocone_solve
for component in program python; do
  cmake --install build --component $component
done
