// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// A dense compliance whose conditions are solved by elimination in double precision, however many they are:
/// for a W so close to singular that GMRES in single precision does not get through.
class ExactCompliance : public DenseCompliance
{
public:
  using DenseCompliance::DenseCompliance;

  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
};
} // namespace orthocone
