// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// Lame's parameters in MPa.
struct LameParameters
{
  explicit LameParameters(const MaterialOptions &material);

  double lambda;
  double mu;
};
} // namespace orthocone
