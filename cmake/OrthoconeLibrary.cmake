# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors

function(orthocone_warnings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Werror)
  # deal.II's flags, which were chosen for g++, name warnings that clang does not have.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-warning-option>)
endfunction()

# Optimization for targets without deal.II, which empties CMake's own flags of the build types.
function(orthocone_own_flags target)
  target_compile_options(${target} PRIVATE $<IF:$<CONFIG:Debug>,-Og,-O3> -g -fPIC)
  target_compile_definitions(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:NDEBUG>)
endfunction()

# deal.II's macro uses the signature of target_link_libraries without keywords, and CMake wants one or the other.

# orthocone_library(NAME [DEALII] [DEPENDS LIBRARY...])
# The library of source/NAME and include/orthocone/NAME. Its public include path is a view that holds just
# orthocone/NAME, so that only headers of NAME and of DEPENDS are to be found.
function(orthocone_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DEALII" "" "DEPENDS")
  set(target orthocone_${name})
  file(GLOB sources CONFIGURE_DEPENDS source/${name}/*.cc)
  add_library(${target} STATIC ${sources})
  set(view ${CMAKE_BINARY_DIR}/views/${name})
  file(MAKE_DIRECTORY ${view}/orthocone)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/include/orthocone/${name} ${view}/orthocone/${name} SYMBOLIC)
  target_include_directories(${target} PUBLIC ${view})
  foreach(dependency IN LISTS arg_DEPENDS)
    target_link_libraries(${target} orthocone_${dependency})
  endforeach()
  if(arg_DEALII)
    deal_ii_setup_target(${target})
  else()
    orthocone_own_flags(${target})
  endif()
  orthocone_warnings(${target})
endfunction()

# Provides the header orthocone_revision.h to the sources of a library.
function(orthocone_add_revision target)
  set(folder ${CMAKE_BINARY_DIR}/revision)
  add_custom_target(${target}_revision
    BYPRODUCTS ${folder}/orthocone_revision.h
    COMMAND ${CMAKE_COMMAND} -DHEADER=${folder}/orthocone_revision.h -DVERSION=${PROJECT_VERSION}
      -DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/write_revision.cmake)
  add_dependencies(${target} ${target}_revision)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
