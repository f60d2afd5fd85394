// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/scene.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
#include <orthocone/body/backends/half_space_body.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/multigrid/multigrid_body.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/body_shelf.h>
#include <orthocone/scene/change_length.h>
#include <orthocone/scene/contact_material.h>
#include <orthocone/scene/first_contact.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Checks gap and friction at the nodes of the scene. The model was chosen at other nodes where a search
/// takes the mesh: on smaller cells gap or friction may be undefined, or lack the symmetry of the model.
void check_fields(const Obstacle &obstacle, const FrictionField &friction, const ContactSurface &surface,
                  const ModelSymmetry &symmetry)
{
  const std::vector<SurfacePoint> points = points_of(surface);
  obstacle.check(points);
  friction.check(points);
  require_shallow_overlap(obstacle, surface);
  if (symmetry.name() == ModelSymmetry().name() && !symmetry.is_section())
    return; // the whole body
  const SurfaceSample sample{points, points};
  for (const std::string &why :
       {friction.asymmetry(symmetry, sample, obstacle), obstacle.asymmetry(symmetry, sample)})
    if (!why.empty())
      throw InputError(
          "Mesh/Model: on the nodes of a mesh with smaller cells the scene is not as symmetric as its " +
          symmetry.full_name() + " model: " + why + "; allowed is " +
          (symmetry.is_plane_strain() ? "Geometry/Kind = solid" : "Mesh/Model = full"));
}

/// Accuracy of solutions: well below the tolerance of the contact solver and the bound Checks/Equilibrium,
/// and above rounding.
double accuracy_of_solutions(const Parameters &parameters)
{
  constexpr double share = 1e-3, share_of_check = 0.1, least = 1e-12;
  return std::max(
      std::min(share * parameters.contact_solver.tolerance, share_of_check * parameters.checks.equilibrium),
      least);
}

std::shared_ptr<const ElasticBody> make_body(const Parameters &parameters, const ModelSymmetry &symmetry,
                                             const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                                             const std::function<void(const Body &)> &on_meshed,
                                             PhaseSeconds &seconds)
{
  if (!kind_of(parameters.geometry).is_meshed())
    return std::make_shared<const HalfSpaceBody>(parameters, axes_of, on_meshed, seconds);
  if (parameters.mesh.backend == BodyBackend::multigrid)
    return make_multigrid_body(parameters, symmetry, accuracy_of_solutions(parameters), axes_of, on_meshed,
                               seconds);
  return BodyShelf::of_process().body(parameters, symmetry, axes_of, on_meshed, seconds);
}

/// Where the body's surface stands along the normal, or looks away from the counterface, nothing presses on
/// it, and any area makes that no pressure.
VectorXd areas_pressed(const ContactSurface &surface, const LocalAxes &axes)
{
  constexpr double least = 1e-6;
  VectorXd areas(static_cast<Eigen::Index>(surface.nodes.size()));
  for (std::size_t node = 0; node < surface.nodes.size(); ++node)
  {
    const double area = surface.nodes[node].area,
                 pressed = surface.nodes[node].pressed_area(axes.normal(node));
    areas[static_cast<Eigen::Index>(node)] = pressed > least * area ? pressed : area;
  }
  return areas;
}

/// Null where the obstacle is not a body.
std::unique_ptr<const LowerBody> make_lower(const Parameters &parameters, const ModelSymmetry &symmetry,
                                            const ElasticBody &body, const LocalAxes &axes,
                                            PhaseSeconds &seconds)
{
  if (parameters.obstacle.kind != ObstacleKind::body)
    return nullptr;
  return std::make_unique<LowerBody>(parameters, symmetry, body.surface(), axes, seconds);
}

std::string text_of(const LocalAxes &axes, const std::size_t n_nodes)
{
  std::string text;
  for (std::size_t node = 0; node < n_nodes; ++node)
    for (const double number : axes.global_in_local(node).reshaped())
      text += " " + to_text(number);
  return text;
}

