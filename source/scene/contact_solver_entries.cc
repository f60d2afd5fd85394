// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/scene/options.h>

namespace orthocone
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
  return "Algorithm that solves the contact problem of a load step. " +
         listed([](const ContactMethod &method) { return !method.is_for_study; }, clause) +
         ". Only to study how methods fail (docs/stability.md): " +
         listed([](const ContactMethod &method) { return method.is_for_study; }, clause) + ".";
}

std::string help_of_rho()
{
  const auto all = [](const ContactMethod &) { return true; };
  return "Factor by which the method's own step size rho is multiplied. " +
         listed(all, [](const ContactMethod &method) { return method.rho; }) +
         ". The reported residual does not depend on this factor.";
}

/// The words of those methods that `is_chosen` accepts.
template<typename IsChosen>
std::string method_words(const std::string &separator, const IsChosen &is_chosen)
{
  std::string list;
  for (const ContactMethod &method : contact_methods())
    if (is_chosen(method))
      list += (list.empty() ? "" : separator) + std::string(method.word);
  return list;
}

/// A contact solver by its word.
Codec<std::string> method_codec()
{
  return {method_words(" | ", [](const ContactMethod &) { return true; }),
          [](const std::string &text, std::string &)
          { return find_contact_method(text) == nullptr ? std::nullopt : std::optional<std::string>(text); },
          [](const std::string &word) { return word; }};
}

/// That the chosen method passes a test; else it is named, and `remark` follows.
template<typename Test>
Condition method_where(const ContactSolverOptions &solver, const Test &test, const std::string &remark)
{
  return {[&solver, test] { return test(*find_contact_method(solver.method)); },
          [&solver, remark] { return "Contact solver/Method = " + solver.method + remark; }};
}
} // namespace

void declare_contact_solver(ContactSolverOptions &solver, Section &section)
{
  const auto has_relaxation = [](const ContactMethod &method) { return method.has_relaxation; };
  const auto has_rho = [](const ContactMethod &method) { return !method.rho.empty(); };
  section.add("Method", solver.method, method_codec(), help_of_methods())
      .may_change_on_resume()
      .also_called({"solver"});
  section
      .add("Tolerance", solver.tolerance, number_codec(NumberRange{1e-14, 1, true, false}),
           "Bound of the residual of a load step, the norm of the natural map relative to the norm of the "
           "contact forces.")
      .also_called({"tol"});
  section
      .add("Maximum iterations", solver.maximum_iterations, count_codec(1, 10000000),
           "Largest number of sweeps or iterations for a load step. It holds anew for each part of a step "
           "that has to be halved, and with Mesh/Backend = multigrid for each slip rule on the way to one "
           "that is far from associated.")
      .may_change_on_resume()
      .also_called({"iterations"});
  section
      .add("Relaxation", solver.relaxation, number_codec(NumberRange{0, 2}),
           "Relaxation factor of the sweeps of gauss-seidel; 1 = the one-node solutions are taken as they "
           "are.")
      .may_change_on_resume()
      .only_if(
          method_where(solver, has_relaxation, "; the entry is for " + method_words(", ", has_relaxation)));
  section.add("Rho factor", solver.rho_factor, number_codec(positive), help_of_rho())
      .may_change_on_resume()
      .only_if(method_where(solver, has_rho, ", which has no rho to choose"));
}

void warn_of_weak_method(const ContactSolverOptions &solver, std::vector<std::string> &warnings)
{
  if (find_contact_method(solver.method)->is_for_study)
    warnings.push_back("Contact solver/Method = " + solver.method +
                       " is there to show where it fails (docs/stability.md); " +
                       ContactSolverOptions().method + " is the method to work with");
}
} // namespace orthocone
