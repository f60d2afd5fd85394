// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Frictional contact of an elastic body with a rigid plane, where friction is orthotropic and the slip rule
// is not tied to the friction cone. README.md has the equations, the results and how to run the program.

// @sect3{Include files}
//
// Everything is part of deal.II. The direct solver UMFPACK and the dense matrices are in <code>lac</code>,
// and the parameters of the program are read by the ParameterAcceptor class that step-60 and step-70 use.
#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/utilities.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace OrthotropicFriction
{
using namespace dealii;

// @sect3{Parameters}
//
// These are all numbers that a user may want to change. The defaults are those of the cylinder of the README.
// Lengths are in mm, forces in N and stresses in MPa. ParameterAcceptor::initialize() writes a file that does
// not exist with these defaults, which is the quickest way to see all names.
struct Parameters : public ParameterAcceptor
{
  Parameters();
  void check() const;

  bool is_axisymmetric() const { return section == "axisymmetric"; }

  std::string section = "axisymmetric";
  double width = 10.;
  double height = 10.;
  double thickness = 1.;
  double curvature = 0.;
  unsigned int n_columns = 16;
  unsigned int n_layers = 8;

  double young_modulus = 210000.;
  double poisson_ratio = 0.3;

  std::vector<double> friction = {0.2, 0.2};
  std::vector<double> slip_potential = {1., 1.};

  std::vector<double> plate_x = {0., 0.};
  std::vector<double> plate_y = {0., 0.};
  std::vector<double> plate_z = {-0.1, 0.};
  std::vector<unsigned int> n_steps = {5, 10};

  double tolerance = 1e-11;
  unsigned int n_sweeps = 200000;
};

Parameters::Parameters()
    : ParameterAcceptor("Orthotropic friction")
{
  enter_subsection("Body");
  add_parameter("Section", section, "axisymmetric: x is the radius; plane strain: all is the same along y",
                prm, Patterns::Selection("axisymmetric|plane strain"));
  add_parameter("Width", width, "Radius of the cylinder or width of the block, mm", prm, Patterns::Double(0));
  add_parameter("Height", height, "mm", prm, Patterns::Double(0));
  add_parameter("Thickness", thickness, "Length of the block along y, mm", prm, Patterns::Double(0));
  add_parameter("Curvature", curvature, "c of the gap c x^2 / 2 below the body, 1/mm", prm,
                Patterns::Double(0));
  add_parameter("Columns", n_columns, "Cells along x", prm, Patterns::Integer(1));
  add_parameter("Layers", n_layers, "Cells along z", prm, Patterns::Integer(1));
  add_parameter("Young modulus", young_modulus, "MPa", prm, Patterns::Double(0));
  add_parameter("Poisson ratio", poisson_ratio, "", prm, Patterns::Double(-0.99, 0.49));
  leave_subsection();

  enter_subsection("Friction");
  add_parameter("Coefficients", friction, "mu_x, mu_y: semi-axes of the friction ellipse");
  add_parameter("Slip potential", slip_potential,
                "p_x, p_y: semi-axes of the slip ellipse, of any common length");
  leave_subsection();

  enter_subsection("Motion of the plate");
  add_parameter("x", plate_x, "Displacements along x at the ends of the legs, mm");
  add_parameter("y", plate_y, "Displacements along y at the ends of the legs, mm");
  add_parameter("z", plate_z, "Displacements along z at the ends of the legs, mm");
  add_parameter("Load steps", n_steps, "Number of equal load steps in each leg");
  leave_subsection();

  enter_subsection("Solver");
  add_parameter("Tolerance", tolerance, "Largest residual, relative to the largest force", prm,
                Patterns::Double(0));
  add_parameter("Sweeps", n_sweeps, "Most sweeps for a load step", prm, Patterns::Integer(1));
  leave_subsection();
}

// What the patterns above cannot express is checked here, because a wrong length of a list would otherwise
// show as a wrong result.
void Parameters::check() const
{
  AssertThrow(width > 0 && height > 0 && thickness > 0,
              ExcMessage("Width, Height and Thickness must be > 0"));
  AssertThrow(young_modulus > 0, ExcMessage("Young modulus must be > 0"));
  for (const std::vector<double> &axes : {friction, slip_potential})
    AssertThrow(axes.size() == 2 && axes[0] > 0 && axes[1] > 0,
                ExcMessage("Coefficients and Slip potential must have two numbers > 0"));
  for (const std::vector<double> &ends : {plate_x, plate_y, plate_z})
    AssertThrow(ends.size() == n_steps.size(),
                ExcMessage("x, y and z of the plate need one number for each leg that Load steps names"));
  const auto is_zero = [](const double end) { return end == 0; };
  AssertThrow(!is_axisymmetric() || (std::all_of(plate_x.begin(), plate_x.end(), is_zero) &&
                                     std::all_of(plate_y.begin(), plate_y.end(), is_zero)),
              ExcMessage("The plate of an axisymmetric body moves along z only"));
}

// @sect3{The friction law}
//
// Forces and displacements of a contact point have three components: 0 is the normal one, 1 and 2 are those
// along the axes x and y of friction. The law has two operations. One is the modified displacement
// @f[
//   G(\mathbf d) = (d_n + \|Q^2 \mathbf d_t\|_\mu^*,\; Q^2 \mathbf d_t), \qquad
//   Q = \mathrm{diag}(p_x/\mu_x, p_y/\mu_y),
// @f]
// and the other the projection on the cone. Only the ratio of $p_x$ and $p_y$ means anything, so that we are
// free to scale $Q^2$: its larger entry is 1 here, which keeps the step size of the iteration meaningful.
class FrictionLaw
{
public:
  FrictionLaw(const std::vector<double> &friction, const std::vector<double> &slip_potential);

  Tensor<1, 3> modified(const Tensor<1, 3> &displacement) const;
  Tensor<1, 3> project(const Tensor<1, 3> &force) const;

  // The norm $\|\mathbf r_t\|_\mu$, which is less than $r_n$ where a point sticks and equals it where it
  // slips.
  double load(const Tensor<1, 3> &force) const { return std::hypot(force[1] / mu[0], force[2] / mu[1]); }

private:
  double multiplier(const Tensor<1, 3> &force) const;
  double dual_norm(const Tensor<1, 3> &v) const { return std::hypot(mu[0] * v[1], mu[1] * v[2]); }

  std::array<double, 2> mu;
  std::array<double, 2> q_squared;
};

FrictionLaw::FrictionLaw(const std::vector<double> &friction, const std::vector<double> &slip_potential)
    : mu{{friction[0], friction[1]}}
{
  for (unsigned int i = 0; i < 2; ++i)
    q_squared[i] = Utilities::fixed_power<2>(slip_potential[i] / friction[i]);
  const double largest = std::max(q_squared[0], q_squared[1]);
  for (double &entry : q_squared)
    entry /= largest;
}

Tensor<1, 3> FrictionLaw::modified(const Tensor<1, 3> &displacement) const
{
  Tensor<1, 3> result = displacement;
  result[1] *= q_squared[0];
  result[2] *= q_squared[1];
  result[0] += dual_norm(result);
  return result;
}

// The nearest point of the cone $\|\mathbf r_t\|_\mu \le r_n$. A force inside is its own nearest point, and
// for a force in the polar cone the nearest point is the apex. Otherwise the conditions of Karush, Kuhn and
// Tucker give the three components as functions of a multiplier $\lambda > 0$.
Tensor<1, 3> FrictionLaw::project(const Tensor<1, 3> &force) const
{
  if (load(force) <= force[0])
    return force;
  if (dual_norm(force) <= -force[0])
    return Tensor<1, 3>();
  const double lambda = multiplier(force);
  Tensor<1, 3> nearest;
  for (unsigned int i = 0; i < 2; ++i)
    nearest[i + 1] = force[i + 1] / (1 + lambda / (mu[i] * mu[i]));
  nearest[0] = load(nearest);
  return nearest;
}

// These functions are
// @f[
//   r_i = \frac{\tau_i}{1 + \lambda/\mu_i^2}, \qquad r_n = \|\mathbf r_t\|_\mu =: N(\lambda), \qquad
//   N(\lambda)\,(1 - \lambda) = \tau_n,
// @f]
// where $\tau$ is the given force, and the last one determines $\lambda$: its left side decreases, so that
// there is one root. We divide by $N$ because $1/N$ is linear in $\lambda$ if the cone is circular, so that
// Newton's method needs one step then, and a few steps for an ellipse. A bracket makes the method safe: a
// step that would leave the bracket is replaced by its half.
double FrictionLaw::multiplier(const Tensor<1, 3> &force) const
{
  const std::array<double, 2> a{{force[1] * mu[0], force[2] * mu[1]}};
  const std::array<double, 2> b{{mu[0] * mu[0], mu[1] * mu[1]}};
  const auto n = [&](const double lambda)
  { return std::hypot(a[0] / (b[0] + lambda), a[1] / (b[1] + lambda)); };
  double below = 0, above = 1;
  while (n(above) * (1 - above) > force[0])
    above *= 2;

  double lambda = below;
  for (unsigned int iteration = 0; iteration < 100; ++iteration)
  {
    const double value = 1 - lambda - force[0] / n(lambda);
    (value > 0 ? below : above) = lambda;
    double n_times_slope_of_n = 0;
    for (unsigned int i = 0; i < 2; ++i)
      n_times_slope_of_n -= a[i] * a[i] / Utilities::fixed_power<3>(b[i] + lambda);
    const double slope = -1 + force[0] * n_times_slope_of_n / Utilities::fixed_power<3>(n(lambda));
    double next = lambda - value / slope;
    if (!(next > below && next < above))
      next = 0.5 * (below + above);
    const double step = next - lambda;
    lambda = next;
    if (std::abs(step) <= 1e-15 * (std::min(b[0], b[1]) + lambda))
      break;
  }
  return lambda;
}

// @sect3{The contact points}
//
// Contact is enforced at points of the base. A point knows its place, the area that it stands for, its gap,
// and for each local direction the row of the matrix $B$ that gives its displacement from the degrees of
// freedom. A row has a single entry 1 if the point is a node of the finite element.
struct ContactPoint
{
  double x = 0;
  double area = 0;
  double gap = 0;
  std::array<std::vector<std::pair<types::global_dof_index, double>>, 3> rows;
};

// @sect3{The main class}
//
// The elastic problem is assembled and factorized once and condensed to the contact points. After that, the
// load steps only see the small dense matrix $W$.
class FrictionalContact
{
public:
  explicit FrictionalContact(const Parameters &given);
  void run();

private:
  void make_mesh();
  void setup_system();
  SymmetricTensor<2, 3> strain(const FEValues<2> &fe_values, unsigned int i, unsigned int q) const;
  double measure(double x) const;
  void assemble_stiffness();
  void add_points_of_face(const DoFHandler<2>::active_cell_iterator &cell, unsigned int face);
  void find_contact_points();
  void condense();

  Tensor<1, 3> displacement(unsigned int point) const;
  Tensor<1, 3> corrected_force(unsigned int point) const;
  double residual() const;
  unsigned int solve_load_step();
  void advance();

  std::string status(unsigned int point) const;
  void write_volume(unsigned int step) const;
  void write_contact(unsigned int step);
  void write_history(unsigned int step, unsigned int n_sweeps);

  const Parameters &parameters;
  const FrictionLaw law;

  Triangulation<2> triangulation;
  const FESystem<2> fe;
  DoFHandler<2> dof_handler;
  AffineConstraints<double> constraints;
  SparsityPattern sparsity_pattern;
  SparseMatrix<double> stiffness;
  SparseDirectUMFPACK factorized;

  // The contact problem consists of the matrix $W$, and for each point its step size $\rho$, the displacement
  // without contact forces, the force, and the tangential displacement at the end of the last load step.
  std::vector<ContactPoint> points;
  FullMatrix<double> compliance;
  std::vector<double> rho;
  std::vector<Tensor<1, 3>> free_displacement;
  std::vector<Tensor<1, 3>> force;
  std::vector<Tensor<1, 3>> last_slip;

  Tensor<1, 3> plate;
  double largest_force = 0;
  double largest_residual = 0;
  std::ofstream contact_file;
  std::ofstream history_file;
};

// The displacement has three components on a two-dimensional mesh, because friction acts along y, too, where
// it is orthotropic. Their order is x, z, y: deal.II and ParaView take the first two for a vector of the
// plane.
constexpr unsigned int degree = 2;
constexpr unsigned int x_component = 0, z_component = 1, y_component = 2;
constexpr std::array<unsigned int, 3> component_of = {{z_component, x_component, y_component}};
constexpr types::boundary_id left_id = 0, base_id = 2, top_id = 3; // those of GridGenerator's colors

FrictionalContact::FrictionalContact(const Parameters &given)
    : parameters(given),
      law(given.friction, given.slip_potential),
      fe(FE_Q<2>(degree), 3),
      dof_handler(triangulation),
      contact_file("contact.csv"),
      history_file("history.csv")
{
  contact_file
      << std::setprecision(12)
      << "step,x,area,status,gap,slip_x,slip_y,force_n,force_x,force_y,pressure,traction_x,traction_y\n";
  history_file << std::setprecision(12)
               << "step,ux,uy,uz,force_x,force_y,force_z,max_slip,n_open,n_stick,n_slip,sweeps,residual\n";
}

// @sect3{The elastic body}
//
// The mesh is that of a rectangle. For the cylinder x is the radius and starts at the axis, whereas the block
// is centered.
void FrictionalContact::make_mesh()
{
  const double left = parameters.is_axisymmetric() ? 0. : -0.5 * parameters.width;
  const std::vector<unsigned int> n_cells = {parameters.n_columns, parameters.n_layers};
  constexpr bool colorize = true;
  GridGenerator::subdivided_hyper_rectangle(triangulation, n_cells, Point<2>(left, 0.),
                                            Point<2>(left + parameters.width, parameters.height), colorize);
}

// The plate on top moves as a rigid body. We do not prescribe its motion here but hold it at zero, because
// nothing else holds the body: without contact forces the body would simply follow the plate, and
// displacements that contact forces cause are relative to it. On the axis of the cylinder the radial
// displacement and the one around the axis are zero.
void FrictionalContact::setup_system()
{
  dof_handler.distribute_dofs(fe);
  const Functions::ZeroFunction<2> zero(3);
  VectorTools::interpolate_boundary_values(dof_handler, top_id, zero, constraints);
  if (parameters.is_axisymmetric())
  {
    ComponentMask radial_and_around(3, true);
    radial_and_around.set(z_component, false);
    VectorTools::interpolate_boundary_values(dof_handler, left_id, zero, constraints, radial_and_around);
  }
  constraints.close();

  DynamicSparsityPattern pattern(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false);
  sparsity_pattern.copy_from(pattern);
  stiffness.reinit(sparsity_pattern);
}

// The strain of a shape function is a tensor in space, with the directions x, y, z in this order. In plane
// strain derivatives with respect to y vanish. In the cylinder y is the direction around the axis: a radial
// displacement stretches circles, and the displacement around the axis causes no strain where it grows with
// the radius.
SymmetricTensor<2, 3> FrictionalContact::strain(const FEValues<2> &fe_values, const unsigned int i,
                                                const unsigned int q) const
{
  SymmetricTensor<2, 3> strain;
  const Tensor<1, 2> gradient = fe_values.shape_grad(i, q);
  const double over_radius =
      parameters.is_axisymmetric() ? fe_values.shape_value(i, q) / fe_values.quadrature_point(q)[0] : 0.;
  switch (fe.system_to_component_index(i).first)
  {
  case x_component:
    strain[0][0] = gradient[0];
    strain[1][1] = over_radius;
    strain[0][2] = 0.5 * gradient[1];
    break;
  case z_component:
    strain[2][2] = gradient[1];
    strain[0][2] = 0.5 * gradient[0];
    break;
  default:
    strain[0][1] = 0.5 * (gradient[0] - over_radius);
    strain[1][2] = 0.5 * gradient[1];
  }
  return strain;
}

// A point of the section stands for a length along y: the circle around the axis, or the thickness.
double FrictionalContact::measure(const double x) const
{
  return parameters.is_axisymmetric() ? 2. * numbers::PI * x : parameters.thickness;
}

void FrictionalContact::assemble_stiffness()
{
  const double shear_modulus = parameters.young_modulus / (2. * (1. + parameters.poisson_ratio));
  const double lambda = 2. * shear_modulus * parameters.poisson_ratio / (1. - 2. * parameters.poisson_ratio);
  const SymmetricTensor<4, 3> elasticity =
      lambda * outer_product(unit_symmetric_tensor<3>(), unit_symmetric_tensor<3>()) +
      2. * shear_modulus * identity_tensor<3>();

  const QGauss<2> quadrature(degree + 1);
  FEValues<2> fe_values(fe, quadrature,
                        update_values | update_gradients | update_quadrature_points | update_JxW_values);
  const unsigned int n_dofs = fe.n_dofs_per_cell();
  FullMatrix<double> cell_matrix(n_dofs, n_dofs);
  std::vector<types::global_dof_index> dof_indices(n_dofs);
  std::vector<SymmetricTensor<2, 3>> strains(n_dofs);

  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    fe_values.reinit(cell);
    cell_matrix = 0;
    for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      for (const unsigned int i : fe_values.dof_indices())
        strains[i] = strain(fe_values, i, q);
      const double weight = fe_values.JxW(q) * measure(fe_values.quadrature_point(q)[0]);
      for (const unsigned int i : fe_values.dof_indices())
      {
        const SymmetricTensor<2, 3> stress = elasticity * strains[i];
        for (const unsigned int j : fe_values.dof_indices())
          cell_matrix(i, j) += weight * (stress * strains[j]);
      }
    }
    cell->get_dof_indices(dof_indices);
    constraints.distribute_local_to_global(cell_matrix, dof_indices, stiffness);
  }
}

