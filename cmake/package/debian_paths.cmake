# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# CPack calls it before it packs: below /usr Debian's Python looks for modules in python3, below /usr/local in python3.11.
file(GLOB_RECURSE modules LIST_DIRECTORIES true "${CPACK_TEMPORARY_DIRECTORY}/*/dist-packages")
foreach(folder IN LISTS modules)
  if(folder MATCHES "/usr/lib/python3\\.[0-9]+/dist-packages$")
    cmake_path(GET folder PARENT_PATH versioned)
    cmake_path(GET versioned PARENT_PATH lib)
    file(RENAME ${versioned} ${lib}/python3)
  endif()
endforeach()
