#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tools/setup.sh PRESET [benchmark] [study] [problems] [package] [tests]
#   tools/setup.sh docs
#
# Installs what is missing, configures and builds with a CMake preset (release, debug, fuzz); `benchmark` adds the kernels
# that tools/benchmark times, `study` the small experiments of tools/study, `problems` orthocone-solve and the entry
# Output/Problems, `package` what makes and checks a Debian package, `tests` all of these and the tests. `docs` alone
# installs what makes the site of these pages, and builds nothing. Called by ./run, ./test and the tools. Nothing is done
# twice: installed packages, a configured build folder and compiled files are left alone.
set -eu

# mold is the linker that the flags of Debian 13's deal.II ask for; libdeal.ii-dev only recommends it.
packages="g++ cmake ninja-build git mold
  libdeal.ii-dev libsuitesparse-dev libmetis-dev libeigen3-dev libopenblas-pthread-dev liblapacke-dev zlib1g-dev
  libboost-program-options-dev nlohmann-json3-dev libgtest-dev pybind11-dev python3-dev python3-numpy python3-matplotlib
  python3-meshio"
benchmark_packages="libbenchmark-dev"
problems_packages="libfclib-dev"
package_packages="$problems_packages dpkg-dev lintian"
docs_packages="python3 python3-sphinx python3-myst-parser furo python3-breathe doxygen"
# ParaView's Python brings the vtk modules, and takes the place of the package python3-vtk9 where that is installed.
tests_packages="$benchmark_packages $package_packages $docs_packages paraview python3-paraview xvfb xauth chromium
  chromium-driver python3-selenium python3-hypothesis clang-format clang-tidy"
fuzz_packages="clang libclang-rt-dev"

say() { echo "setup: $*" >&2; }

missing_packages() {
  for package in $packages; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s ' "$package"
  done
}

install_packages() {
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 || { say "please install as root: apt-get install $missing"; exit 1; }
    as_root=sudo
  fi
  say "installing $missing"
  $as_root apt-get update -q -o DPkg::Lock::Timeout=600 >&2
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y -o DPkg::Lock::Timeout=600 --no-install-recommends $missing >&2
}

preset=$1
shift
targets="orthocone orthocone_python"
kernels=OFF
[ "$preset" != docs ] || packages='' targets=''
for group in "$preset" "$@"; do
  case $group in
    benchmark) packages="$packages $benchmark_packages" targets="$targets kernels" kernels=ON ;;
    study) targets="$targets studies" ;;
    problems) packages="$packages $problems_packages" targets="$targets orthocone_solve" ;;
    package) packages="$packages $package_packages" targets="$targets orthocone_solve" ;;
    tests) packages="$packages $tests_packages" targets=all kernels=ON ;;
    fuzz) packages="$packages $fuzz_packages" targets=all ;;
    docs) packages="$packages $docs_packages" ;;
  esac
done
[ "$preset" != debug ] || targets=unit_tests kernels=OFF # the only ones that this preset runs
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$root"

if command -v apt-get >/dev/null 2>&1; then
  install_packages
else
  say "no apt-get here; these Debian packages, or what corresponds to them, must be installed:"
  # shellcheck disable=SC2086
  say $packages
fi
[ -n "$targets" ] || exit 0

build=build
[ "$preset" = release ] || build=build/$preset
if [ ! -f "$build/build.ninja" ] || [ CMakePresets.json -nt "$build/build.ninja" ]; then
  say "configuring $build"
  cmake --preset "$preset" >&2
fi
# Once asked for, the kernels stay part of the build folder.
if [ $kernels = ON ] && ! grep -q '^ORTHOCONE_BENCHMARKS:BOOL=ON' "$build/CMakeCache.txt"; then
  cmake -DORTHOCONE_BENCHMARKS=ON "$build" >&2
fi
# What was missing when the folder was configured is looked for again.
case " $* " in
  *" problems "* | *" package "* | *" tests "*) ! grep -q '^FCLIB_LIBRARY:.*NOTFOUND' "$build/CMakeCache.txt" || cmake "$build" >&2 ;;
esac
say "building $build (the first time takes some minutes)"
# shellcheck disable=SC2086
cmake --build "$build" --target $targets >&2