Eigen::MatrixXd compliance_of(const Obstacle &obstacle, const Parameters &parameters,
                              const ModelSymmetry &symmetry, const ContactSurface &surface,
                              const LocalAxes &axes)
{
  const auto make = [&] { return obstacle.compliance(surface, symmetry, axes); };
  const auto material = obstacle.material();
  if (!material)
    return make();
  return BodyShelf::of_process().compliance(
      [&]
      {
        return body_key(parameters, symmetry) + "on " + to_text(material->young_modulus) + ", " +
               to_text(material->poisson_ratio) + text_of(axes, surface.nodes.size());
      },
      make);
}

/// Of what gives way below a body that has neither a dense compliance nor its own way to add both.
std::unique_ptr<const Compliance> counterface_of(const ElasticBody &body, const Obstacle &obstacle,
                                                 const ModelSymmetry &symmetry, const LocalAxes &axes)
{
  if (!body.mesh().has_mesh() || body.compliance().dense() != nullptr)
    return nullptr;
  return obstacle.compliance_by_products(body.surface(), symmetry, axes);
}

/// Of the body and what is below it; null where the obstacle is rigid.
std::unique_ptr<const Compliance> sum_of(const ElasticBody &body, const Compliance *const counterface,
                                         const Obstacle &obstacle, const LowerBody *const lower,
                                         const Parameters &parameters, const ModelSymmetry &symmetry,
                                         const LocalAxes &axes)
{
  if (counterface)
    return body.compliance_above(*counterface);
  if (const auto material = obstacle.material())
    if (auto sum = body.compliance_on(*material))
      return sum;
  Eigen::MatrixXd of_obstacle =
      lower ? lower->compliance() : compliance_of(obstacle, parameters, symmetry, body.surface(), axes);
  if (of_obstacle.size() == 0)
    return nullptr;
  const DenseView *const of_body = body.compliance().dense();
  if (of_body == nullptr)
    throw std::logic_error("an obstacle that gives way needs a body with a dense compliance");
  of_obstacle += *of_body;
  return std::make_unique<DenseCompliance>(std::move(of_obstacle));
}

/// The motion of the components that motions drive, without the others.
RigidMotion driven_motion(const FaceTarget &target)
{
  RigidMotion motion;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    motion[i] = target.by_force[i] ? 0 : target.motion[i];
  return motion;
}

} // namespace

Scene::Scene(const Parameters &parameters, const ModelChoice &choice,
             const std::function<void(const Body &)> &on_meshed)
    : Scene(parameters, choice, *make_obstacle(parameters.obstacle), on_meshed)
{
}

Scene::Scene(const Parameters &parameters, const ModelChoice &choice, const Obstacle &obstacle,
             const std::function<void(const Body &)> &on_meshed)
    : parameters_(parameters),
      choice_(choice),
      program_(parameters.load),
      friction_(parameters.friction),
      body_(make_body(
          parameters, choice.symmetry,
          [&](const ContactSurface &on) { return friction_.axes(on, obstacle, choice.symmetry); },
          [&](const Body &meshed)
          {
            check_fields(obstacle, friction_, meshed.unknowns().contact_surface(), choice.symmetry);
            require_hold(parameters.geometry, meshed.unknowns(), choice.symmetry);
            if (on_meshed)
              on_meshed(meshed);
          },
          seconds_)),
      axes_(friction_.axes(surface(), obstacle, choice.symmetry)),
      pressed_areas_(areas_pressed(surface(), axes_)),
      lower_(make_lower(parameters, choice.symmetry, *body_, axes_, seconds_)),
      gaps_(gaps_of(obstacle, surface())),
      counterface_(timed(seconds_.condensation,
                         [&] { return counterface_of(*body_, obstacle, choice.symmetry, axes_); })),
      sum_(timed(seconds_.condensation,
                 [&] {
                   return sum_of(*body_, counterface_.get(), obstacle, lower_.get(), parameters,
                                 choice.symmetry, axes_);
                 })),
      system_(compliance(), friction_.laws(surface(), obstacle, choice.symmetry))
{
  if (lower_)
  {
    gaps_ += lower_->gaps();
    require_driven_overlap(parameters, gaps_(Eigen::seqN(0, system_.n_nodes(), 3)), surface());
  }
  part_overlap();
  if (friction_.varies() || !obstacle.is_plane())
    change_lengths_ = orthocone::change_lengths(obstacle, friction_, surface(), axes_);
}

