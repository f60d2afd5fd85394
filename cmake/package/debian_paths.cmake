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

# Scripts of Sphinx that Debian has in a package of its own are links to those, as dh_sphinxdoc makes them.
file(GLOB scripts "${CPACK_TEMPORARY_DIRECTORY}/*/share/doc/orthocone/html/_static/*.js"
  "${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/doc/orthocone/html/_static/*.js")
foreach(script IN LISTS scripts)
  cmake_path(GET script FILENAME name)
  set(shared /usr/share/javascript/sphinxdoc/1.0/${name})
  if(EXISTS ${shared})
    file(SHA256 ${shared} of_shared)
    file(SHA256 ${script} of_script)
    if(of_shared STREQUAL of_script)
      file(CREATE_LINK ../../../../javascript/sphinxdoc/1.0/${name} ${script} SYMBOLIC)
    endif()
  endif()
endforeach()
