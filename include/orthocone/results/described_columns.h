// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// What --columns prints: a line for each column of the CSV files and each field of the VTU files, of file,
/// name, unit and meaning with tabs between. docs/results.md is made of it.
std::string described_columns();
} // namespace orthocone
