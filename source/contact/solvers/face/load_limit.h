// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// Whether it is proved that no forces within the friction cones balance what drives the face, whatever the
/// bodies do. The proof is a motion of the face on which the load does work, but on which no admissible force
/// of any node resists: such a motion exists if, and only if, the load is beyond the limit (Farkas' lemma).
/// False does not mean that the load is carried.
bool is_beyond_every_force(const ContactStep &step);
} // namespace orthocone
