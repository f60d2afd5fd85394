// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// Whether a byte goes on with a UTF-8 character that began before.
bool continues_character(char c);

/// Content of a text file, byte for byte. It may be a pipe or a device and is read once: up to 4 MB, and a
/// pipe without a writer for five seconds. Throws FileError if it cannot be read, InputError if it is empty,
/// binary or larger; their messages begin with `asked_from` ("" or "file:line: ").
std::string read_text_file(const std::string &file_name, const std::string &asked_from = "");

/// The text without a byte-order mark and with '\n' at the end of lines, whatever wrote it.
std::string with_plain_lines(const std::string &content);
} // namespace orthocone