// @sect3{From the body to the contact points}
//
// The nodes of an element are good contact points, because a uniform pressure causes positive forces at all
// of them. Only on the axis this fails: integrals have the factor $r$ there, so that Simpson's rule gives the
// node on the axis no weight at all, and its force may pull where the pressure is positive. The three points
// at 0, 0.6 and 1 of the width of that cell have the weights 1/36, 25/72 and 1/8 (times $2\pi$ and the square
// of the width). These are positive, and integrate $r$ times a polynomial of degree three exactly, as
// Simpson's rule does without the factor. We therefore take these points, and this is why $B$ has rows with
// several entries.
void FrictionalContact::add_points_of_face(const DoFHandler<2>::active_cell_iterator &cell,
                                           const unsigned int face)
{
  const double begin = cell->face(face)->vertex(0)[0];
  const double length = cell->face(face)->vertex(1)[0] - begin;
  const bool is_on_axis = parameters.is_axisymmetric() && begin == 0.;
  const std::vector<Point<1>> places = {Point<1>(0.), Point<1>(is_on_axis ? 0.6 : 0.5), Point<1>(1.)};
  FEFaceValues<2> values(fe, Quadrature<1>(places), update_values);
  values.reinit(cell, face);
  std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_cell());
  cell->get_dof_indices(dof_indices);
  const auto shares = Polynomials::generate_complete_Lagrange_basis(places);
  const QGauss<1> quadrature(degree + 1);

  for (unsigned int k = 0; k < places.size(); ++k)
  {
    // Cells come from left to right, and so do their points. The first point of a face is the last one of
    // the face before, which is complete but for its area.
    if (k > 0 || points.empty())
    {
      points.emplace_back();
      points.back().x = begin + length * places[k][0];
      points.back().gap = 0.5 * parameters.curvature * Utilities::fixed_power<2>(points.back().x);
      for (unsigned int c = 0; c < 3; ++c)
        for (const unsigned int i : values.dof_indices())
          if (fe.system_to_component_index(i).first == component_of[c] &&
              std::abs(values.shape_value(i, k)) > 1e-12)
            points.back().rows[c].emplace_back(dof_indices[i], values.shape_value(i, k));
    }
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double place = quadrature.point(q)[0];
      points.back().area +=
          quadrature.weight(q) * length * shares[k].value(place) * measure(begin + length * place);
    }
  }
}

