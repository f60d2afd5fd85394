# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
#
#   spack repo add tools/packaging/spack
#   spack dev-build orthocone@0.2.0         # in the folder of the project
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Orthocone(CMakePackage):
    """Elastic bodies in frictional contact, with orthotropic friction and a slip rule of its own."""

    license("LGPL-2.1-or-later")
    version("0.2.0")

    variant("python", default=True, description="Tools and module for Python")
    variant("problems", default=False, description="orthocone-solve, for problem files of FCLIB")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("dealii@9.4: +mpi+p4est+trilinos+threads")
    depends_on("mpi")
    depends_on("suite-sparse")
    depends_on("metis@5:")
    depends_on("fftw@3:")
    depends_on("hmat-oss")
    depends_on("eigen@3.4:3")
    depends_on("openblas threads=pthreads")
    depends_on("boost@1.74: +program_options")
    depends_on("nlohmann-json@3.11:")
    depends_on("zlib-api")
    depends_on("fclib", when="+problems")
    extends("python", when="+python")
    depends_on("py-pybind11@2.10:", when="+python", type="build")
    for module in ("py-numpy", "py-matplotlib", "py-meshio"):
        depends_on(module, when="+python", type="run")

    generator("ninja")

    def cmake_args(self):
        args = [self.define("ORTHOCONE_TESTS", False)]
        if self.spec.satisfies("+python"):
            args.append(self.define("ORTHOCONE_PYTHON", self.spec["python"].command.path))
        return args

    @property
    def build_targets(self):
        return ["orthocone", "orthocone_python", "orthocone_solve"]

    def install(self, spec, prefix):
        with working_dir(self.build_directory):
            for component in ("program", "python"):
                cmake("--install", ".", "--component", component)
