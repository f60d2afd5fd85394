// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "motion_warnings.h"

#include <orthocone/base/text.h>

#include <cmath>

namespace orthocone
{
void warn_of_large_motions(const RunRecord &record, std::vector<std::string> &warnings)
{
  constexpr double small = 0.05, percent = 100; // strains that linear elasticity is good for
  const auto begin = [](const unsigned int step) { return "load step " + std::to_string(step) + ": "; };
  if (record.flattening.first > small)
    warnings.push_back(begin(record.flattening.second) + "the contact is displaced by " +
                       to_text(std::round(percent * record.flattening.first)) +
                       " % of the body's height against its held face; the program computes with small "
                       "strains, which is good up to about 5 %. Smaller loads or motions keep within it");
  else if (constexpr double hertzian = 0.1; record.pressure_of_modulus.first > hertzian)
    // Pressure of Hertz that is a tenth of the modulus belongs to a contact a quarter as wide as the sphere.
    warnings.push_back(begin(record.pressure_of_modulus.second) + "the mean pressure of the contact is " +
                       to_text(std::round(percent * record.pressure_of_modulus.first)) +
                       " % of Young's modulus; the program computes with small strains, which is good up to "
                       "about 10 % (strains of 5 %). Smaller loads or motions keep within it");
  if (record.border.first > 0)
    warnings.push_back(begin(record.border.second) +
                       "the contact reaches the border of Geometry/Sizes, with " +
                       to_text(std::ceil(percent * record.border.first)) +
                       " % of the normal force on the outermost patches, and beyond it the half-space cannot "
                       "touch. Larger Sizes keep the contact inside, unless it is to end there as below a "
                       "punch with sharp edges");
  if (record.slide_of_face.first > 1)
    warnings.push_back(
        begin(record.slide_of_face.second) + "the body slides by " +
        to_text(std::round(10 * record.slide_of_face.first) / 10) +
        " faces of the lower body's mesh, but the program pairs both surfaces as they lay at the start, "
        "which is good for slides up to about one face; take larger faces (Lower mesh) or a shorter slide");
}
} // namespace orthocone