void FrictionalContact::find_contact_points()
{
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == base_id)
        add_points_of_face(cell, face);
  force.resize(points.size());
  free_displacement.resize(points.size());
  last_slip.resize(points.size());
}

// Column by column, $W = B K^{-1} B^T$: a unit force at a contact point in one of its directions is a right
// hand side, and the solution is read at all contact points. The factorization serves all of them. The force
// that would act on a held degree of freedom is carried by whatever holds it, and is therefore left out.
void FrictionalContact::condense()
{
  factorized.initialize(stiffness);
  compliance.reinit(3 * points.size(), 3 * points.size());
  Vector<double> unit_force(dof_handler.n_dofs()), solution(dof_handler.n_dofs());
  for (unsigned int column = 0; column < compliance.n(); ++column)
  {
    unit_force = 0;
    for (const auto &[dof, value] : points[column / 3].rows[column % 3])
      unit_force[dof] += value;
    constraints.set_zero(unit_force);
    factorized.vmult(solution, unit_force);
    for (unsigned int row = 0; row < compliance.m(); ++row)
      for (const auto &[dof, value] : points[row / 3].rows[row % 3])
        compliance(row, column) += value * solution[dof];
  }

  // The step size of a point. The paper takes the inverse of the smallest of the three entries, which
  // multiplies the error of a sticking point by $1 - w_{\max}/w_{\min}$: it cycles where the entries differ
  // by more than a factor of two, and the radial one is zero on the axis. With the inverse of the largest
  // entry the error of a point always shrinks.
  for (unsigned int i = 0; i < points.size(); ++i)
    rho.push_back(1. / std::max({compliance(3 * i, 3 * i), compliance(3 * i + 1, 3 * i + 1),
                                 compliance(3 * i + 2, 3 * i + 2)}));
}

