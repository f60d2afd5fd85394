# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# The Python module: the target orthocone_python makes python/orthocone in the build folder, which is to be in PYTHONPATH.
# Without pybind11 that target says so, and all others are as they were.
set(ORTHOCONE_PYTHON /usr/bin/python3 CACHE FILEPATH "Python with NumPy, Matplotlib, meshio, VTK and Selenium")
if(ORTHOCONE_FUZZ OR ORTHOCONE_SANITIZE)
  return() # Python itself would have to be compiled so
endif()
set(Python_EXECUTABLE ${ORTHOCONE_PYTHON})
find_package(Python COMPONENTS Interpreter Development.Module)
set(PYBIND11_FINDPYTHON ON)
if(Python_Development.Module_FOUND)
  find_package(pybind11 2.10 CONFIG)
endif()

if(NOT pybind11_FOUND)
  message(STATUS "No Python module: it needs pybind11 and the headers of ${ORTHOCONE_PYTHON} (Debian: pybind11-dev python3-dev)")
  add_custom_target(orthocone_python COMMAND ${CMAKE_COMMAND} -E echo "no Python module: pybind11 is not there")
  return()
endif()

set(package ${CMAKE_BINARY_DIR}/python/orthocone)
file(MAKE_DIRECTORY ${package})
file(GLOB modules RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/python/orthocone CONFIGURE_DEPENDS python/orthocone/*.py)
foreach(module IN LISTS modules)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/python/orthocone/${module} ${package}/${module} SYMBOLIC)
endforeach()

# As pybind11_add_module() does, which has another signature of target_link_libraries.
add_library(orthocone_python MODULE source/python/contact_module.cc)
target_link_libraries(orthocone_python pybind11::pybind11 Python::Module)
# Its templates are long to optimize, and all work is in the library.
target_compile_options(orthocone_python PRIVATE -O1 -fPIC)
target_compile_definitions(orthocone_python PRIVATE $<$<NOT:$<CONFIG:Debug>>:NDEBUG>)
orthocone_common(orthocone_python)
# The objects that need MPI are not taken from the library, and so it is not loaded.
target_link_libraries(orthocone_python orthocone_contact -Wl,--as-needed)
set_target_properties(orthocone_python PROPERTIES PREFIX "" OUTPUT_NAME _contact SUFFIX .${Python_SOABI}.so
  CXX_VISIBILITY_PRESET hidden LIBRARY_OUTPUT_DIRECTORY ${package})

set(ORTHOCONE_PYTHON_DIR lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages CACHE STRING
  "Where the Python module is installed, below the prefix")
install(TARGETS orthocone_python LIBRARY DESTINATION ${ORTHOCONE_PYTHON_DIR}/orthocone COMPONENT python)
install(DIRECTORY python/orthocone DESTINATION ${ORTHOCONE_PYTHON_DIR} COMPONENT python FILES_MATCHING PATTERN "*.py"
  PATTERN "__pycache__" EXCLUDE)
