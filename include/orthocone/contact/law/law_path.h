// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>

namespace orthocone
{
/// Whether a continuation (Continuation) has an easier law to come from, up to rounding: for ellipses that of
/// associated slip, for other laws the isotropic one of the same mean.
bool has_easier_law(const FrictionLaw &law);

/// A law on the way from the easier one (t = 0) to the given one (t = 1), which is well posed all along if
/// this one is. Of ellipses, the logarithms of the semi-axes of the slip ellipse are linear in t. Of other
/// laws, b(a) - a and the logarithm of R are, at 72 directions; where these are too few for a table
/// (Rosette), the law is returned as it is.
FrictionLaw law_on_path(const FrictionLaw &law, double t);
} // namespace orthocone
