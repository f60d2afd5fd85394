#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   tests/style/tidy.sh BUILD_FOLDER [--record]
#
# clang-tidy has nothing to say of the sources. It reads each library as one file, for deal.II is much to read: a minute for each
# library that uses it. A library is therefore read again only where it has changed, or the headers of ours that it may see, the
# compiler's definitions or the rules: tests/style/tidy_clean.txt has the names of states of which clang-tidy had nothing to say,
# and BUILD_FOLDER/tidy/clean has those that this folder has seen. --record writes the present states into the former; whoever
# changes sources does this before a commit. Headers that gcc has compiled are left out: clang does not know their form. Names of
# two files that lie in one only here may shadow each other; gcc looks for shadows in each.
set -eu
build=$(CDPATH='' cd -- "$1" && pwd)
cd -- "$(dirname -- "$0")/../.."
record=tests/style/tidy_clean.txt
if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "skipped: .clang-tidy is for clang-tidy 14"
  exit 77
fi
cmake -S . -B "$build/tidy" -G Ninja -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -DORTHOCONE_PRECOMPILED_HEADERS=OFF -DORTHOCONE_TESTS=OFF >/dev/null 2>&1
cmake --build "$build/tidy" --target orthocone_base_revision >/dev/null
mkdir -p "$build/tidy/clean"
root=$(pwd)
commands=$build/tidy/compile_commands.json
export build root record commands

# The state of a file of the compiler: the rules, its definitions, the sources that it stands for with the headers beside them,
# and the public headers of the libraries that its include path shows.
state_of() {
  command=$(grep -F -B 1 -- "\"file\": \"$1\"" "$commands" | head -n 1)
  sources=$({ sed -n 's/^#include "\(.*\)"/\1/p' "$1"; case $1 in "$root"/*) [ "${1#"$build"}" != "$1" ] || echo "$1" ;; esac; } |
    sed "s|^$root/||" | sort)
  beside=$(for source in $sources; do echo "${source%%/*}/$(echo "$source" | cut -d / -f 2)"; done | sort -u)
  seen=$(echo "$command" | grep -o "tidy/views/[a-z]*" | sed 's|tidy/views|include/orthocone|' | sort -u)
  {
    cat .clang-tidy
    echo "$command" | grep -oE -e '-D[^ ]*|-std=[^ ]*' | grep -v VERSION | sort -u
    # shellcheck disable=SC2086
    { printf '%s\n' $sources; find $beside $seen -name '*.h'; } | sort -u | while read -r file; do echo "$file" && cat "$file"; done
  } | sha256sum | cut -c -40
}

if [ "${2-}" = --record ]; then
  sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$commands" | sort -u | while read -r file; do
    state=$(state_of "$file")
    [ ! -e "$build/tidy/clean/$state" ] && ! grep -qx "$state" "$record" || echo "$state"
  done | sort >"$build/tidy/record"
  mv "$build/tidy/record" "$record"
  exit 0
fi

sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$commands" | sort -u | while read -r file; do
  state=$(state_of "$file")
  [ -e "$build/tidy/clean/$state" ] || grep -qsx "$state" "$record" || echo "$state $file"
done | xargs -r -n 2 -P "$(nproc)" sh -c 'clang-tidy -quiet --extra-arg=-Wno-shadow -p "$build/tidy" "$2" 2>/dev/null && : >"$build/tidy/clean/$1"' tidy
