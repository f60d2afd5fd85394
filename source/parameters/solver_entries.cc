// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solver_entries.h"

#include <orthocone/contact/solvers/contact_method.h>

namespace orthocone::entries
{
namespace
{
/// "WORD, WHAT ; WORD, WHAT" for the methods that `is_chosen` accepts and for which `clause` is not empty.
template<typename IsChosen, typename Clause>
std::string listed(const IsChosen &is_chosen, const Clause &clause)
{
  std::string list;
  for (const ContactMethod &method : contact_methods())
    if (is_chosen(method) && !clause(method).empty())
      list += (list.empty() ? "" : "; ") + std::string(method.word) + ": " + std::string(clause(method));
  return list;
}

std::string help_of_methods()
{
  const auto clause = [](const ContactMethod &method) { return method.help; };
  return listed([](const ContactMethod &method) { return !method.is_for_study; }, clause) +
         ". For the study of what fails (docs/stability.md): " +
         listed([](const ContactMethod &method) { return method.is_for_study; }, clause) + ".";
}

std::string help_of_rho()
{
  const auto all = [](const ContactMethod &) { return true; };
  return "Factor of the method's own rho. " +
         listed(all, [](const ContactMethod &method) { return method.rho; }) +
         ". The residual that is reported does not depend on it.";
}
} // namespace

std::string contact_method_words(const std::string &separator, const ContactMethodTest &is_chosen)
{
  std::string list;
  for (const ContactMethod &method : contact_methods())
    if (!is_chosen || is_chosen(method))
      list += (list.empty() ? "" : separator) + std::string(method.word);
  return list;
}

bool is_method_for_dense(const std::string &method)
{
  return find_contact_method(method)->needs_dense;
}

void add_contact_method(EntryTable &table, const std::string &name, std::string &method)
{
  table.add(name, method,
            Allowed(contact_method_words(" | "),
                    [](const std::string &text) { return find_contact_method(text) != nullptr; }),
            help_of_methods(), [&method](const std::string &text) { method = text; });
}

void add_rho_factor(EntryTable &table, const std::string &name, double &factor)
{
  add_number(table, name, factor, positive, help_of_rho());
}
} // namespace orthocone::entries
