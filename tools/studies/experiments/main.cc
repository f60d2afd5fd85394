// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "experiments.h"

#include <exception>
#include <iostream>
#include <map>

using namespace orthocone::studies;

int main(const int argc, const char *const *const argv)
{
  const std::map<std::string, void (*)(const Words &)> experiments{
      {"compliance", compliance},
      {"trace", trace},
      {"spectrum", spectrum},
      {"small_problems", small_problems},
      {"projection", projection},
      {"layer", layer},
      {"slip_integration", slip_integration},
      {"starts", starts},
      {"one_node", one_node},
      {"half_space", half_space},
      {"fixed_jumps", fixed_jumps},
      {"elastic", elastic},
  };
  const Words words(argv + 1, argv + argc);
  const auto experiment = words.empty() ? experiments.end() : experiments.find(words.front());
  if (experiment == experiments.end())
  {
    std::cerr << "studies: the first word names the experiment:";
    for (const auto &[name, run] : experiments)
      std::cerr << " " << name;
    std::cerr << "\n";
    return 2;
  }
  try
  {
    experiment->second(Words(words.begin() + 1, words.end()));
  }
  catch (const std::exception &error)
  {
    std::cerr << "studies " << words.front() << ": " << error.what() << "\n";
    return 2;
  }
  return 0;
}
