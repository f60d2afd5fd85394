// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/mpi.h"
#include "multigrid/matrix_free_stiffness.h"
#include "multigrid/v_cycle.h"
#include "scene.h"

#include <orthocone/accuracy/adaptive_mesh.h>
#include <orthocone/base/machine.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/body.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <sys/resource.h>

#include <iostream>

namespace orthocone::studies
{
namespace
{
/// What the process had at most, bytes.
long peak_memory()
{
  struct rusage usage
  {
  };
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * usage.ru_maxrss;
}

/// Forces of a unit pressure on the base, N.
BodyVector<double> pressed_base(const Discretization &space, const MatrixFreeStiffness<double> &stiffness)
{
  BodyVector<double> forces = stiffness.make_vector();
  for (const ContactNode &node : space.contact_surface().nodes)
    forces.local_element(node.dofs[2]) = node.area;
  return forces;
}

/// V-cycles that conjugate gradients take for eight digits.
unsigned int iterations(const MatrixFreeStiffness<double> &stiffness, const VCycle &cycle,
                        const BodyVector<double> &forces)
{
  constexpr unsigned int most_iterations = 400;
  constexpr double digits = 1e-8;
  BodyVector<double> displacement = stiffness.make_vector();
  dealii::SolverControl control(most_iterations, digits * forces.l2_norm(), false, false);
  dealii::SolverCG<BodyVector<double>>(control).solve(stiffness, displacement, forces, cycle);
  return control.last_step();
}

/// With the cells that Mesh/Adaptive asks for. Multigrid finds them, which has no more memory than it needs.
Parameters adapted(Parameters parameters)
{
  parameters.mesh.backend = BodyBackend::multigrid;
  if (parameters.mesh.adaptive > 0)
    parameters.mesh = adapted_mesh(
        parameters, choose_model(parameters), [](const std::string &) {}, memory_limit().gigabytes);
  return parameters;
}
} // namespace

void elastic(const Words &words)
{
  test::start_mpi();
  {
    const Parameters parameters = adapted(SceneWords(words).parameters);
    const Stopwatch set_up;
    const Body body(parameters, choose_model(parameters).symmetry);
    const Discretization &space = body.solid();
    const MatrixFreeStiffness<double> stiffness(space, parameters.material);
    const VCycle cycle(space, parameters.mesh, parameters.geometry, parameters.material);
    const double set_up_seconds = set_up.seconds();
    const Stopwatch solution;
    const unsigned int n = iterations(stiffness, cycle, pressed_base(space, stiffness));
    std::cout << "dofs,contact_nodes,iterations,set_up_seconds,solve_seconds,peak_bytes\n"
              << space.n_dofs() << "," << space.contact_surface().nodes.size() << "," << n << ","
              << set_up_seconds << "," << solution.seconds() << "," << peak_memory() << "\n";
  }
  MPI_Finalize();
}
} // namespace orthocone::studies
