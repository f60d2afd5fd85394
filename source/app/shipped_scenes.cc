// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shipped_scenes.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/names.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// First sentence of the first comment that is not the licence.
std::string first_sentence(const fs::path &file)
{
  std::ifstream in(file);
  if (!in)
    throw FileError(shown_path(file.string()) + ": cannot be read");
  std::string text;
  for (std::string line; std::getline(in, line) && line.rfind('#', 0) == 0;)
  {
    const std::string words = trimmed(line.substr(1));
    if (words.rfind("SPDX", 0) == 0 || words.rfind("Copyright", 0) == 0 || (words.empty() && text.empty()))
      continue;
    if (words.empty())
      break;
    text += (text.empty() ? "" : " ") + words;
  }
  return text.substr(0, (text + " ").find(". "));
}

/// The path as users would type it: from their present folder if the file is below it.
std::string typed(const fs::path &file)
{
  const fs::path relative = fs::proximate(file);
  return relative.begin()->string() == ".." ? file.string() : relative.string();
}
/// "a, b, c", and the name that is most like `name`.
std::string known_rigs(const fs::path &folder, const std::string &name)
{
  std::vector<std::string> rigs;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".prm")
      rigs.push_back(entry.path().stem().string());
  std::sort(rigs.begin(), rigs.end());
  std::string text;
  for (const std::string &rig : rigs)
    text += (text.empty() ? "" : ", ") + rig;
  const std::string nearest = nearest_name(name, rigs);
  return text + (nearest.empty() ? "" : "; is " + nearest + " meant?");
}
} // namespace

fs::path folder_of_shipped_scenes()
{
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char *const place : {"../prm", "../share/orthocone/prm"})
    if (fs::is_directory(program / place))
      return fs::canonical(program / place);
  throw FileError("the scenes that come with the program are neither in " +
                  shown_path((program / "../prm").lexically_normal().string()) + " nor in " +
                  shown_path((program / "../share/orthocone/prm").lexically_normal().string()));
}

std::string shipped_scenes(const fs::path &folder)
{
  std::vector<std::pair<std::string, std::string>> scenes;
  std::size_t width = 0;
  for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".prm")
    {
      scenes.emplace_back(typed(entry.path()), first_sentence(entry.path()));
      width = std::max(width, scenes.back().first.size());
    }
  std::sort(scenes.begin(), scenes.end());
  std::ostringstream text;
  for (const auto &[file, sentence] : scenes)
    text << std::left << std::setw(static_cast<int>(width)) << file << "  " << sentence << "\n";
  return text.str();
}

void copy_rig(const std::string &rig, const std::string &file)
{
  const fs::path folder = folder_of_shipped_scenes() / "rigs";
  const std::string command = "command line: --new = " + shown(rig);
  if (rig.empty() || rig.find('/') != std::string::npos || !fs::is_regular_file(folder / (rig + ".prm")))
    throw InputError(command + ": allowed are " + known_rigs(folder, rig));
  if (fs::path(file).extension() != ".prm")
    throw InputError(command + " " + shown_path(file) +
                     ": allowed is the name of a new file that ends in .prm, as in 'orthocone --new " + rig +
                     " my.prm'");
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error)))
    throw InputError(command + ": " + shown_path(file) + " exists: allowed is the name of a new file");
  const std::string target = shown_path(file);
  if (!fs::copy_file(folder / (rig + ".prm"), file, fs::copy_options::none, error) || error)
    throw FileError(target + ": cannot be written (" + error.message() + ")");
}
} // namespace orthocone
