// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "level.h"

#include "node_values.h"

#include <utility>

namespace orthocone
{
using Eigen::Vector2f;

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

void Level::invert_blocks()
{
  blocks_.assign(relations_.size(), Eigen::Matrix2f::Zero());
  robin_.assign(relations_.size(), Eigen::Matrix2f::Zero());
  for (std::size_t i = 0; i < relations_.size(); ++i)
    if (nodes()[i].is_here() && relations_[i].hold == Hold::normal)
    {
      Eigen::Matrix2d block =
          bounded_robin(relations_[i], 1 / inverse_diagonal_.local_element(nodes()[i].dofs[2]));
      robin_[i] = block.cast<float>();
      for (unsigned int d = 0; d < 2; ++d)
        block(d, d) += nodes()[i].is_free[d] ? 1 / inverse_diagonal_.local_element(nodes()[i].dofs[d]) : 1;
      blocks_[i] = block.inverse().cast<float>();
    }
}

void Level::clear_held(Vector &vector) const
{
  for (unsigned int i = space_.n_free(); i < space_.n_owned(); ++i)
    vector.local_element(i) = 0;
  for (std::size_t i = 0; i < relations_.size(); ++i)
  {
    if (!nodes()[i].is_here() || relations_[i].hold == Hold::nothing)
      continue;
    vector.local_element(nodes()[i].dofs[2]) = 0;
    if (relations_[i].hold == Hold::all)
      set_tangential<float>(vector, nodes()[i], Vector2f::Zero());
  }
}

void Level::vmult(Vector &result, const Vector &vector) const
{
  stiffness_.vmult(result, vector);
  for (std::size_t i = 0; i < relations_.size(); ++i)
    if (nodes()[i].is_here() && relations_[i].hold == Hold::normal)
      add_tangential<float>(result, nodes()[i],
                            robin_[i] * tangential(vector, nodes()[i]) +
                                relations_[i].coupling.cast<float>() *
                                    result.local_element(nodes()[i].dofs[2]));
  clear_held(result);
}

void Level::Jacobi::vmult(Vector &result, const Vector &vector) const
{
  result = vector;
  result.scale(level_.inverse_diagonal_);
  for (std::size_t i = 0; i < level_.relations_.size(); ++i)
    if (level_.nodes()[i].is_here() && level_.relations_[i].hold == Hold::normal)
      set_tangential<float>(result, level_.nodes()[i],
                            level_.blocks_[i] * tangential(vector, level_.nodes()[i]));
  level_.clear_held(result);
}

void Level::smooth_from_zero(Vector &solution, const Vector &right_side) const
{
  smoother_.vmult(solution, right_side);
}

void Level::smooth(Vector &solution, const Vector &right_side) const
{
  smoother_.step(solution, right_side);
}
} // namespace orthocone
