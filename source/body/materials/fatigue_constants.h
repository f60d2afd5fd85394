// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone
{
/// Adds the entry Fatigue. No solver uses its constants: parameters.prm keeps them for tools/fatigue.
void declare_fatigue(MaterialOptions &material, Section &section);

/// Throws InputError where one limit stands alone, or where no parameter can agree with both.
void check_fatigue(const MaterialOptions &material);
} // namespace orthocone
