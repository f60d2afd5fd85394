// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/run_folder.h>

#include "posix_file.h"
#include "run_files.h"
#include "run_folder_names.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <stdexcept>

namespace orthocone
{
namespace fs = std::filesystem;
using run_folder::fail;
using run_folder::names_in;

RunFolder::RunFolder(const std::optional<fs::path> &path)
    : path_(path.value_or(fs::path()))
{
  if (!path)
    return;
  std::error_code code;
  run_folder::require_not_of_system(path_);
  if (fs::exists(path_, code) && !fs::is_directory(path_, code))
    fail(path_, "cannot be the run folder",
         "a file of this name is in its place; --output DIR takes another one");
  fs::create_directories(path_, code);
  if (code)
    fail(path_, "cannot be created as the run folder", code.message());
  lock();
  identity_ = posix::identity(path_);
}

/// Throws FileError if the folder was moved while the run writes there, and another one has taken its name.
void RunFolder::require_same_folder() const
{
  if (posix::identity(path_) != identity_)
    throw FileError(path() + ": is no longer the folder that the run has begun in; was it moved or removed?");
}

RunFolder::~RunFolder()
{
  if (!is_nowhere())
    posix::close(lock_);
}

void RunFolder::lock()
{
  const auto result = posix::lock_folder(path_);
  if (result.is_taken)
    fail(path_, "cannot be the run folder",
         "another run is writing there; wait for it, or take another one by --output DIR");
  lock_ = result.descriptor;
}

static bool is_of_a_line(const std::string &name)
{
  return run_folder::run_file(name)->kind == run_folder::FileKind::line_file;
}

void RunFolder::remove_fields_after(const unsigned int step)
{
  if (is_nowhere())
    return;
  const std::set<std::string> of_lines = own_line_files();
  for (const std::string &name : names_in(path_))
    if (run_folder::step_of(name).value_or(0) > step && (!is_of_a_line(name) || of_lines.count(name) > 0))
      remove(name);
}

/// Requires the manifest to list a file: the next run would neither remove another one, nor be safe for it.
static void require_listed(const std::string &name)
{
  if (run_folder::run_file(name) == nullptr)
    throw std::logic_error(name + ": is not in the list of the files of a run");
}

/// Where a file of a run lies. Throws FileError for any other name, whoever states it, and for a link to
/// another folder where a folder of the run belongs.
fs::path RunFolder::place_of(const std::string &name) const
{
  const fs::path place = path_ / name;
  if (run_folder::run_file(name) == nullptr)
    fail(path_, "cannot be used",
         "it names '" + shown(name) + "' as a file of a run, but no run writes such a file");
  std::error_code code;
  if (const fs::path folder = place.parent_path(); folder != path_ && fs::is_symlink(folder, code))
    fail(folder, "cannot be used", "it is a symbolic link in place of a folder");
  return place;
}

/// Writes the new content beside the file; nothing is left if this fails.
fs::path RunFolder::write_part(const std::string &name, const std::string &content, const bool durably)
{
  require_listed(name);
  require_same_folder();
  const fs::path part = place_of(name + ".part");
  std::error_code code;
  fs::create_directories(part.parent_path(), code);
  if (code)
    fail(part.parent_path(), "cannot be created", code.message());
  try
  {
    posix::write(part, content);
    if (durably)
      posix::synchronize(part);
    return part;
  }
  catch (const FileError &)
  {
    fs::remove(part, code);
    throw;
  }
}

void RunFolder::replace(const std::string &name, const std::string &content, const bool durably)
{
  const fs::path part = write_part(name, content, durably);
  try
  {
    posix::rename(part, place_of(name));
  }
  catch (const FileError &)
  {
    std::error_code code;
    fs::remove(part, code);
    throw;
  }
}

void RunFolder::write(const std::string &name, const std::string &content)
{
  if (is_nowhere())
    return;
  replace(name, content, false);
  not_on_disk_.insert(name);
}

void RunFolder::write_durably(const std::string &name, const std::string &content)
{
  if (is_nowhere())
    return;
  for (const std::string &file : not_on_disk_)
    if (has(file))
      posix::synchronize(place_of(file));
  not_on_disk_.clear();
  posix::synchronize(path_);
  replace(name, content, true);
  posix::synchronize((path_ / name).parent_path());
  posix::synchronize(path_);
}

fs::path RunFolder::place_for(const std::string &name)
{
  require_listed(name);
  require_same_folder();
  not_on_disk_.insert(name);
  return place_of(name);
}

void RunFolder::append(const std::string &name, const std::string &content)
{
  if (is_nowhere())
    return;
  require_listed(name);
  require_same_folder();
  auto known = growing_.find(name);
  if (known == growing_.end())
  {
    // In a resumed run log.txt exists.
    const auto size = posix::append(place_of(name), content, std::nullopt);
    known = growing_.emplace(name, Growing()).first;
    known->second.size = size;
  }
  else
    known->second.size = posix::append(place_of(name), content, known->second.size);
  known->second.crc.process_bytes(content.data(), content.size());
  not_on_disk_.insert(name);
}

std::string RunFolder::read(const std::string &name) const
{
  const fs::path place = place_of(name);
  return posix::read(place, run_folder::run_file(name)->most_bytes);
}

bool RunFolder::has(const std::string &name) const
{
  std::error_code code;
  return !is_nowhere() && run_folder::run_file(name) != nullptr && fs::exists(place_of(name), code);
}

bool RunFolder::ends_with(const std::string &name, const std::string &end) const
{
  return posix::tail(place_of(name), end.size()) == end;
}

void RunFolder::remove(const std::string &name)
{
  if (is_nowhere())
    return;
  require_same_folder();
  std::error_code code;
  const fs::path place = place_of(name);
  fs::remove(place, code);
  if (code)
    fail(place, "cannot be removed", code.message());
}

static bool is_table(const std::string &name)
{
  using run_folder::FileKind;
  const run_folder::RunFile *const file = run_folder::run_file(name);
  return file != nullptr && (file->kind == FileKind::table || file->kind == FileKind::probe_table);
}

TableMarks RunFolder::tables() const
{
  TableMarks marks;
  for (const auto &[name, file] : growing_)
    if (is_table(name))
      marks[name] = {file.size, file.crc.checksum()};
  return marks;
}

void RunFolder::require_tables(const TableMarks &marks) const
{
  if (!is_nowhere())
    marked_tables(marks);
}

std::map<std::string, RunFolder::Growing> RunFolder::marked_tables(const TableMarks &marks) const
{
  std::map<std::string, Growing> tables;
  for (const auto &[name, mark] : marks)
  {
    if (!is_table(name))
      fail(path_, "cannot be continued",
           "its checkpoint names '" + shown(name) + "' as a table, which no run writes");
    if (!has(name))
      fail(path_ / name, "cannot be continued", "it is missing");
    boost::crc_32_type crc;
    if (!posix::read_pieces(place_of(name), mark.size,
                            [&](const char *const piece, const std::size_t n)
                            { crc.process_bytes(piece, n); }))
      fail(path_ / name, "cannot be continued", "it is shorter than when the checkpoint was written");
    if (crc.checksum() != mark.checksum)
      fail(path_ / name, "cannot be continued", "it was changed since the checkpoint was written");
    tables[name] = {mark.size, crc};
  }
  return tables;
}

void RunFolder::cut_tables(const TableMarks &marks)
{
  if (is_nowhere())
    return;
  for (const auto &[name, table] : marked_tables(marks))
    growing_[name] = table;
  for (const std::string &name : own_tables())
    if (const auto kept = marks.find(name); kept == marks.end())
    {
      if (has(name))
        remove(name);
      growing_.erase(name);
    }
    else
      posix::cut(place_of(name), kept->second.size);
}

std::string RunFolder::path(const std::string &name) const
{
  return shown_path(name.empty() ? path_.string() : (path_ / name).string());
}
} // namespace orthocone
