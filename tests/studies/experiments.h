// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Small experiments behind the charts of docs/accuracy.md and the maps of docs/stability.md, for what runs of
// the program do not show. Each takes the words that follow its name and prints CSV.
#pragma once

#include <string>
#include <vector>

namespace orthocone::studies
{
using Words = std::vector<std::string>;

/// studies compliance FILE.prm [--set "Section/Entry=value"]... [--matrix OUT]: figures of the compliance of
/// a scene.
void compliance(const Words &words);

/// studies trace FILE.prm [--set "Section/Entry=value"]... [--step N] [--method WORD] [--condensed 0]:
/// residuals of one step, solved from the forces of the step before; the steps up to there are solved by the
/// method of the file. With
/// --condensed 0 each product with the compliance is a solution with the sparse factor.
void trace(const Words &words);
} // namespace orthocone::studies
