# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
# Writes HEADER with the version and the git revision of SOURCE_DIR; run by every build, so that a program never names
# the revision of an older configuration. An unchanged header is left alone.
execute_process(COMMAND git describe --always --dirty
  WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
  set(revision "no git revision")
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
  "#define ORTHOCONE_VERSION \"${VERSION}\"\n#define ORTHOCONE_REVISION \"${revision}\"\n")
