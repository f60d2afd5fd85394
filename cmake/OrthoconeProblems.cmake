# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# Problem files, the program orthocone-solve (target orthocone_solve) and the entry Output/Problems, where FCLIB and HDF5
# are there.
find_library(FCLIB_LIBRARY fclib)
find_path(FCLIB_INCLUDE_DIR fclib.h)
# Debian has several HDF5: FCLIB uses the one without MPI.
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)
find_path(HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)

if(NOT FCLIB_LIBRARY OR NOT FCLIB_INCLUDE_DIR OR NOT HDF5_LIBRARY OR NOT HDF5_INCLUDE_DIR)
  message(STATUS "No orthocone-solve: it needs FCLIB and HDF5 (Debian: libfclib-dev)")
  add_custom_target(orthocone_solve COMMAND ${CMAKE_COMMAND} -E echo "no orthocone-solve: FCLIB is not there")
  return()
endif()

set(ORTHOCONE_HAS_FCLIB ON)
orthocone_library(problems DEPENDS contact)
target_include_directories(orthocone_problems SYSTEM PRIVATE ${FCLIB_INCLUDE_DIR} ${HDF5_INCLUDE_DIR})
orthocone_link_file(orthocone_problems ${FCLIB_LIBRARY})
orthocone_link_file(orthocone_problems ${HDF5_LIBRARY})

# The program writes the problems of its steps (Output/Problems): the sources of output alone see them, where they are.
target_link_libraries(orthocone_output $<LINK_ONLY:orthocone_problems>)
target_include_directories(orthocone_output PRIVATE ${CMAKE_BINARY_DIR}/views/problems)

add_executable(orthocone_solve source/problems/main.cc)
# The objects that need MPI are not taken from the library, and so it is not loaded.
target_link_libraries(orthocone_solve orthocone_problems -Wl,--as-needed)
orthocone_own_flags(orthocone_solve)
orthocone_common(orthocone_solve)
set_target_properties(orthocone_solve PROPERTIES OUTPUT_NAME orthocone-solve)
install(TARGETS orthocone_solve RUNTIME COMPONENT program OPTIONAL) # ./run does not build it
