// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The kinds of loads, each of which is defined in a file of its name.
#pragma once

#include <orthocone/body/loads/load.h>

namespace orthocone
{
const LoadKind &pressure_load();
const LoadKind &traction_load();
const LoadKind &motion_load();
const LoadKind &force_load();
const LoadKind &temperature_load();
const LoadKind &interference_load();
} // namespace orthocone