/// Takes the negative gaps g out of gaps(), so that the gap is max(g, 0) + lambda min(g, 0) under an
/// interference lambda.
void Scene::part_overlap()
{
  const std::vector<Load> &loads = parameters_.load.loads;
  const auto found =
      std::find_if(loads.begin(), loads.end(), [](const Load &load) { return load.kind->drives_overlap(); });
  if (found == loads.end())
    return;
  interference_ = found - loads.begin();
  overlap_ = gaps_.cwiseMin(0);
  gaps_ = gaps_.cwiseMax(0);
}

double Scene::undeformed_gap(const Eigen::Index node, const VectorXd &loads) const
{
  const double gap = gaps_[3 * node];
  return interference_ && loads.size() > 0 ? gap + loads[*interference_] * overlap_[3 * node] : gap;
}

NodeVector Scene::given_way(const NodeVector &force) const
{
  NodeVector of_both = NodeVector::Zero(force.size());
  if (counterface_)
    counterface_->vmult(of_both, force);
  else if (sum_)
  {
    NodeVector of_body;
    sum_->vmult(of_both, force);
    body_->compliance().vmult(of_body, force);
    of_both -= of_body;
  }
  return of_both;
}

MaterialOptions Scene::contact_material() const
{
  return orthocone::contact_material(parameters_);
}

Wrench Scene::held_wrench(const NodeVector &force, const RigidMotion &motion, const VectorXd &loads) const
{
  const VectorXd conjugates = body_->conjugates(force, motion, loads);
  Wrench held;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    held[i] = symmetry().carries(i) ? static_cast<double>(symmetry().n_copies()) * conjugates[i] : 0;
  return held;
}

VectorXd Scene::load_conjugates(const NodeVector &force, const RigidMotion &motion,
                                const VectorXd &loads) const
{
  const Eigen::Index m = n_loads();
  VectorXd all = VectorXd::Zero(m);
  if (body_->driven() != nullptr)
    all += body_->conjugates(force, motion, loads).tail(m);
  if (lower_ && lower_->body().driven() != nullptr)
    all += lower_->body().conjugates(lower_->own_force(force), {}, loads).tail(m);
  if (interference_)
    all[*interference_] -= force.dot(overlap_);
  return symmetry().n_copies() * all;
}

VectorXd Scene::load_areas() const
{
  VectorXd all = VectorXd::Zero(n_loads());
  if (body_->driven() != nullptr)
    all += body_->driven()->areas;
  if (lower_ && lower_->body().driven() != nullptr)
    all += lower_->body().driven()->areas;
  return symmetry().n_copies() * all;
}

FaceState Scene::face_state(const NodeVector &force, const RigidMotion &motion, const VectorXd &loads) const
{
  FaceState face{motion, held_wrench(force, motion, loads), loads};
  const std::vector<Load> &all = parameters_.load.loads;
  if (all.empty())
    return face;
  const VectorXd conjugates = load_conjugates(force, motion, loads);
  face.loads = loads.size() > 0 ? loads : VectorXd(VectorXd::Zero(conjugates.size()));
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].kind->is_force_of_surface())
      face.loads[static_cast<Eigen::Index>(k)] = conjugates[static_cast<Eigen::Index>(k)];
  return face;
}

