// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/input_file.h>

#include <orthocone/base/errors.h>

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
// With a pipe, opening would wait for a writer that may never come.
InputFile::InputFile(const std::filesystem::path &path, std::string name, const Links links)
    : name_(std::move(name)),
      descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC |
                                           (links == Links::refused ? O_NOFOLLOW : 0)))
{
  struct stat status
  {
  };
  if (descriptor_ < 0 && errno == ELOOP && links == Links::refused)
    throw FileError(name_ + ": is a symbolic link, which is not followed here");
  if (descriptor_ < 0)
    fail(errno);
  if (::fstat(descriptor_, &status) != 0)
  {
    const int cause = errno;
    ::close(descriptor_);
    fail(cause);
  }
  is_pipe_ = S_ISFIFO(status.st_mode);
  is_folder_ = S_ISDIR(status.st_mode);
  is_ordinary_ = S_ISREG(status.st_mode);
  size_ = is_ordinary_ ? static_cast<std::uintmax_t>(status.st_size) : 0;
}

InputFile::~InputFile()
{
  ::close(descriptor_);
}

void InputFile::fail(const int cause) const
{
  throw FileError(name_ + ": cannot be read (" + std::strerror(cause) + ")");
}

void InputFile::go_to(const std::uintmax_t place)
{
  if (::lseek(descriptor_, static_cast<off_t>(place), SEEK_SET) < 0)
    fail(errno);
}

std::size_t InputFile::read(char *const bytes, const std::size_t most)
{
  constexpr int patience = 50, pause = 100; // times, ms
  for (int n_empty = 0;;)
  {
    const ssize_t n = ::read(descriptor_, bytes, most);
    if (n > 0)
    {
      has_read_ = true;
      return static_cast<std::size_t>(n);
    }
    if (n == 0 && (!is_pipe_ || has_read_))
      return 0;
    if (n < 0 && errno != EAGAIN && errno != EINTR)
      fail(errno);
    if (n == 0 && ++n_empty == patience)
      throw FileError(name_ + ": is a pipe, and nobody has written into it for five seconds");
    // A pipe with a writer gives EAGAIN, and may take any time.
    pollfd poll_for{descriptor_, POLLIN, 0};
    n == 0 ? ::poll(nullptr, 0, pause) : ::poll(&poll_for, 1, -1);
  }
}

std::string InputFile::read(const std::size_t most)
{
  std::string content;
  std::array<char, 65536> piece{};
  while (content.size() < most)
  {
    const std::size_t n = read(piece.data(), std::min(piece.size(), most - content.size()));
    if (n == 0)
      break;
    content.append(piece.data(), n);
  }
  return content;
}
} // namespace orthocone
