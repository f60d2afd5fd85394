// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Contact problems as files of FCLIB, the Frictional Contact Library (local problems, HDF5). FCLIB knows
// isotropic, associated friction; docs/theory.md, "Problem files", has the map from other laws to it.
#pragma once

#include <orthocone/problems/contact_problem.h>

#include <optional>

namespace orthocone
{
/// Reads a local three-dimensional problem. Equality constraints that resist (R in FCLIB) are eliminated;
/// those that do not are a free face. Of a W that is not quite symmetric the symmetric part is taken. Throws
/// FileError if this is no such file, if it is inconsistent, or if its W is not symmetric beyond rounding
/// (mirror_difference()), and the file lacks the law that makes it symmetric.
ContactProblem read_problem(const std::string &file);

/// The solution in a file, in the problem's own scale; nothing if the file has none. It has the motions of a
/// face only: constraints that resist are eliminated. Throws FileError.
std::optional<ProblemSolution> read_solution(const std::string &file);

/// How far the solution in a file contradicts itself: the largest entry of u - (W r + V l + q) and of V^T r +
/// R l + s, relative to the largest sum of the sizes of their parts. Where l is not in the file, the
/// constraints that resist give it.
struct StoredErrors
{
  double displacement = 0;
  double multiplier = 0;
};

/// Throws FileError, also where there is no solution.
StoredErrors stored_errors(const std::string &file);

/// Throws FileError for a folder, a device or a pipe, which a file would replace.
void require_place_for_problem(const std::string &file);

/// Writes a file by FCLIB's library, which is either complete or not there, with a solution if there is one.
/// Throws FileError, and std::invalid_argument for a face beside a slip rule that is not associated, because
/// FCLIB's form has one matrix for both its sides (docs/theory.md, section 9).
void write_problem(const ContactProblem &problem, const std::optional<ProblemSolution> &solution,
                   const std::string &file);

/// FCLIB's own measure of error (its MERIT_1, relative) of a solution, in FCLIB's form of the problem.
double fclib_error(const ContactProblem &problem, const ProblemSolution &solution);
} // namespace orthocone
