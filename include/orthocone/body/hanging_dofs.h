// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <vector>

namespace orthocone
{
/// Degrees of freedom that cannot move by themselves: those of nodes where a cell borders on smaller ones.
/// Their displacement is interpolated in the larger cell, as a sum over its nodes (docs/theory.md, section 2,
/// "Hanging nodes").
class HangingDofs
{
public:
  /// A degree of freedom that moves a hanging one, and the share of its displacement that the hanging one
  /// takes.
  struct Term
  {
    unsigned int dof;
    double weight;
  };
  using Terms = std::vector<Term>;

  HangingDofs() = default;

  /// `numbers` are the hanging ones of all `n_dofs` degrees of freedom, `sums` has one sum for each of them.
  /// No term may hang itself.
  HangingDofs(std::vector<unsigned int> numbers, std::vector<Terms> sums, const unsigned int n_dofs)
      : numbers_(std::move(numbers)),
        sums_(std::move(sums)),
        places_(n_dofs, none)
  {
    for (unsigned int i = 0; i < numbers_.size(); ++i)
      places_[numbers_[i]] = i;
  }

  bool empty() const { return sums_.empty(); }
  bool contains(const unsigned int dof) const { return !empty() && places_[dof] != none; }

  const std::vector<unsigned int> &numbers() const { return numbers_; } ///< of the hanging ones

  /// The sum of a hanging degree of freedom.
  const Terms &terms(const unsigned int dof) const { return sums_[places_[dof]]; }

  /// Sets the displacements of the hanging ones from those of the others; `displacement` has n_dofs numbers.
  void distribute(double *const displacement) const
  {
    for (std::size_t i = 0; i < sums_.size(); ++i)
    {
      double sum = 0;
      for (const Term &term : sums_[i])
        sum += term.weight * displacement[term.dof];
      displacement[numbers_[i]] = sum;
    }
  }

private:
  static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

  std::vector<unsigned int> numbers_;
  std::vector<Terms> sums_;
  std::vector<unsigned int> places_; ///< of each degree of freedom in these two
};

/// The degrees of freedom that move the nodes of a cell (`dofs`, none of which hangs), and the matrix that
/// maps their displacements to those of the cell's own ones (`basis`). The basis is empty where nothing of
/// the cell hangs.
template<typename Index>
struct CellBasis
{
  /// `of_cell` are the n degrees of freedom of a cell; `basis` becomes n x dofs.size(), without units.
  CellBasis(const HangingDofs &hanging, const std::vector<Index> &of_cell)
      : dofs(of_cell)
  {
    const auto hangs = [&](const Index dof) { return hanging.contains(dof); };
    if (std::none_of(of_cell.begin(), of_cell.end(), hangs))
      return;
    dofs.erase(std::remove_if(dofs.begin(), dofs.end(), hangs), dofs.end());
    basis.setZero(of_cell.size(), of_cell.size()); // with room for more
    for (std::size_t i = 0; i < of_cell.size(); ++i)
      if (!hangs(of_cell[i]))
        add(i, {static_cast<unsigned int>(of_cell[i]), 1});
      else
        for (const HangingDofs::Term &term : hanging.terms(of_cell[i]))
          add(i, term);
    basis.conservativeResize(Eigen::NoChange, dofs.size());
  }

  /// The cell's matrix, transformed to `dofs`.
  Eigen::MatrixXd reduced(const Eigen::MatrixXd &matrix) const
  {
    return basis.size() == 0 ? matrix : Eigen::MatrixXd(basis.transpose() * matrix * basis);
  }

  std::vector<Index> dofs;
  Eigen::MatrixXd basis;

private:
  void add(const std::size_t row, const HangingDofs::Term &term)
  {
    const auto found = std::find(dofs.begin(), dofs.end(), term.dof);
    const auto column = found - dofs.begin();
    if (found == dofs.end())
      dofs.push_back(term.dof);
    if (column >= basis.cols())
    {
      basis.conservativeResize(Eigen::NoChange, column + 1);
      basis.col(column).setZero();
    }
    basis(static_cast<Eigen::Index>(row), column) += term.weight;
  }
};
} // namespace orthocone