// @sect3{A load step}
//
// The law decides from the displacement of a point relative to the plane: its gap, and its slip since the
// last load step.
Tensor<1, 3> FrictionalContact::displacement(const unsigned int point) const
{
  Tensor<1, 3> result = free_displacement[point];
  for (unsigned int j = 0; j < points.size(); ++j)
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int k = 0; k < 3; ++k)
        result[c] += compliance(3 * point + c, 3 * j + k) * force[j][k];
  return result;
}

// This is the prediction and its correction. Forces are a solution if and only if this function returns all
// of them unchanged.
Tensor<1, 3> FrictionalContact::corrected_force(const unsigned int point) const
{
  return law.project(force[point] - rho[point] * law.modified(displacement(point)));
}

// The residual says by how much the function above changes the forces, relative to the largest force of the
// run so far. At the end of an unloading all forces are zero, and only the forces before tell what is small.
double FrictionalContact::residual() const
{
  double change = 0, scale = largest_force;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    change = std::max(change, (corrected_force(i) - force[i]).norm());
    scale = std::max(scale, force[i].norm());
  }
  return change == 0 ? 0 : change / scale;
}

// Sweeps over the points until the residual is small. A point sees the new forces of the points before it
// in the same sweep, as in the method of Gauss and Seidel. With the old forces of all points, as the name of
// Uzawa suggests, the iteration diverges unless $\rho$ is less than twice the inverse of the largest
// eigenvalue of the whole matrix $W$. The iteration starts from the forces of the last load step.
unsigned int FrictionalContact::solve_load_step()
{
  constexpr unsigned int sweeps_between_checks = 10;
  for (unsigned int sweep = 1; sweep <= parameters.n_sweeps; ++sweep)
  {
    for (unsigned int i = 0; i < points.size(); ++i)
      force[i] = corrected_force(i);
    if (sweep % sweeps_between_checks == 0 && residual() <= parameters.tolerance)
      return sweep;
  }
  AssertThrow(
      false,
      ExcMessage("The residual is " + std::to_string(residual()) + " after " +
                 std::to_string(parameters.n_sweeps) +
                 " sweeps; take smaller load steps, or a slip ellipse closer to the friction ellipse"));
  return 0;
}

