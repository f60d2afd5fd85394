// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/expected_contact.h>

#include <string>

namespace orthocone
{
/// The half-space that computes the contact of a large body without its mesh, in a sentence, and what it
/// leaves out; "" where the body is not large beside the contact, or has what no half-space has.
std::string half_space_advice(const Parameters &parameters, const ExpectedContact &contact);
} // namespace orthocone
