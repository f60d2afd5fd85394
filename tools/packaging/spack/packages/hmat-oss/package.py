# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class HmatOss(CMakePackage):
    """Hierarchical matrices, for the half-space below a body with multigrid."""

    homepage = "https://github.com/jeromerobert/hmat-oss"
    git = "https://github.com/jeromerobert/hmat-oss.git"

    license("GPL-2.0-or-later")

    version("1.10.0", tag="1.10.0")
    version("1.8.1", tag="1.8.1")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("blas")
    depends_on("lapack")