// Friction remembers one thing only: where the points are now, because their next slip counts from there.
void FrictionalContact::advance()
{
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    largest_force = std::max(largest_force, force[i].norm());
    const Tensor<1, 3> now = displacement(i);
    for (unsigned int c = 1; c < 3; ++c)
      last_slip[i][c] += now[c];
  }
}

// @sect3{Output}
//
// The displacement of the body is the motion of the plate plus what the contact forces cause, for which the
// factorization is at hand. Quadratic cells show the quadratic displacement. The picture is in the plane
// (x, z), so that the displacement along y is a scalar.
void FrictionalContact::write_volume(const unsigned int step) const
{
  Vector<double> forces(dof_handler.n_dofs()), solution(dof_handler.n_dofs());
  for (unsigned int i = 0; i < points.size(); ++i)
    for (unsigned int c = 0; c < 3; ++c)
      for (const auto &[dof, value] : points[i].rows[c])
        forces[dof] += value * force[i][c];
  constraints.set_zero(forces);
  factorized.vmult(solution, forces);
  Vector<double> motion(dof_handler.n_dofs());
  Functions::ConstantFunction<2> rigid(std::vector<double>{plate[1], plate[0], plate[2]});
  VectorTools::interpolate(dof_handler, rigid, motion);
  solution += motion;

  const auto vector = DataComponentInterpretation::component_is_part_of_vector;
  DataOut<2> data_out;
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true;
  data_out.set_flags(flags);
  data_out.add_data_vector(dof_handler, solution, {"displacement", "displacement", "displacement_y"},
                           {vector, vector, DataComponentInterpretation::component_is_scalar});
  data_out.build_patches(degree);
  std::ofstream file("volume-" + Utilities::int_to_string(step, 4) + ".vtu");
  data_out.write_vtu(file);
}

