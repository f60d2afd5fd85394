# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A scene of bodies.py by GetFEM: prints a line of CSV a step. Run by getfem.py, a process of its own.

Usage: getfem_scene.py SCENE AUGMENTATION BOUND_OF_RESIDUAL"""
import os
import sys

import bodies
import getfem
import numpy as np

DIM = 3


def contact(model, fem, augmentation, friction):
    """Nodal contact conditions at the base. Increments want gamma = -1: the brick forms u + gamma wt."""
    places = fem.basic_dof_nodes()
    normal = np.nonzero((np.abs(places[2]) < bodies.ROUNDING) & (np.arange(places.shape[1]) % DIM == 2))[0]
    n = len(normal)
    B_n, B_t = getfem.Spmat("empty", n, fem.nbdof()), getfem.Spmat("empty", 2 * n, fem.nbdof())
    for i, dof in enumerate(normal):
        B_n.add(i, int(dof), -1.0)
        B_t.add(2 * i, int(dof) - 2, 1.0)
        B_t.add(2 * i + 1, int(dof) - 1, 1.0)
    model.add_variable("pressure", n)
    model.add_variable("friction", 2 * n)
    for name, value in (("r", augmentation), ("mu", friction), ("gap", 0.0), ("alpha", 1.0), ("gamma", -1.0)):
        model.add_initialized_data(name, [value])
    model.add_initialized_data("wt", np.zeros(fem.nbdof()))
    model.add_basic_contact_brick("u", "pressure", "friction", "r", B_n, B_t, "mu", "gap", "alpha", 1, "gamma", "wt")
    return normal


def make_model(scene, augmentation):
    """Returns the model, its displacements, and the degrees of freedom (z) of the base."""
    nodes, bricks = scene.mesh()
    mesh = getfem.Mesh("empty", DIM)
    mesh.add_convex(getfem.GeoTrans("GT_QK(3,1)"), np.ascontiguousarray(np.transpose(nodes[bricks], (2, 1, 0))))
    fem = getfem.MeshFem(mesh, DIM)
    fem.set_fem(getfem.Fem("FEM_QK(3,1)"))
    points = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(3,5)"))  # 3 x 3 x 3, as ours
    model = getfem.Model("real")
    model.add_fem_variable("u", fem)
    E, nu = bodies.YOUNG, bodies.POISSON
    model.add_initialized_data("lambda", [E * nu / ((1 + nu) * (1 - 2 * nu))])
    model.add_initialized_data("mu_e", [E / (2 * (1 + nu))])
    model.add_isotropic_linearized_elasticity_brick(points, "u", "lambda", "mu_e")
    top = mesh.outer_faces_in_box([-99, -99, bodies.SIZE - 1e-3], [99, 99, bodies.SIZE + 1e-3])
    mesh.set_region(1, top)
    model.add_initialized_fem_data("top", fem, np.zeros(fem.nbdof()))
    model.add_Dirichlet_condition_with_simplification("u", 1, "top")  # eliminated: faster than multipliers
    return model, fem, contact(model, fem, augmentation, scene.friction)


def main():
    scene, augmentation, bound = bodies.SCENES[sys.argv[1]], float(sys.argv[2]), float(sys.argv[3])
    getfem.util_trace_level(0)
    getfem.util_warning_level(0)
    model, fem, normal = make_model(scene, augmentation)
    heights = fem.basic_dof_nodes()[2]
    print("force_x,force_y,force_z,max_slip,iterations,converged")
    for place in scene.steps():
        target = np.tile(place, fem.nbdof() // DIM) * (np.abs(heights - bodies.SIZE) < bodies.ROUNDING)
        model.set_variable("top", target)
        iterations, is_solved = model.solve("max_res", bound, "max_iter", 60, "lsolver", "mumps")
        u = model.variable("u")
        model.set_variable("wt", u)
        friction = model.variable("friction").reshape(-1, 2).sum(axis=0)
        slip = np.hypot(u[normal - 2], u[normal - 1]).max()
        print(f"{friction[0]:.12g},{friction[1]:.12g},{-model.variable('pressure').sum():.12g},{slip:.12g},"
              f"{int(iterations)},{int(is_solved)}")
    sys.stdout.flush()
    os._exit(0)  # its end takes long, and says nothing more


if __name__ == "__main__":
    main()
