// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>
#include <orthocone/scene/scene.h>

namespace orthocone
{
/// Work of the held face and of the loads between two states, N mm, by the trapezoidal rule. What gives
/// tractions works on the change of its conjugate, what gives displacements or strains the other way round
/// (docs/theory.md, section 4).
double driven_work(const Scene &scene, const ContactState &before, const ContactState &after);
} // namespace orthocone
