// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/parameters.h>

#include <cstddef>
#include <list>
#include <map>
#include <string>
#include <vector>

namespace orthocone
{
/// Whether the run of a command line may take bodies from a process that was forked before it: a run of one
/// thread, because threads do not survive a fork, without a limit of its address space, of which the bodies
/// of others would take a part.
bool can_prepare_bodies(const std::vector<std::string> &words);

/// Puts the bodies of command lines on the shelf of this process (BodyShelf), from where the runs that it
/// forks take them. A body is made when its entries come for the second time: that of a single run is not
/// worth a place. What finds no room in memory is not made, and bodies that were not asked for the longest
/// time make room.
class BodyPreparation
{
public:
  /// `n_runs` of them share the memory.
  explicit BodyPreparation(const unsigned int n_runs)
      : n_runs_(n_runs)
  {
  }

  /// Never throws: what is wrong with a command line, its run will say.
  void prepare(const std::vector<std::string> &words);

private:
  void prepare(const CommandLine &line, const ParameterFile &file);
  bool has_room(const Parameters &parameters, const ModelSymmetry &symmetry);

  unsigned int n_runs_;
  std::map<std::size_t, unsigned int> n_seen_{}; ///< by checksum of the key, while its bodies are not kept
  std::list<std::string> kept_{};                ///< keys, those asked for last come first
};
} // namespace orthocone
