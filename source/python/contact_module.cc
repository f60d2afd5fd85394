// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The contact column for Python, on NumPy's memory. python/orthocone/contact.py checks and documents, so that
// shapes are right here. Laws are rows (mu_x, mu_y, p_x, p_y), one for each node.
#include <orthocone/base/stop_point.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/surface/given_compliance.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>

namespace py = pybind11;

namespace
{
using namespace orthocone;
using Eigen::Index;
using Array = py::array_t<double, py::array::c_style>;
using Laws = std::vector<OrthotropicFriction>;

DenseView matrix_view(const py::array_t<double> &w)
{
  return {w.data(), w.shape(0), w.shape(1)}; // only its symmetric part counts, the same in either order
}

Eigen::Map<const Eigen::VectorXd> vector_view(const Array &array)
{
  return {array.data(), array.size()};
}

Laws to_laws(const Array &rows)
{
  Laws laws;
  for (Index i = 0; i < rows.shape(0); ++i)
    laws.push_back({rows.at(i, 0), rows.at(i, 1), rows.at(i, 2), rows.at(i, 3)});
  return laws;
}

/// The vector itself, without a copy, as an array of so many columns: NumPy frees it.
Array to_rows(Eigen::VectorXd vector, const Index n_columns)
{
  auto owner = std::make_unique<Eigen::VectorXd>(std::move(vector));
  double *const data = owner->data();
  const Index n_rows = owner->size() / n_columns;
  const py::capsule free(owner.release(),
                         [](void *const pointer) { delete static_cast<Eigen::VectorXd *>(pointer); });
  return Array({n_rows, n_columns}, data, free);
}

/// Applies `function` to every row of `in` and its law; returns rows of n_out numbers.
template<int n_in, int n_out, typename Function>
Array for_each_node(const Array &in, const Array &rows, const Function &function)
{
  const Laws laws = to_laws(rows);
  Eigen::VectorXd out(n_out * in.shape(0));
  for (Index i = 0; i < in.shape(0); ++i)
    out.segment<n_out>(n_out * i) =
        function(laws[i], Eigen::Map<const Eigen::Matrix<double, n_in, 1>>(in.data(i, 0)));
  return to_rows(std::move(out), n_out);
}

using Vector1 = Eigen::Matrix<double, 1, 1>;

void add_laws(py::module_ &m)
{
  m.def("project",
        [](const Array &force, const Array &laws) {
          return for_each_node<3, 3>(force, laws,
                                     [](const auto &law, const auto &r) { return project(law, r); });
        });
  m.def("modified_displacement",
        [](const Array &d, const Array &laws)
        {
          return for_each_node<3, 3>(
              d, laws, [](const auto &law, const auto &v) { return modified_displacement(law, v); });
        });
  m.def("friction_norm",
        [](const Array &force, const Array &laws)
        {
          return for_each_node<2, 1>(force, laws,
                                     [](const auto &law, const auto &r)
                                     { return Vector1(friction_norm(law, r[0], r[1])); });
        });
  m.def("dual_norm",
        [](const Array &slip, const Array &laws)
        {
          return for_each_node<2, 1>(
              slip, laws, [](const auto &law, const auto &v) { return Vector1(dual_norm(law, v[0], v[1])); });
        });
  m.def("slip_direction",
        [](const Array &force, const Array &laws)
        {
          return for_each_node<2, 2>(
              force, laws, [](const auto &law, const auto &r) { return slip_direction(law, r[0], r[1]); });
        });
  m.def("sliding_traction",
        [](const Array &slip, const Array &laws)
        {
          return for_each_node<2, 2>(
              slip, laws, [](const auto &law, const auto &v) { return sliding_traction(law, v[0], v[1]); });
        });
}

Array to_array(const Trace &trace)
{
  Eigen::VectorXd rows(4 * trace.points().size());
  Index i = 0;
  for (const TracePoint &point : trace.points())
    rows.segment<4>(4 * i++) << point.iterations, point.residual, point.force, point.seconds;
  return to_rows(std::move(rows), 4);
}

py::dict to_dict(const SolverReport &report)
{
  py::dict law;
  law["penetration"] = report.law.penetration;
  law["complementarity"] = report.law.complementarity;
  law["friction_cone"] = report.law.friction_cone;
  law["slip_rule"] = report.law.slip_rule;
  py::dict result;
  result["converged"] = report.converged;
  result["iterations"] = report.iterations;
  result["residual"] = report.residual;
  result["worst_node"] = report.worst_node;
  result["verdict"] = to_word(report.verdict);
  result["law_errors"] = law;
  result["trace"] = to_array(report.trace);
  return result;
}

/// Returns (force, displacement, status, report). Throws std::invalid_argument, Python's ValueError, for a
/// matrix that is no compliance.
py::tuple solve(const py::array_t<double> &w, const Array &q, const Array &laws, const Array &start,
                const ContactSolverOptions &options)
{
  Eigen::VectorXd force = vector_view(start);
  Eigen::VectorXd displacement, status(force.size() / 3);
  SolverReport report;
  std::vector<std::string> notes;
  const DenseView view = matrix_view(w);
  {
    const py::gil_scoped_release release;
    const GivenCompliance given = given_compliance(view, vector_view(q));
    notes = given.notes();
    const Laws ellipses = to_laws(laws);
    const ContactSystem system(*given.compliance, {ellipses.begin(), ellipses.end()});
    const ContactStep step(system, vector_view(q));
    report = solve_or_rescue(*make_contact_solver(system, options), step, force);
    displacement = step.displacement(force);
    const auto statuses = step.statuses(force, displacement);
    for (Index node = 0; node < step.n_nodes(); ++node)
      status[node] = static_cast<int>(statuses[node]);
  }
  py::dict of_report = to_dict(report);
  of_report["notes"] = py::tuple(py::cast(notes));
  return py::make_tuple(to_rows(std::move(force), 3), to_rows(std::move(displacement), 3),
                        to_rows(std::move(status), 1), of_report);
}
/// Does `work`, which may release the interpreter's lock. Python's handlers of signals run now and then
/// between two iterations, and what they raise, as Ctrl-C does, ends the work.
template<typename Work>
py::tuple interruptible(const Work &work)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds between_looks(50); // the lock is not for free
  const Stoppable stoppable(
      [=, last = Clock::now()]() mutable
      {
        if (Clock::now() - last < between_looks)
          return false;
        last = Clock::now();
        const py::gil_scoped_acquire lock;
        return PyErr_CheckSignals() != 0;
      });
  try
  {
    return work();
  }
  catch (const Stopped &)
  {
    throw py::error_already_set();
  }
}
} // namespace

PYBIND11_MODULE(_contact, m)
{
  add_laws(m);
  m.def("methods",
        []
        {
          py::dict words;
          for (const ContactMethod &method : contact_methods())
            words[py::str(std::string(method.word))] = std::string(method.help);
          return words;
        });
  m.def("solve",
        [](const py::array_t<double> &w, const Array &q, const Array &laws, const Array &start,
           const std::string &method, const double tolerance, const unsigned int maximum_iterations)
        {
          ContactSolverOptions options;
          options.method = method;
          options.tolerance = tolerance;
          options.maximum_iterations = maximum_iterations;
          return interruptible([&] { return solve(w, q, laws, start, options); });
        });
}