// The table of contact points has one row for each point and load step. Forces are those of the plane on the
// body.
void FrictionalContact::write_contact(const unsigned int step)
{
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    contact_file << step << ',' << points[i].x << ',' << points[i].area << ',' << status(i) << ','
                 << displacement(i)[0] << ',' << last_slip[i][1] << ',' << last_slip[i][2];
    for (unsigned int c = 0; c < 3; ++c)
      contact_file << ',' << force[i][c];
    for (unsigned int c = 0; c < 3; ++c)
      contact_file << ',' << force[i][c] / points[i].area;
    contact_file << '\n';
  }
}

// A point whose force is not at the apex is in contact, and slips if its force is on the cone. The projection
// reaches both up to rounding.
std::string FrictionalContact::status(const unsigned int point) const
{
  if (force[point][0] == 0)
    return "open";
  return law.load(force[point]) < (1 - 1e-10) * force[point][0] ? "stick" : "slip";
}

// The history has one row for each load step, in the file and, shorter, on the screen. The radial and the
// hoop forces of the cylinder are those of whole rings, so that their sums are no forces on the body.
void FrictionalContact::write_history(const unsigned int step, const unsigned int n_sweeps)
{
  Tensor<1, 3> total;
  double max_slip = 0;
  std::map<std::string, unsigned int> n_points;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    total += force[i];
    ++n_points[status(i)];
    if (status(i) != "open")
      max_slip = std::max(max_slip, last_slip[i].norm());
  }
  const double remaining = residual();
  largest_residual = std::max(largest_residual, remaining);
  history_file << step << ',' << plate[1] << ',' << plate[2] << ',' << plate[0] << ',' << total[1] << ','
               << total[2] << ',' << total[0] << ',' << max_slip << ',' << n_points["open"] << ','
               << n_points["stick"] << ',' << n_points["slip"] << ',' << n_sweeps << ',' << remaining << '\n';
  std::cout << std::setw(5) << step << std::setw(14) << total[0] << std::setw(14) << total[1] << std::setw(14)
            << total[2] << std::setw(14) << max_slip << std::setw(6) << n_points["open"] << std::setw(6)
            << n_points["stick"] << std::setw(6) << n_points["slip"] << std::setw(8) << n_sweeps << std::endl;
}

