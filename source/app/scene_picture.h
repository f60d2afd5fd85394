// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// Draws the scene of scene_description() to `file`, a .svg or .png, by the program tools/scene that comes
/// with this one. `title` is a line above it. Throws FileError where there is no such program, no Python with
/// matplotlib, or no such file.
void draw_scene(const std::string &description, const std::string &title, const std::string &file);

/// Whether a name is one of a picture: it ends in .svg or .png.
bool is_name_of_picture(const std::string &file);
} // namespace orthocone
