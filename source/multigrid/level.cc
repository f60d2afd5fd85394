// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "level.h"

#include "relation_rows.h"

#include <utility>

namespace orthocone
{
// Chebyshev's polynomials in D^-1 K smooth what lies in the upper part of the spectrum, from a
// `smoothing_range`-th of the largest eigenvalue on (Adams, Brezina, Hu, Tuminaro, J. Comput. Phys. 188
// (2003) 593-610). They need products only, so that their result does not depend on the number of processes,
// as that of Gauss and Seidel's method would. Contact changes the blocks D of its nodes with every Newton
// step. The eigenvalues stay those of the free body: friction adds to K and to D alike, and holding only
// takes rows away.
Level::Level(const Discretization &space, const MaterialOptions &material)
    : space_(space),
      stiffness_(space, material),
      inverse_diagonal_(stiffness_.diagonal())
{
  for (unsigned int i = 0; i < space.n_free(); ++i)
    inverse_diagonal_.local_element(i) = 1 / inverse_diagonal_.local_element(i);
  decltype(smoother_)::AdditionalData options;
  // For contact: degree 3 is as good for the body alone (docs/performance.md, "Multigrid").
  options.degree = 5;
  options.smoothing_range = 25;
  options.eig_cg_n_iterations = 15;
  options.preconditioner = std::make_shared<Jacobi>(*this);
  smoother_.initialize(*this, options);
  smoother_.estimate_eigenvalues(make_vector()); // eigenvalues of the body without contact
}

void Level::hold(std::vector<NodeRelation> relations)
{
  relations_ = std::move(relations);
  invert_blocks();
}

/// D of a node that is held along its normal is the diagonal of K with the 2 x 2 block of friction. This
/// block is bounded by the stiffness (bounded_robin()), since a ray that friction hardly bends makes it as
/// large as one likes, and with it the eigenvalues that the smoother has been told.
void Level::invert_blocks()
{
  blocks_.assign(relations_.size(), Eigen::Matrix2f::Zero());
  robin_.assign(relations_.size(), Eigen::Matrix2f::Zero());
  const auto stiffness = [&](const unsigned int dof) { return 1 / inverse_diagonal_.local_element(dof); };
  const auto invert = [&](const std::size_t i)
  {
    const ContactNode &node = nodes()[i];
    Eigen::Matrix2d block = bounded_robin(relations_[i], stiffness(node.dofs[2]));
    robin_[i] = block.cast<float>();
    for (unsigned int d = 0; d < 2; ++d)
      block(d, d) += node.is_free[d] ? stiffness(node.dofs[d]) : 1;
    blocks_[i] = block.inverse().cast<float>();
  };
  RelationRows{nodes(), relations_}.for_resisting(invert);
}

void Level::clear_held(Vector &vector) const
{
  entries(vector, space_.n_owned()).tail(space_.n_owned() - space_.n_free()).setZero();
  RelationRows{nodes(), relations_}.clear_held(vector);
}

// K u, then for nodes that are held along their normal f_t + coupling f_z + robin u_t in place of f_t, where
// f = K u is what the body asks of contact: NodeRelation.
void Level::vmult(Vector &result, const Vector &vector) const
{
  stiffness_.vmult(result, vector);
  const auto resist = [&](const std::size_t i)
  {
    const float normal = result.local_element(nodes()[i].dofs[2]);
    add_tangential<float>(result, nodes()[i],
                          robin_[i] * tangential(vector, nodes()[i]) +
                              relations_[i].coupling.cast<float>() * normal);
  };
  RelationRows{nodes(), relations_}.for_resisting(resist);
  clear_held(result);
}

void Level::Jacobi::vmult(Vector &result, const Vector &vector) const
{
  result = vector;
  result.scale(level_.inverse_diagonal_);
  const auto divide = [&](const std::size_t i)
  {
    const ContactNode &node = level_.nodes()[i];
    set_tangential<float>(result, node, level_.blocks_[i] * tangential(vector, node));
  };
  RelationRows{level_.nodes(), level_.relations_}.for_resisting(divide);
  level_.clear_held(result);
}

// From zero the first of the smoother's products is saved: K u is known to vanish.
void Level::smooth_from_zero(Vector &solution, const Vector &right_side) const
{
  smoother_.vmult(solution, right_side);
}

// Behind the correction the smoother goes on from where the cycle is, with the same polynomial.
void Level::smooth(Vector &solution, const Vector &right_side) const
{
  smoother_.step(solution, right_side);
}
} // namespace orthocone
