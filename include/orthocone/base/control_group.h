// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The limits that a container or a batch system sets to this process.
#pragma once

#include <functional>
#include <string>

namespace orthocone
{
/// The least limit that `limit_in` reads in the directories of this process' control group and of the groups
/// above it, for `controller` ("memory", "cpu"), in the unit of `limit_in`; infinite where there is no limit.
/// `limit_in` takes the directory, and whether it is one of version 2.
double least_in_control_groups(const std::string &controller,
                               const std::function<double(const std::string &, bool)> &limit_in);
} // namespace orthocone
