// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// The output of --columns: a line for each column of the CSV files and each field of the VTU files, with
/// file, name, unit and meaning separated by tabs. docs/results.md is made from it.
std::string described_columns();
} // namespace orthocone
