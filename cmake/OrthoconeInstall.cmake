# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# What `cmake --install` takes along, in components: `contact`, `body` (it wants `contact`, too), `app` (the program as
# libraries, which want both), `program`, and what stands in the file of the Python module. The headers of a library are
# those of include/orthocone/NAME.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/orthocone)

# orthocone_install(COMPONENT LIBRARY...)
function(orthocone_install component)
  foreach(name IN LISTS ARGN)
    set_target_properties(orthocone_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS orthocone_${name} EXPORT orthocone-${component}
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
    install(DIRECTORY include/orthocone/${name} DESTINATION include/orthocone COMPONENT ${component})
  endforeach()
  install(EXPORT orthocone-${component} NAMESPACE orthocone:: DESTINATION ${package_dir} COMPONENT ${component})
endfunction()

orthocone_install(contact base surface contact)
orthocone_install(body entries body)
set(of_app multigrid scene march results accuracy output app)
if(ORTHOCONE_HAS_FCLIB)
  list(APPEND of_app problems) # output writes problem files by it
endif()
orthocone_install(app ${of_app})

# Eigen's templates must mean the same in the libraries and in what uses them. A header refuses to be compiled for a
# processor with wider registers than those of every one.
target_compile_definitions(orthocone_base INTERFACE
  $<INSTALL_INTERFACE:EIGEN_USE_BLAS> $<INSTALL_INTERFACE:EIGEN_USE_LAPACKE>
  # Else Eigen includes C's complex.h, whose macro I Kokkos stumbles over.
  $<INSTALL_INTERFACE:lapack_complex_float=std::complex<float$<ANGLE-R>>
  $<INSTALL_INTERFACE:lapack_complex_double=std::complex<double$<ANGLE-R>>)
if(NOT CMAKE_CXX_FLAGS MATCHES "-m")
  target_compile_definitions(orthocone_base INTERFACE $<INSTALL_INTERFACE:ORTHOCONE_EIGEN_ALIGNMENT=16>)
endif()

configure_package_config_file(cmake/orthocone-config.cmake.in ${CMAKE_BINARY_DIR}/orthocone-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/orthocone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/orthocone-config.cmake ${CMAKE_BINARY_DIR}/orthocone-config-version.cmake
  DESTINATION ${package_dir} COMPONENT contact)

install(TARGETS orthocone RUNTIME COMPONENT program)
