// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// The memory that this process may use in all.
struct MemoryLimit
{
  double gigabytes;
  std::string source; ///< "this machine has", "'ulimit -v' leaves", "the control group allows"
};

/// The least of three: what the machine has, what a batch system or a container allows (control groups,
/// version 1 and 2), and what is left of the address space (RLIMIT_AS).
MemoryLimit memory_limit();

/// Throws InputError if less of the address space is left than any run needs. OpenBLAS asks for memory in
/// threads of its own, and would wait for it for ever.
void require_address_space();
} // namespace orthocone
