// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Entries that the contact solvers themselves describe.
#pragma once

#include "entries.h"

namespace orthocone
{
struct ContactMethod;
}

namespace orthocone::entries
{
using ContactMethodTest = std::function<bool(const ContactMethod &)>;

/// Words of the contact solvers; with a test, of the solvers that pass it.
std::string contact_method_words(const std::string &separator, const ContactMethodTest &is_chosen = {});

/// A contact solver by its word.
/// Whether a contact solver works with a dense compliance only.
bool is_method_for_dense(const std::string &method);

void add_contact_method(EntryTable &table, const std::string &name, std::string &method);

/// A factor > 0 of the rho of those solvers that have one.
void add_rho_factor(EntryTable &table, const std::string &name, double &factor);
} // namespace orthocone::entries
