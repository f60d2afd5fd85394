// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace orthocone
{
namespace
{
/// Words that people type, in lower case. Symbols are too short for a search of misspellings.
const std::map<std::string, std::string> &entries_of_words()
{
  static const std::map<std::string, std::string> entries{{"mu", "Friction/Coefficients"},
                                                          {"mu_x", "Friction/Coefficients"},
                                                          {"mu_y", "Friction/Coefficients"},
                                                          {"cof", "Friction/Coefficients"},
                                                          {"coefficient", "Friction/Coefficients"},
                                                          {"friction", "Friction/Coefficients"},
                                                          {"friction coefficient", "Friction/Coefficients"},
                                                          {"p", "Friction/Slip potential"},
                                                          {"slip rule", "Friction/Slip potential"},
                                                          {"slip ellipse", "Friction/Slip potential"},
                                                          {"angle", "Friction/Orthotropy angle"},
                                                          {"e", "Material/Young modulus"},
                                                          {"young", "Material/Young modulus"},
                                                          {"modulus", "Material/Young modulus"},
                                                          {"elastic modulus", "Material/Young modulus"},
                                                          {"nu", "Material/Poisson ratio"},
                                                          {"r", "Geometry/Radius"},
                                                          {"diameter", "Geometry/Radius"},
                                                          {"d", "Geometry/Radius"},
                                                          {"length", "Geometry/Height"},
                                                          {"thickness", "Geometry/Height"},
                                                          {"force", "Load program/Legs"},
                                                          {"normal force", "Load program/Legs"},
                                                          {"load", "Load program/Legs"},
                                                          {"displacement", "Load program/Legs"},
                                                          {"amplitude", "Load program/Legs"},
                                                          {"steps", "Load program/Legs"},
                                                          {"order", "Mesh/Degree"},
                                                          {"refinement", "Mesh/Resolution"},
                                                          {"elements", "Mesh/Core cells"},
                                                          {"solver", "Contact solver/Method"},
                                                          {"tol", "Contact solver/Tolerance"},
                                                          {"iterations", "Contact solver/Maximum iterations"},
                                                          {"vtu", "Output/Contact fields"},
                                                          {"vtk", "Output/Contact fields"}};
  return entries;
}
} // namespace

std::string entry_for_word(const std::string &name)
{
  std::string word = name.substr(name.rfind('/') + 1);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  const auto found = entries_of_words().find(word);
  return found == entries_of_words().end() ? "" : found->second;
}
} // namespace orthocone
