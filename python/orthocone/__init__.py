# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Frictional contact with an elliptic Coulomb cone and a slip rule of its own.

    Scene.from_file("my.prm").run()    a run of the program in a process of its own
    Run("output/my")                   what a run has written
    solve(W, q, mu, p)                 contact forces of nodes behind a compliance
    project(force, mu), slip_direction(force, p), ...   the law of a node

Lengths are in mm and forces in N, as in the program; laws and solvers also work in other consistent units.
A node has local axes: the normal, then x and y, the axes of both ellipses. Forces act from the counterface on the body."""
from .program import FileError, ProgramError, UnknownEntry, UnsolvedStep, WrongInput
from .run_folder import ContactFile, Run
from .scene import Check, Scene

_OF_CONTACT = ("NotConverged", "Report", "Solution", "Status", "dual_norm", "friction_norm", "methods",
               "modified_displacement", "project", "slip_direction", "sliding_traction", "solve")
__all__ = ["Check", "ContactFile", "FileError", "ProgramError", "Run", "Scene", "UnknownEntry", "UnsolvedStep", "WrongInput",
           *_OF_CONTACT]


def __getattr__(name):
    """Loads the compiled part when it is asked for: run folders can be read, and scenes run, without it."""
    if name in _OF_CONTACT:
        from . import contact
        return getattr(contact, name)
    raise AttributeError(f"module 'orthocone' has no attribute '{name}'")


def __dir__():
    return sorted(__all__)
