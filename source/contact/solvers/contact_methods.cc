// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <algorithm>
#include <stdexcept>

namespace orthocone
{
const std::vector<ContactMethod> &contact_methods()
{
  static const std::vector<ContactMethod> methods{newton_method(), gauss_seidel_method(),
                                                  uzawa_method(),  feng2006_method(),
                                                  box3_method(),   plain_newton_method()};
  return methods;
}

const ContactMethod *find_contact_method(const std::string_view word)
{
  const auto &methods = contact_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const ContactMethod &method) { return method.word == word; });
  return found == methods.end() ? nullptr : &*found;
}

std::unique_ptr<ContactSolver> make_contact_solver(const ContactSystem &system,
                                                   const ContactSolverOptions &options)
{
  const ContactMethod *const method = find_contact_method(options.method);
  if (method == nullptr)
    throw std::invalid_argument("there is no contact solver '" + options.method + "'");
  return method->make(system, options);
}
} // namespace orthocone
