# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors

function(orthocone_warnings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow)
  if(ORTHOCONE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  # deal.II's flags, which were chosen for g++, name warnings that clang does not have.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-warning-option>)
endfunction()

# Optimization for targets without deal.II, which empties CMake's own flags of the build types.
function(orthocone_own_flags target)
  target_compile_options(${target} PRIVATE $<IF:$<CONFIG:Debug>,-Og,-O3> -fPIC)
  target_compile_definitions(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:NDEBUG>)
endfunction()

# What all targets compile alike. The same template compiled with and without BLAS would break the one-definition rule.
function(orthocone_common target)
  orthocone_warnings(${target})
  # Debian's deal.II asks for all debug information, which is a third of the compile time; sanitizers want lines. And it
  # asks for no optimization at all in debug builds, which makes the tests with sanitizers several times slower.
  target_compile_options(${target} PRIVATE $<IF:$<CONFIG:Debug>,-g1$<SEMICOLON>-Og,-g0>)
  target_compile_definitions(${target} PRIVATE EIGEN_USE_BLAS EIGEN_USE_LAPACKE)
  target_link_libraries(${target} Eigen3::Eigen)
endfunction()

# deal.II's headers take seconds to read: they are read once for all targets that use deal.II.
function(orthocone_dealii target)
  deal_ii_setup_target(${target})
  orthocone_common(${target})
  if(ORTHOCONE_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM orthocone_headers)
  endif()
endfunction()

# orthocone_precompile_headers(NAME HEADER...)
function(orthocone_precompile_headers name)
  file(WRITE ${CMAKE_BINARY_DIR}/${name}.cc "")
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/${name}.cc)
  deal_ii_setup_target(${name})
  orthocone_common(${name})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# Tests spend their time in the libraries: little optimization of their own files saves a third of the time to compile them.
function(orthocone_test_flags target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1$<SEMICOLON>-fno-unroll-loops$<SEMICOLON>-fno-unroll-all-loops>)
endfunction()

# deal.II's macro uses the signature of target_link_libraries without keywords, and CMake wants one or the other.

# orthocone_library(NAME [DEALII] [DEPENDS LIBRARY...])
# The library of source/NAME and include/orthocone/NAME. Its public include path is a view that holds just
# orthocone/NAME, so that only headers of NAME and of DEPENDS are to be found.
function(orthocone_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DEALII" "" "DEPENDS")
  set(target orthocone_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS source/${name}/*.cc)
  list(FILTER sources EXCLUDE REGEX "/(main|thread_variable)\\.cc$")
  add_library(${target} STATIC ${sources})
  set(view ${CMAKE_BINARY_DIR}/views/${name})
  file(MAKE_DIRECTORY ${view}/orthocone)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/include/orthocone/${name} ${view}/orthocone/${name} SYMBOLIC)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:include>)
  foreach(dependency IN LISTS arg_DEPENDS)
    target_link_libraries(${target} orthocone_${dependency})
  endforeach()
  if(arg_DEALII)
    orthocone_dealii(${target})
  else()
    orthocone_own_flags(${target})
    orthocone_common(${target})
  endif()
endfunction()

# Links a library by its file, and by its name where the library is installed: a package names no file of this machine.
function(orthocone_link_file target file)
  get_filename_component(name ${file} NAME_WE)
  string(REGEX REPLACE "^lib" "" name ${name})
  target_link_libraries(${target} $<BUILD_INTERFACE:${file}> $<INSTALL_INTERFACE:${name}>)
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
