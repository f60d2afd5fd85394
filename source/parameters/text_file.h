// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// Content of a text file, without a byte-order mark and with '\n' at the end of lines whatever wrote it.
/// Throws FileError if it cannot be read, InputError if it is empty or binary. `asked_from` is put before the
/// message
/// ("" or "file:line: ").
std::string read_text_file(const std::string &file_name, const std::string &asked_from = "");
} // namespace orthocone
