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

/// studies starts FILE.prm [--set "Section/Entry=value"]... [--step N] [--loads L] [--starts M]: step N, or L
/// random loads instead, solved from three special and M random starts with three methods, and which of these
/// end at the same solution.
void starts(const Words &words);

/// studies one_node [--coupling C] [--friction F] [--loads N]: a node with w_nn = w_tt = 1, w_nt = C, with F
/// times the friction at which it wedges, under loads from N directions: which states solve the law, and
/// which one is found.
void one_node(const Words &words);
} // namespace orthocone::studies
