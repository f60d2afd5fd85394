// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Small experiments behind the charts of docs/accuracy.md and the maps of docs/stability.md, for what runs of
// the program do not show. Each takes the words that follow its name and prints CSV.
#pragma once

#include <string>
#include <vector>

namespace orthocone::studies
{
using Words = std::vector<std::string>;

/// studies compliance FILE.prm [--set "Section/Entry=value"]... [--matrix OUT]: figures of the compliance of
/// a scene.
void compliance(const Words &words);

/// studies trace FILE.prm [--set "Section/Entry=value"]... [--step N] [--method WORD] [--condensed 0]:
/// residuals of one step, solved from the forces of the step before; the steps up to there are solved by the
/// method of the file. With --condensed 0 each product with the compliance is a solution with the sparse
/// factor.
void trace(const Words &words);

/// studies spectrum FILE.prm [--set "Section/Entry=value"]...: condition of W, the largest eigenvalue that
/// decides on Box 3 for all nodes at once, and those of the symmetric part of D C W D.
void spectrum(const Words &words);

/// studies small_problems METHOD NODES PROBLEMS MAXIMUM_ITERATIONS: how many random problems without a body
/// end with which verdict, apart for friction above and below the critical one.
void small_problems(const Words &words);

/// studies projection FORMULA LAWS: accuracy and time of a formula for the projection, a line for each class
/// of points and law.
void projection(const Words &words);

/// studies layer SCHEME PROGRAM FRICTION STEPS...: one node on an elastic layer, its slip integrated by a
/// scheme.
void layer(const Words &words);

/// studies slip_integration FILE.prm [--set "Section/Entry=value"]... [--scheme bdf2] [--x X] [--y Y]: a
/// march through a scene with backward Euler or a formula of two steps for the slip, and what comes of the
/// node nearest to (x, y).
void slip_integration(const Words &words);

/// studies starts FILE.prm [--set "Section/Entry=value"]... [--step N] [--loads L] [--starts M]: step N, or L
/// random loads instead, solved from three special and M random starts with three methods, and which of these
/// end at the same solution.
void starts(const Words &words);

/// studies one_node [--coupling C] [--friction F] [--loads N]: a node with w_nn = w_tt = 1, w_nt = C, with F
/// times the friction at which it wedges, under loads from N directions: which states solve the law, and
/// which one is found.
void one_node(const Words &words);

/// studies fixed_jumps FILE.prm [--set "Section/Entry=value"]... [--cycles N]: a march that jumps N cycles at
/// once, however their rate changes; what is worn then, and how much the rate changed.
void fixed_jumps(const Words &words);

/// studies half_space DEGREE: error of the half-space's quadrature over cells and Gauss points, by the work
/// of a uniform pressure on a square, and the orders in both.
void half_space(const Words &words);

/// studies elastic FILE.prm [--set "Section/Entry=value"]...: size of the body, V-cycles that its solution
/// under a uniform pressure on the base takes for eight digits, seconds, and the memory of the process.
void elastic(const Words &words);
} // namespace orthocone::studies
