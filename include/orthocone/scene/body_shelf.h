// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/factorized_body.h>

#include <functional>
#include <list>
#include <memory>
#include <string>

namespace orthocone
{
/// All that a factorized body depends on, but its local axes: the texts of all entries of a body and of its
/// loads, the content of the files that they name, and the symmetry of the model. A body that is made of
/// BodyOptions cannot depend on friction, gap, load steps, tolerances or output. Throws FileError for a file
/// that cannot be read.
std::string body_key(const BodyOptions &options, const ModelSymmetry &symmetry);

/// Factorized bodies that scenes take instead of making the same ones again. Mesh, factor and condensed
/// compliance are most of the work of a small run, and many runs have the same ones. What scenes take has the
/// same bits as what they would have made. The shelf is empty unless somebody collects, and then a scene
/// makes its bodies as if there were no shelf. It is for one thread only.
class BodyShelf
{
public:
  /// The shelf of this process, which processes inherit that it forks.
  static BodyShelf &of_process();

  /// Bodies that scenes make from now on are kept, under a name of the caller; "" ends that.
  void collect(const std::string &name) { name_ = name; }

  /// Forgets the bodies of this name. Scenes that have them keep them.
  void drop(const std::string &name);

  bool is_empty() const { return kept_.empty(); }

  /// A body of the shelf, or a new one. The arguments are those of FactorizedBody, and `on_meshed` is called
  /// in both cases. Throws what FactorizedBody and body_key() throw.
  std::shared_ptr<const FactorizedBody> body(const BodyOptions &options, const ModelSymmetry &symmetry,
                                             const std::function<LocalAxes(const ContactSurface &)> &axes_of,
                                             const std::function<void(const Body &)> &on_meshed,
                                             PhaseSeconds &seconds);

  /// The compliance of what a body of the shelf is pressed on, or a new one by `make`. `key` has all that it
  /// depends on.
  Eigen::MatrixXd compliance(const std::function<std::string()> &key,
                             const std::function<Eigen::MatrixXd()> &make);

private:
  using Shared = std::shared_ptr<const FactorizedBody>;
  struct Kept
  {
    std::string name, key;
    Shared body;
  };
  struct KeptCompliance
  {
    std::string name, key;
    Eigen::MatrixXd matrix;
  };
  Shared find(const std::string &key) const;

  std::list<Kept> kept_{};
  std::list<KeptCompliance> compliances_{};
  std::string name_{};
};
} // namespace orthocone
