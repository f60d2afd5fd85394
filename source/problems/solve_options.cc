// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solve_options.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/contact/solvers/contact_method.h>

#include <sstream>

namespace orthocone
{
const char *const solve_usage =
    "orthocone-solve FILE.hdf5 [options]: solves a contact problem in FCLIB's format (local, 3-D)\n"
    "  --method WORD        contact solver (newton)\n"
    "  --tolerance NUMBER   bound of the residual (1e-10)\n"
    "  --iterations NUMBER  sweeps or iterations at most (5000)\n"
    "  --friction MU_X,MU_Y friction of all nodes, instead of that of the file\n"
    "  --slip P_X,P_Y       slip ellipse of all nodes, instead of that of the file\n"
    "  --repeat NUMBER      solves so many times, and prints the median of the seconds (1)\n"
    "  --stored             judges the solution in the file, instead of solving\n"
    "  --write FILE.hdf5    writes the problem and the solution\n"
    "  --csv                prints a line of names and a line of values\n"
    "Methods:\n";

namespace
{
using Pair = std::pair<double, double>;

double number(const std::string &option, const std::string &text, const double least, const double below)
{
  std::istringstream in(text);
  double value = 0;
  if (!(in >> value) || !in.eof() || !(value > least && value < below))
  {
    std::ostringstream message;
    message << option << " = '" << shown(text) << "': allowed is " << least << " < number < " << below;
    throw InputError(message.str());
  }
  return value;
}

Pair two_numbers(const std::string &option, const std::string &text)
{
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw InputError(option + " = '" + shown(text) + "': allowed are two numbers > 0, such as 0.3,0.15");
  return {number(option, text.substr(0, comma), 0, 1e6), number(option, text.substr(comma + 1), 0, 1e6)};
}

void take(SolveOptions &options, const std::string &option, const std::string &value)
{
  if (option == "--method")
    options.solver.method = value;
  else if (option == "--tolerance")
    options.solver.tolerance = number(option, value, 0, 1);
  else if (option == "--iterations")
    options.solver.maximum_iterations = static_cast<unsigned int>(number(option, value, 0.5, 4e9));
  else if (option == "--repeat")
    options.n_repeats = static_cast<unsigned int>(number(option, value, 0.5, 1e4));
  else if (option == "--friction")
    options.friction = two_numbers(option, value);
  else if (option == "--slip")
    options.slip = two_numbers(option, value);
  else if (option == "--write")
    options.write = value;
  else
    throw InputError("there is no option '" + shown(option) + "'; --help lists them");
}
} // namespace

SolveOptions read_solve_options(const std::vector<std::string> &arguments)
{
  SolveOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--help")
      options.is_help = true;
    else if (arguments[i] == "--csv")
      options.is_csv = true;
    else if (arguments[i] == "--stored")
      options.is_stored = true;
    else if (arguments[i].rfind("--", 0) != 0)
    {
      if (!options.file.empty())
        throw InputError("one file at a time: '" + shown_path(options.file) + "' and '" +
                         shown_path(arguments[i]) + "'");
      options.file = arguments[i];
    }
    else if (const std::size_t sign = arguments[i].find('='); sign != std::string::npos)
      take(options, arguments[i].substr(0, sign), arguments[i].substr(sign + 1));
    else if (i + 1 < arguments.size())
    {
      take(options, arguments[i], arguments[i + 1]);
      ++i;
    }
    else
      throw InputError("option '" + shown(arguments[i]) + "' wants a value; --help lists them");
  if (options.file.empty() && !options.is_help)
    throw InputError("which file? --help says more");
  if (find_contact_method(options.solver.method) == nullptr)
    throw InputError("--method = '" + shown(options.solver.method) + "': --help lists the methods");
  return options;
}
} // namespace orthocone
