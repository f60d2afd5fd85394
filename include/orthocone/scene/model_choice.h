// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

namespace orthocone
{
/// The part of the body that is modelled, and why.
struct ModelChoice
{
  ModelSymmetry symmetry;
  std::string reason;
};

/// The model that the parameters ask for; `auto` takes the smallest one that is exact for the scene. Throws
/// InputError, which names the possible models, for a model that is not exact.
ModelChoice choose_model(const Parameters &parameters);

/// Throws InputError where neither the held face nor supports nor symmetry hold a body, and names its free
/// motion. All processes must call it.
void require_hold(const GeometryOptions &geometry, const BodyUnknowns &unknowns,
                  const ModelSymmetry &symmetry);

/// The same of the bodies of a scene, on their coarsest meshes of degree 1, where supports or a guided face
/// may leave them free.
void require_hold(const Parameters &parameters, const ModelSymmetry &symmetry);
} // namespace orthocone
