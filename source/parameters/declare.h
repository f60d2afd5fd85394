// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Binds option structs to the table of entries: one call has name, default, range and help of an entry.
#pragma once

#include "entries.h"

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// Declares all sections and binds the entries to `parameters`, whose present values are the defaults.
/// `parameters` must outlive `table`.
void declare_parameters(Parameters &parameters, EntryTable &table);
} // namespace orthocone
