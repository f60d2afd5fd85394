// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver_options.h>

#include <memory>
#include <string_view>
#include <vector>

namespace orthocone
{
class ContactSolver;
class ContactSystem;

/// The help texts of a contact solver, and the function that makes it. Each solver's own file defines it.
struct ContactMethod
{
  std::string_view word; ///< of Contact solver/Method
  std::string_view help; ///< what it does, a clause
  std::unique_ptr<ContactSolver> (*make)(const ContactSystem &, const ContactSolverOptions &);
  std::string_view rho{};      ///< what Rho factor is a factor of, a clause; nothing if it has no rho
  bool has_relaxation = false; ///< whether it reads Relaxation
  bool needs_dense = true;     ///< whether it works with a dense compliance only
  bool needs_ellipses = false; ///< whether it works with friction laws of two ellipses only
  bool is_for_study = false;   ///< it is there to show where it fails (docs/stability.md)
};

/// All contact solvers, the one to work with first.
const std::vector<ContactMethod> &contact_methods();

/// The contact solver of a word, or null.
const ContactMethod *find_contact_method(std::string_view word);
} // namespace orthocone
