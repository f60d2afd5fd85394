// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "fclib_form.h"
#include "hdf5_file.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/problems/problem_file.h>

extern "C"
{
#include <fclib.h>
}

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// The largest number of rows of a full matrix whose entries FCLIB can count.
constexpr Index most_rows = 46000;

/// A full matrix by columns in the form of FCLIB's library, whose measure of error knows no other form.
class FclibMatrix
{
public:
  explicit FclibMatrix(MatrixXd matrix)
      : values_(std::move(matrix))
  {
    const auto m = static_cast<int>(values_.rows()), n = static_cast<int>(values_.cols());
    for (int column = 0; column <= n; ++column)
      begins_.push_back(m * column);
    for (int entry = 0; entry < m * n; ++entry)
      rows_.push_back(entry % m);
    view_ = {m * n, m, n, begins_.data(), rows_.data(), values_.data(), -1, nullptr};
  }
  FclibMatrix(const FclibMatrix &) = delete;
  FclibMatrix &operator=(const FclibMatrix &) = delete;

  fclib_matrix *view() { return &view_; }

private:
  MatrixXd values_;
  std::vector<int> begins_, rows_;
  fclib_matrix view_{};
};

/// A problem in FCLIB's form.
class FclibProblem
{
public:
  explicit FclibProblem(const ContactProblem &problem)
      : scale_(problem.laws),
        w_(scale_.displacement.asDiagonal() * problem.w * scale_.force.asDiagonal()),
        v_(scale_.displacement.asDiagonal() * problem.face),
        r_(MatrixXd::Zero(problem.face.cols(), problem.face.cols())),
        q_(scale_.displacement.cwiseProduct(problem.q)),
        s_(-problem.balance),
        title_(problem.title)
  {
    const bool has_face = problem.face.cols() > 0;
    if (has_face && !scale_.is_symmetric())
      throw std::invalid_argument("a face that forces drive beside a slip rule that is not associated has no "
                                  "form in FCLIB");
    info_ = {title_.data(), description_.data(), math_info_.data()};
    local_ = {w_.view(),
              has_face ? v_.view() : nullptr,
              has_face ? r_.view() : nullptr,
              scale_.mu.data(),
              q_.data(),
              has_face ? s_.data() : nullptr,
              3,
              &info_};
  }

  fclib_local *local() { return &local_; }

  /// A solution in the same form; it lives until the next one.
  fclib_solution *scaled(const ProblemSolution &solution)
  {
    force_ = solution.force.cwiseQuotient(scale_.force);
    displacement_ = solution.displacement.cwiseProduct(scale_.displacement);
    motions_ = solution.motions;
    solution_ = {nullptr, displacement_.data(), force_.data(), local_.V ? motions_.data() : nullptr};
    return &solution_;
  }

private:
  FclibScale scale_;
  FclibMatrix w_, v_, r_;
  VectorXd q_, s_;
  std::string title_;
  std::string description_ =
      "Units N and mm. Local axes: normal, x, y. Group orthocone: mu and p of the nodes, two "
      "numbers each. Where they are not one coefficient, the problem is in the scale in "
      "which it is.";
  std::string math_info_ = "W is symmetric and positive definite where slip is associated.";
  VectorXd force_, displacement_, motions_;
  fclib_info info_{};
  fclib_local local_{};
  fclib_solution solution_{};
};

void write_extension(const std::vector<OrthotropicFriction> &laws,
                     const std::optional<ProblemSolution> &solution, const std::string &name)
{
  VectorXd mu(2 * laws.size()), p(2 * laws.size());
  Index i = 0;
  for (const OrthotropicFriction &law : laws)
  {
    mu.segment<2>(i) = law.mu();
    p.segment<2>(i) = law.p();
    i += 2;
  }
  Hdf5File file(name, Hdf5File::Access::extend);
  file.make_group("/orthocone");
  file.write("/orthocone/mu", mu);
  file.write("/orthocone/p", p);
  if (solution)
    file.write("/orthocone/residual", VectorXd::Constant(1, solution->residual));
  file.close();
}

[[noreturn]] void fail(const std::string &file, const std::string &why)
{
  throw FileError("'" + shown_path(file) + "' cannot be written: " + why);
}

/// Makes an empty file of its own: what has the name goes, and a link is not followed. Whether it can be
/// made.
bool make_file(const std::string &name)
{
  std::error_code code;
  std::filesystem::remove(name, code);
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  return descriptor >= 0 && ::close(descriptor) == 0;
}

/// FCLIB ends the program where it cannot write. So it is called only where a file can be made and has room.
void check_room(const std::string &part, const std::string &file, const double n_values)
{
  constexpr double bytes_of_value = sizeof(double) + sizeof(int), bytes_of_names = 1e5;
  if (!make_file(part))
    fail(file, std::strerror(errno));
  std::error_code error;
  const auto space = std::filesystem::space(part, error);
  std::error_code ignored;
  std::filesystem::remove(part, ignored); // FCLIB makes it itself
  if (error)
    fail(file, error.message());
  if (static_cast<double>(space.available) < n_values * bytes_of_value + bytes_of_names)
    fail(file, "too little room on the disk");
}
} // namespace

void require_place_for_problem(const std::string &file)
{
  std::error_code code;
  const auto status = std::filesystem::status(file, code);
  if (std::filesystem::is_directory(status))
    fail(file, "it is a folder");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    fail(file, "it is no ordinary file");
}

void write_problem(const ContactProblem &problem, const std::optional<ProblemSolution> &solution,
                   const std::string &file)
{
  const std::string part = file + ".part";
  const auto n = static_cast<double>(problem.q.size());
  require_place_for_problem(file);
  if (problem.q.size() > most_rows)
    fail(file, "FCLIB counts no more than 2^31 entries of W");
  check_room(part, file, n * (n + static_cast<double>(problem.face.cols()) + 4));
  FclibProblem fclib(problem);
  if (fclib_write_local(fclib.local(), part.c_str()) != 1 ||
      (solution && fclib_write_solution(fclib.scaled(*solution), part.c_str()) != 1))
    fail(file, "FCLIB refuses");
  write_extension(problem.laws, solution, part);
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error)
    fail(file, error.message());
}

double fclib_error(const ContactProblem &problem, const ProblemSolution &solution)
{
  if (problem.q.size() > most_rows)
    return std::numeric_limits<double>::quiet_NaN();
  FclibProblem fclib(problem);
  return fclib_merit_local(fclib.local(), MERIT_1, fclib.scaled(solution));
}
} // namespace orthocone
