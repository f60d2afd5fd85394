// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/text_file.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace orthocone
{
namespace
{
std::string without_byte_order_mark(const std::string &content)
{
  constexpr const char *mark = "\xef\xbb\xbf";
  return content.compare(0, std::strlen(mark), mark) == 0 ? content.substr(std::strlen(mark)) : content;
}

/// Lines may end in "\r\n" (Windows) or "\r" (old Macs).
std::string with_plain_line_ends(const std::string &content)
{
  std::string text;
  text.reserve(content.size());
  for (std::size_t i = 0; i < content.size(); ++i)
    if (content[i] != '\r')
      text += content[i];
    else if (i + 1 == content.size() || content[i + 1] != '\n')
      text += '\n';
  return text;
}

/// An open file of any kind. Opening does not wait: with a pipe it would wait for a writer that may never
/// come.
class InputFile
{
public:
  /// `name` is the file's name in messages.
  InputFile(const std::string &path, std::string name)
      : name_(std::move(name)),
        descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))
  {
    struct stat status
    {
    };
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
      fail();
    is_pipe_ = S_ISFIFO(status.st_mode);
    is_folder_ = S_ISDIR(status.st_mode);
  }
  ~InputFile() { ::close(descriptor_); }
  InputFile(const InputFile &) = delete;
  InputFile &operator=(const InputFile &) = delete;

  std::string read(const TextFileKind &kind)
  {
    constexpr std::size_t megabyte = 1000000;
    if (is_folder_)
      throw FileError(name_ + ": is a folder; " + kind.name + " is wanted");
    std::string content;
    std::array<char, 65536> piece{};
    while (const std::size_t n = read_piece(piece, content.empty()))
    {
      content.append(piece.data(), n);
      if (content.size() > kind.most_megabytes * megabyte)
        throw InputError(name_ + ": is larger than " + std::to_string(kind.most_megabytes) + " MB; " +
                         kind.name + " is wanted");
    }
    return content;
  }

private:
  [[noreturn]] void fail() const
  {
    const int cause = errno;
    if (descriptor_ >= 0)
      ::close(descriptor_);
    throw FileError(name_ + ": cannot be read (" + std::strerror(cause) + ")");
  }

  /// Waits for bytes and returns their number; 0 at the end.
  std::size_t read_piece(std::array<char, 65536> &piece, const bool is_first)
  {
    constexpr int patience = 50, pause = 100; // times, ms
    for (int n_empty = 0;;)
    {
      const ssize_t n = ::read(descriptor_, piece.data(), piece.size());
      if (n > 0)
        return static_cast<std::size_t>(n);
      if (n == 0 && (!is_pipe_ || !is_first))
        return 0;
      if (n < 0 && errno != EAGAIN && errno != EINTR)
        throw FileError(name_ + ": cannot be read (" + std::strerror(errno) + ")");
      if (n == 0 && ++n_empty == patience)
        throw FileError(name_ + ": is a pipe, and nobody has written into it for five seconds");
      // A pipe with a writer gives EAGAIN, and may take any time.
      pollfd poll_for{descriptor_, POLLIN, 0};
      n == 0 ? ::poll(nullptr, 0, pause) : ::poll(&poll_for, 1, -1);
    }
  }

  std::string name_;
  int descriptor_;
  bool is_pipe_ = false;
  bool is_folder_ = false;
};

bool is_text(const std::string &content)
{
  return std::none_of(content.begin(), content.end(),
                      [](const unsigned char c) { return (c < 32 && c != '\t' && c != '\n') || c == 127; });
}
} // namespace

std::string read_text_file(const std::string &file_name, const std::string &asked_from,
                           const TextFileKind &kind)
{
  const std::string name = asked_from + shown_path(file_name);
  const std::string content = InputFile(file_name, name).read(kind);
  const std::string text = with_plain_lines(content);
  if (trimmed(text).empty())
    throw InputError(name + ": is empty; " + kind.if_empty);
  if (!is_text(text))
    throw InputError(name + ": is not a text file; " + kind.name + " is wanted");
  return content;
}

std::string with_plain_lines(const std::string &content)
{
  return with_plain_line_ends(without_byte_order_mark(content));
}
} // namespace orthocone
