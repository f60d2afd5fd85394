// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/field_list.h>

#include <orthocone/base/errors.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <sstream>
#include <system_error>

namespace orthocone
{
FieldList::FieldList(RunFolder &folder, const std::string &name)
    : folder_(folder),
      name_(name)
{
}

std::string field_file(const std::string &kind, const unsigned int step, const std::string &ending)
{
  constexpr std::size_t digits = 4;
  const std::string number = std::to_string(step);
  return kind + "-" + std::string(digits - std::min(digits, number.size()), '0') + number + "." + ending;
}

namespace
{
/// The name of the field file of a step as it was written.
std::string written_file(const RunFolder &folder, const std::string &kind, const unsigned int step)
{
  const std::string of_pieces = field_file(kind, step, "pvtu");
  return folder.has(of_pieces) ? of_pieces : field_file(kind, step);
}

/// The text of a list without the comment in which deal.II says when it was written: a resumed run ends with
/// the same bytes.
std::string without_date(const std::string &list)
{
  const std::string end = "-->\n";
  const std::size_t from = list.find("<!--"), to = list.find(end);
  return from < to && to != std::string::npos ? list.substr(0, from) + list.substr(to + end.size()) : list;
}

/// The file and the pieces that it names.
std::vector<std::string> with_pieces(const RunFolder &folder, const std::string &file)
{
  std::vector<std::string> files{file};
  const std::string text =
      folder.has(file) && file.find(".pvtu") != std::string::npos ? folder.read(file) : "";
  const std::string mark = "Source=\"";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
  {
    at += mark.size();
    files.push_back(text.substr(at, text.find('"', at) - at));
  }
  return files;
}
} // namespace

/// Throws FileError if a file is missing, or has another end.
static void require_whole(const RunFolder &folder, const std::string &file, const std::string &end)
{
  if (!folder.has(file) || !folder.ends_with(file, end))
    throw FileError(folder.path(file) + (folder.has(file) ? ": is cut off" : ": is missing") +
                    ", so that the run cannot be continued; without --resume it starts anew");
}

void require_fields(const RunFolder &folder, const std::string &kind, const std::vector<unsigned int> &steps)
{
  for (const unsigned int step : steps)
    for (const std::string &file : with_pieces(folder, written_file(folder, kind, step)))
      require_whole(folder, file, "</VTKFile>\n");
}

void require_lines(const RunFolder &folder, const std::map<std::string, std::vector<unsigned int>> &lines)
{
  for (const auto &[name, steps] : lines)
    for (const unsigned int step : steps)
      require_whole(folder, field_file("line-" + name, step, "csv"), "\n");
}

void FieldList::set(const std::vector<unsigned int> &steps)
{
  files_.clear();
  for (const unsigned int step : steps)
    files_.emplace_back(step, written_file(folder_, name_, step));
  is_up_to_date_ = files_.empty();
  if (files_.empty())
    folder_.remove(name_ + ".pvd");
  flush();
}

std::vector<unsigned int> FieldList::steps() const
{
  std::vector<unsigned int> steps;
  steps.reserve(files_.size());
  for (const auto &[step, file] : files_)
    steps.push_back(static_cast<unsigned int>(step));
  return steps;
}

void FieldList::add(const unsigned int step, const std::function<std::string()> &make)
{
  if (folder_.is_nowhere())
    return;
  write_pending();
  pending_step_ = step;
  try
  {
    pending_ = std::async(std::launch::async, make);
  }
  catch (const std::system_error &) // no thread is available
  {
    pending_ = std::async(std::launch::deferred, make);
  }
}

void FieldList::write_pending()
{
  if (!pending_.valid())
    return;
  write_file(pending_step_, field_file(name_, pending_step_), pending_.get());
}

void FieldList::write_file(const unsigned int step, const std::string &file, const std::string &content)
{
  folder_.write(file, content);
  files_.emplace_back(step, file);
  is_up_to_date_ = false;
  if (since_writing_.seconds() >= least_seconds_)
    write_list();
}

void FieldList::add_pieces(const unsigned int step, const std::vector<std::string> &pieces,
                           const std::function<std::string(const std::vector<std::string> &)> &list)
{
  std::vector<std::string> names;
  for (const std::string &piece : pieces)
    if (!piece.empty())
    {
      names.push_back(field_file(name_, step, std::to_string(names.size()) + ".vtu"));
      folder_.write(names.back(), piece);
    }
  write_file(step, field_file(name_, step, "pvtu"), list(names));
}

bool FieldList::has(const unsigned int step) const
{
  return (pending_.valid() && pending_step_ >= step) || (!files_.empty() && files_.back().first >= step);
}

void FieldList::flush()
{
  write_pending();
  if (!is_up_to_date_)
    write_list();
}

void FieldList::write_list()
{
  constexpr double usual_seconds = 1;
  constexpr double least_pause = 50; // in multiples of the time that the writing takes
  const Stopwatch watch;
  std::ostringstream text;
  dealii::DataOutBase::write_pvd_record(text, files_);
  folder_.write(name_ + ".pvd", without_date(text.str()));
  is_up_to_date_ = true;
  least_seconds_ = std::max(usual_seconds, least_pause * watch.seconds());
  since_writing_ = Stopwatch();
}
} // namespace orthocone
