# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# What stands beside the installed program, of component `program`: scenes, tools, pages, man pages, completion. And the
# Debian package that `cpack -G DEB` makes of the components `program` and `python`.
set(share ${CMAKE_INSTALL_DATADIR}/orthocone)
install(DIRECTORY prm DESTINATION ${share} COMPONENT program)
install(DIRECTORY tools/report tools/scene tools/paraview DESTINATION ${share}/tools COMPONENT program
  PATTERN "__pycache__" EXCLUDE)
install(PROGRAMS tools/report.py tools/python DESTINATION ${share}/tools COMPONENT program)
install(DIRECTORY tools/sweeps tools/meshes tools/runs tools/rosettes tools/fatigues tools/identifications tools/topographies DESTINATION ${share}/tools COMPONENT program
  PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY python/orthocone DESTINATION ${share}/python COMPONENT program FILES_MATCHING PATTERN "*.py"
  PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program PATTERN "__pycache__" EXCLUDE)
install(FILES CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# The pages as tools/package has made them by Sphinx. Other installations do without.
install(DIRECTORY ${CMAKE_BINARY_DIR}/package/html DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program OPTIONAL
  PATTERN ".buildinfo" EXCLUDE)
install(FILES cmake/package/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES cmake/package/orthocone.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME orthocone COMPONENT program)

# orthocone_tool(NAME MODULES SCRIPT [ARGUMENTS]): a command NAME that runs tools/SCRIPT.
function(orthocone_tool name MODULES SCRIPT)
  set(ARGUMENTS ${ARGN})
  configure_file(cmake/package/tool.in ${CMAKE_BINARY_DIR}/package/${name} @ONLY)
  install(PROGRAMS ${CMAKE_BINARY_DIR}/package/${name} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endfunction()
orthocone_tool(orthocone-report numpy,meshio report.py)
orthocone_tool(orthocone-sweep numpy,matplotlib sweeps/sweep.py "--program \"$bin/orthocone\"")
orthocone_tool(orthocone-fretting-map numpy,matplotlib sweeps/fretting_map.py "--program \"$bin/orthocone\"")
orthocone_tool(orthocone-wear-profile numpy,matplotlib,meshio runs/wear_profile.py)
orthocone_tool(orthocone-topography numpy,matplotlib topographies/topography.py)
orthocone_tool(orthocone-import numpy,meshio meshes/import_mesh.py)
orthocone_tool(orthocone-rosette numpy,matplotlib rosettes/rosette.py)
orthocone_tool(orthocone-fatigue numpy,matplotlib fatigues/fatigue.py)
orthocone_tool(orthocone-identify numpy,matplotlib identifications/identify.py "--program \"$bin/orthocone\"")

# Debian wants man pages and the changelog compressed. -n: the same bytes each time.
function(orthocone_compressed file folder)
  add_custom_command(OUTPUT package/${file}.gz COMMAND gzip -9nc package/${file} > package/${file}.gz
    DEPENDS ${CMAKE_BINARY_DIR}/package/${file})
  add_custom_target(orthocone_${file} DEPENDS package/${file}.gz)
  add_dependencies(orthocone orthocone_${file})
  install(FILES ${CMAKE_BINARY_DIR}/package/${file}.gz DESTINATION ${folder} COMPONENT program)
endfunction()
foreach(page orthocone.1 orthocone-solve.1 orthocone-report.1)
  configure_file(cmake/package/${page}.in ${CMAKE_BINARY_DIR}/package/${page} @ONLY)
  orthocone_compressed(${page} ${CMAKE_INSTALL_MANDIR}/man1)
endforeach()
foreach(tool sweep fretting-map wear-profile topography import rosette fatigue identify) # orthocone-report.1 describes them, too
  file(CREATE_LINK orthocone-report.1.gz ${CMAKE_BINARY_DIR}/package/orthocone-${tool}.1.gz SYMBOLIC)
  install(FILES ${CMAKE_BINARY_DIR}/package/orthocone-${tool}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endforeach()

set(CPACK_PACKAGE_CONTACT "the orthocone authors <orthocone@users.noreply.github.com>" CACHE STRING "Maintainer of the package")
if(Python_Interpreter_FOUND)
  set(script ${PROJECT_SOURCE_DIR}/tools/packaging/debian_changelog.py)
  add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/package/changelog
    COMMAND ${Python_EXECUTABLE} -B ${script} ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_VERSION}
      "${CPACK_PACKAGE_CONTACT}" > ${CMAKE_BINARY_DIR}/package/changelog
    DEPENDS ${script} ${PROJECT_SOURCE_DIR}/CHANGELOG.md VERBATIM)
  orthocone_compressed(changelog ${CMAKE_INSTALL_DOCDIR})
endif()

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # what is packed is built before; the tests are not part of it
set(CPACK_PACKAGE_NAME orthocone)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "elastic bodies in contact with orthotropic friction")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "An elastic body is pressed on another one and released again, cycle
after cycle. Friction is orthotropic (an elliptic Coulomb cone), and the
slip rule is not tied to the cone (another ellipse). orthocone computes
slip, pressure, stick zones, dissipated energy and wear. It is made for
tribologists, fretting and wear engineers, and researchers in contact
mechanics.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Any BLAS would do, but the program chooses threads for this one. The compiled module is for one version of Python.
set(python "python3")
if(pybind11_FOUND)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(python "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
endif()
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "libopenblas0-pthread, ${python}, python3-numpy, python3-matplotlib, python3-meshio, libjs-sphinxdoc")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/debian_paths.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
# The libraries for programs of one's own (components contact and body) are installed by `cmake --install`.
set(CPACK_COMPONENTS_ALL program python)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
include(CPack)
