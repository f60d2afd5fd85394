# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# Completion of bash for orthocone: options, parameter files, and behind --set the names of entries. It asks the program, once
# a shell, and so knows what the program knows.

# The words "Section/Entry=", one a line.
_orthocone_entries() {
  [ -n "${_orthocone_names-}" ] ||
    _orthocone_names=$("$1" --defaults 2>/dev/null |
      sed -n -e '/^subsection /{s/^subsection //;h}' -e '/^  set /{s/^  set \([^=]*[^= ]\) *=.*/\1=/;G;s|\(.*\)\n\(.*\)|\2/\1|p}')
  printf '%s\n' "$_orthocone_names"
}

_orthocone() {
  local program=$1 word=$2 before=$3 name typed
  [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD - 2]-} # --set= is two words for readline
  [ "$word" != = ] || word=
  COMPREPLY=()
  case $before in
    --set)
      compopt -o nospace 2>/dev/null
      typed=${word#[\"\']} # readline keeps an opening quotation mark
      typed=${typed//\\/}
      while IFS= read -r name; do
        case $name in "$typed"*) ;; *) continue ;; esac
        case $word in [\"\']*) ;; *) name=${name// /\\ } ;; esac # outside of quotation marks spaces are escaped
        COMPREPLY+=("$name")
      done < <(_orthocone_entries "$program")
      return ;;
    --output | -o)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      return ;;
    --picture)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.@(svg|png)' -- "$word")
      return ;;
    --threads) return ;;
  esac
  if [ "${word#-}" != "$word" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$program" --help 2>/dev/null | grep -o -e '--[a-z]*' | sort -u)" -- "$word")
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.prm' -- "$word")
  fi
}
complete -F _orthocone orthocone