NodeVector Scene::driven_displacement(const RigidMotion &motion, const VectorXd &loads) const
{
  NodeVector moved = body_->moved_with(motion, loads);
  if (lower_ && lower_->body().driven() != nullptr)
    moved += lower_->parted(lower_->body().moved_with({}, loads));
  if (interference_ && loads.size() > 0)
    moved += loads[*interference_] * overlap_;
  return moved;
}

double Scene::elastic_energy(const NodeVector &force, const RigidMotion &motion, const VectorXd &loads) const
{
  NodeVector moved;
  compliance().vmult(moved, force);
  const unsigned int n_copies = symmetry().n_copies();
  double energy = 0.5 * n_copies * force.dot(moved) + n_copies * body_->driven_energy(force, motion, loads);
  if (lower_)
    energy += n_copies * lower_->body().driven_energy(lower_->own_force(force), {}, loads);
  return energy;
}

/// The loads of a target, without those that find the motion of their surface.
VectorXd Scene::given_loads(const FaceTarget &target) const
{
  VectorXd given = target.loads;
  for (Eigen::Index k = 0; k < given.size(); ++k)
    if (parameters_.load.loads[static_cast<std::size_t>(k)].kind->is_force_of_surface())
      given[k] = 0;
  return given;
}

NodeVector Scene::free_displacement(const FaceTarget &target) const
{
  return gaps_ + driven_displacement(driven_motion(target), given_loads(target));
}

bool Scene::is_loose(const unsigned int component) const
{
  const std::vector<unsigned int> &loose = body_->unknowns().loose_components();
  return std::find(loose.begin(), loose.end(), component) != loose.end();
}

std::vector<unsigned int> Scene::free_components(const FaceTarget &target) const
{
  std::vector<unsigned int> components;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    if ((target.by_force[i] && symmetry().leaves(i)) || is_loose(i))
      components.push_back(i);
  const std::vector<Load> &loads = parameters_.load.loads;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (loads[k].kind->is_force_of_surface())
      components.push_back(n_rigid_components + static_cast<unsigned int>(k));
  return components;
}

/// The displacement that a unit of a component drives, and the conjugates of all, of the whole scene's model.
std::pair<NodeVector, VectorXd> Scene::unit_answer(const unsigned int component) const
{
  RigidMotion motion;
  VectorXd loads = VectorXd::Zero(n_loads());
  if (component < n_rigid_components)
    motion[component] = 1;
  else
    loads[component - n_rigid_components] = 1;
  return {driven_displacement(motion, loads), conjugates(NodeVector::Zero(gaps_.size()), motion, loads)};
}

/// The wrench on the held face and the conjugates of the loads of the model, without its copies.
VectorXd Scene::conjugates(const NodeVector &force, const RigidMotion &motion, const VectorXd &loads) const
{
  VectorXd all(n_rigid_components + n_loads());
  all << body_->conjugates(force, motion, loads).head<n_rigid_components>(),
      load_conjugates(force, motion, loads) / symmetry().n_copies();
  return all;
}

FreeFace Scene::free_face(const FaceTarget &target) const
{
  const std::vector<unsigned int> components = free_components(target);
  const auto n = static_cast<Eigen::Index>(components.size());
  if (n == 0)
    return {};
  Eigen::MatrixXd columns(3 * system_.n_nodes(), n), stiffness(n, n);
  Eigen::VectorXd balance(n);
  const VectorXd of_given =
      conjugates(NodeVector::Zero(gaps_.size()), driven_motion(target), given_loads(target));
  for (Eigen::Index j = 0; j < n; ++j)
  {
    const auto [column, conjugates_of_unit] = unit_answer(components[j]);
    columns.col(j) = column;
    for (Eigen::Index i = 0; i < n; ++i)
      stiffness(i, j) = conjugates_of_unit[components[i]];
    const unsigned int i = components[j];
    const double force = i < n_rigid_components ? target.force[i] : target.loads[i - n_rigid_components];
    balance[j] = of_given[i] - force / symmetry().n_copies();
  }
  return FreeFace(columns, balance, stiffness);
}
} // namespace orthocone
