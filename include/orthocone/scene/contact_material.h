// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// Material on a rigid plane that stands for both bodies: with the compliances in plane strain and in
/// antiplane shear of both together. It is the body's own where the obstacle is rigid.
MaterialOptions contact_material(const Parameters &parameters);
} // namespace orthocone
