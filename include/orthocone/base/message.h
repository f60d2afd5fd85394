// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// A message as a terminal may show it: at most 600 bytes a line, without the middle of longer ones, and with
/// escapes for what a terminal would not print. Whatever it quotes, its beginning says what is wrong, its
/// end what to do.
std::string shown_message(const std::string &text);
} // namespace orthocone