// @sect3{The run}
//
// Elasticity comes first. Then the plate goes through its legs in equal steps, and each step gets the
// free displacements of all points, which is all that a step needs to know.
void FrictionalContact::run()
{
  make_mesh();
  setup_system();
  assemble_stiffness();
  find_contact_points();
  condense();
  std::cout << dof_handler.n_dofs() << " degrees of freedom, " << points.size() << " contact points\n"
            << " step       force_n       force_x       force_y      max_slip  open stick  slip  sweeps"
            << std::endl;

  unsigned int step = 0;
  Tensor<1, 3> begin;
  for (unsigned int leg = 0; leg < parameters.n_steps.size(); ++leg)
  {
    const Tensor<1, 3> end({parameters.plate_z[leg], parameters.plate_x[leg], parameters.plate_y[leg]});
    for (unsigned int part = 1; part <= parameters.n_steps[leg]; ++part)
    {
      ++step;
      plate = begin + (static_cast<double>(part) / parameters.n_steps[leg]) * (end - begin);
      for (unsigned int i = 0; i < points.size(); ++i)
      {
        free_displacement[i] = plate - last_slip[i];
        free_displacement[i][0] += points[i].gap;
      }
      const unsigned int n_sweeps = solve_load_step();
      advance();
      write_history(step, n_sweeps);
      write_contact(step);
      write_volume(step);
    }
    begin = end;
  }
  std::cout << "largest residual: " << largest_residual << std::endl;
}
} // namespace OrthotropicFriction

// @sect3{The main function}
//
// The only argument is the name of the parameter file.
int main(int argc, char *argv[])
{
  try
  {
    OrthotropicFriction::Parameters parameters;
    dealii::ParameterAcceptor::initialize(argc > 1 ? argv[1] : "cylinder.prm");
    parameters.check();
    OrthotropicFriction::FrictionalContact(parameters).run();
  }
  catch (const std::exception &error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
