// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/run_folder.h>

#include <orthocone/parameters/errors.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>
#include <vector>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path &file, const std::string &task, const std::string &cause)
{
  throw FileError(file.string() + ": " + task + " (" + cause + ")");
}

void write_all(const fs::path &file, const std::string &content, const std::ios::openmode mode)
{
  errno = 0;
  std::ofstream stream(file, std::ios::binary | mode);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
    fail(file, "cannot be written", std::strerror(errno != 0 ? errno : EIO));
}
} // namespace

RunFolder::RunFolder(const fs::path &path)
    : path_(path)
{
  std::error_code code;
  if (fs::exists(path_, code) && !fs::is_directory(path_, code))
    fail(path_, "cannot be the run folder",
         "a file of this name is in its place; --output DIR takes another one");
  fs::create_directories(path_, code);
  if (code)
    fail(path_, "cannot be created as the run folder", code.message());
  write(".writable", "");
  fs::remove(path_ / ".writable", code);
}

void RunFolder::remove_earlier_run() const
{
  const std::regex ours(
      "((contact|volume)(-\\d+\\.vtu|\\.pvd)|probe-.*\\.csv|(history|timing)\\.csv|summary\\.json|"
      "(input|parameters)\\.prm|input\\.json|log\\.txt)(\\.part)?");
  std::vector<fs::path> files;
  for (const auto &entry : fs::directory_iterator(path_))
    if (std::regex_match(entry.path().filename().string(), ours))
      files.push_back(entry.path());
  const bool is_ours = fs::exists(path_ / "parameters.prm") || fs::exists(path_ / "parameters.prm.part");
  if (!files.empty() && !is_ours)
    fail(path_, "cannot be the run folder",
         "it holds a " + files.front().filename().string() +
             " that no run left there, for parameters.prm is missing; --output DIR takes another one");
  // Before anything is removed, everything must be removable.
  for (const fs::path &file : files)
    if (fs::is_directory(file))
      fail(file, "cannot be replaced", "a folder of this name is in its place");
  std::error_code code;
  for (const fs::path &file : files)
    if (!fs::remove(file, code))
      fail(file, "cannot be removed", code.message());
}

void RunFolder::write(const std::string &name, const std::string &content) const
{
  const fs::path temporary = path_ / (name + ".part");
  std::error_code code;
  try
  {
    write_all(temporary, content, std::ios::trunc);
    fs::rename(temporary, path_ / name);
  }
  catch (const fs::filesystem_error &error)
  {
    fs::remove(temporary, code);
    fail(path_ / name, "cannot be written", error.code().message());
  }
  catch (const FileError &)
  {
    fs::remove(temporary, code);
    throw;
  }
}

void RunFolder::append(const std::string &name, const std::string &content) const
{
  write_all(path_ / name, content, std::ios::app);
}

std::string RunFolder::path(const std::string &name) const
{
  return name.empty() ? path_.string() : (path_ / name).string();
}
} // namespace orthocone
