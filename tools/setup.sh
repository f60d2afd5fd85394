#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tools/setup.sh PRESET [benchmark] [study] [problems] [peers] [package] [tests]
#   tools/setup.sh docs
#
# Installs what is missing, configures and builds with a CMake preset (release, debug, fuzz); `benchmark` adds the kernels
# that tools/study benchmark times, `study` the small experiments of tools/study, `problems` orthocone-solve and the entry
# Output/Problems, `peers` those and the programs of tools/study peers, as far as this Debian has them, `package` what makes and
# checks a Debian package, `tests` all but the programs of tools/study peers, and the tests. `docs` alone installs what makes the
# site of these pages, and builds nothing. Called by ./run, ./test and the tools. Nothing is done twice: installed packages,
# a configured build folder and compiled files are left alone.
set -eu

# mold is the linker that the flags of Debian 13's deal.II ask for; libdeal.ii-dev only recommends it.
packages="g++ cmake ninja-build git mold
  libdeal.ii-dev libsuitesparse-dev libmetis-dev libeigen3-dev libopenblas-pthread-dev liblapacke-dev libfftw3-dev libhmat-oss-dev zlib1g-dev
  libboost-program-options-dev nlohmann-json3-dev libgtest-dev pybind11-dev python3-dev python3-numpy python3-matplotlib
  python3-meshio"
benchmark_packages="libbenchmark-dev"
problems_packages="libfclib-dev"
package_packages="$problems_packages dpkg-dev lintian patchelf openmpi-bin"
docs_packages="python3 python3-sphinx python3-myst-parser furo python3-breathe doxygen"
# ParaView's Python brings the vtk modules, and takes the place of the package python3-vtk9 where that is installed.
tests_packages="$benchmark_packages $package_packages $docs_packages paraview python3-paraview xvfb xauth chromium
  chromium-driver python3-selenium python3-hypothesis python3-pandas python3-nbclient python3-nbformat
  python3-ipykernel clang-format clang-tidy"
fuzz_packages="clang libclang-rt-dev"
peers_packages="calculix-ccx python3-getfem libsiconos-numerics-dev" # not every Debian has them all

say() { echo "setup: $*" >&2; }

missing_of() {
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s ' "$package"
  done
}

# What is optional is named and left out where there is no such package.
available_of() {
  for package in "$@"; do
    if LC_ALL=C apt-cache policy "$package" | grep -q 'Candidate: [0-9]'; then
      printf '%s ' "$package"
    else
      say "there is no package $package here: it is left out"
    fi
  done
}

install_packages() {
  # shellcheck disable=SC2086
  missing=$(missing_of $packages) wanted=$(missing_of $optional)
  [ -n "$missing$wanted" ] || return 0
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
      say "please install as root: apt-get install $missing$wanted"
      [ -n "$missing" ] || return 0
      exit 1
    fi
    as_root=sudo
  fi
  say "asking for packages; if another apt is running, this waits for it for up to ten minutes"
  $as_root apt-get update -q -o DPkg::Lock::Timeout=600 >&2 || [ -z "$missing" ]
  # shellcheck disable=SC2086
  missing=$missing$(available_of $wanted)
  [ -n "$missing" ] || return 0
  say "installing $missing"
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y -o DPkg::Lock::Timeout=600 --no-install-recommends $missing >&2
}

preset=$1
shift
targets="orthocone orthocone_python"
kernels=OFF
[ "$preset" != docs ] || packages='' targets=''
optional=
for group in "$preset" "$@"; do
  case $group in
    benchmark) packages="$packages $benchmark_packages" targets="$targets kernels" kernels=ON ;;
    study) targets="$targets studies" ;;
    problems) packages="$packages $problems_packages" targets="$targets orthocone_solve" ;;
    package) packages="$packages $package_packages" targets="$targets orthocone_solve" ;;
    peers) packages="$packages $problems_packages" optional=$peers_packages targets="$targets orthocone_solve" ;;
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
  say $packages $optional
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
  *" problems "* | *" peers "* | *" package "* | *" tests "*)
    ! grep -q '^FCLIB_LIBRARY:.*NOTFOUND' "$build/CMakeCache.txt" || cmake "$build" >&2
    ;;
esac
say "building $build (the first time takes some minutes)"
# shellcheck disable=SC2086
cmake --build "$build" --target $targets >&2
