// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "posix_file.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/input_file.h>
#include <orthocone/base/text.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace orthocone::posix
{
namespace
{
constexpr mode_t readable_by_all = 0666; // reduced by the user's umask

[[noreturn]] void fail(const std::filesystem::path &file, const char *const task, const int cause)
{
  throw FileError(shown_path(file.string()) + ": " + task + " (" + std::strerror(cause) + ")");
}

/// An open file that is closed at the end of its scope. Opening does not wait for the reader of a pipe.
class Descriptor
{
public:
  Descriptor(const std::filesystem::path &file, const int flags, const char *const task)
      : file_(file),
        task_(task),
        descriptor_(::open(file.c_str(), flags | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, readable_by_all))
  {
    if (descriptor_ < 0)
      fail(file_, task_, errno);
  }
  ~Descriptor() { posix::close(descriptor_); }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  int number() const { return descriptor_; }

  /// The size of an ordinary file (bytes). Throws FileError for any other one: a pipe would never be done.
  std::uintmax_t ordinary_size() const
  {
    struct stat status
    {
    };
    if (::fstat(descriptor_, &status) != 0)
      fail(file_, task_, errno);
    if (!S_ISREG(status.st_mode))
      throw FileError(shown_path(file_.string()) + ": " + task_ + " (it is no ordinary file)");
    return static_cast<std::uintmax_t>(status.st_size);
  }

  bool cut(const std::uintmax_t size) const
  {
    return ::ftruncate(descriptor_, static_cast<off_t>(size)) == 0;
  }

  void write_all(const std::string &content) const
  {
    for (std::size_t done = 0; done < content.size();)
    {
      const ssize_t n = ::write(descriptor_, content.data() + done, content.size() - done);
      if (n < 0 && errno != EINTR)
        fail(file_, task_, errno);
      done += n < 0 ? 0 : static_cast<std::size_t>(n);
    }
  }

  /// Some file systems report a full disk only here.
  void close()
  {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0)
      fail(file_, task_, errno);
  }

private:
  std::filesystem::path file_;
  const char *task_;
  int descriptor_;
};
} // namespace

void write(const std::filesystem::path &file, const std::string &content)
{
  if (::unlink(file.c_str()) != 0 && errno != ENOENT)
    fail(file, "cannot be replaced", errno);
  Descriptor descriptor(file, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, "cannot be written");
  descriptor.write_all(content);
  descriptor.close();
}

/// Cuts a table back to where a line that is not complete began.
static void cut_half_line(const std::filesystem::path &file, const std::uintmax_t size)
{
  try
  {
    cut(file, size);
  }
  catch (const FileError &error)
  {
    throw FileError(std::string(error.what()) + ", so that half a line stays at its end");
  }
}

std::uintmax_t append(const std::filesystem::path &file, const std::string &content,
                      const std::optional<std::uintmax_t> size)
{
  if (size && ::access(file.c_str(), F_OK) != 0)
    throw FileError(shown_path(file.string()) + ": was removed during the run");
  Descriptor descriptor(file, O_WRONLY | O_APPEND | O_NOFOLLOW | (size ? 0 : O_CREAT), "cannot be written");
  const std::uintmax_t before = descriptor.ordinary_size();
  if (size && before != *size)
    throw FileError(shown_path(file.string()) + ": was changed during the run by something else");
  try
  {
    descriptor.write_all(content);
    descriptor.close();
  }
  catch (const FileError &)
  {
    cut_half_line(file, before);
    throw;
  }
  return before + content.size();
}

namespace
{
/// A file that a run may have written, open for reading. Whoever made the folder may have put a link, a pipe
/// or a device in its place.
class OrdinaryFile : public InputFile
{
public:
  explicit OrdinaryFile(const std::filesystem::path &file)
      : InputFile(file, shown_path(file.string()), Links::refused)
  {
    if (is_folder())
      posix::fail(file, "cannot be read", EISDIR);
    if (!is_ordinary())
      throw FileError(shown_path(file.string()) + ": cannot be read (it is no ordinary file)");
  }
};
} // namespace

std::string read(const std::filesystem::path &file, const std::size_t most)
{
  OrdinaryFile opened(file);
  if (opened.size() > most)
    throw FileError(shown_path(file.string()) + ": is larger than any that a run writes");
  return opened.read(most);
}

bool read_pieces(const std::filesystem::path &file, const std::uintmax_t size,
                 const std::function<void(const char *piece, std::size_t n)> &use)
{
  constexpr std::uintmax_t most = 1 << 16;
  OrdinaryFile opened(file);
  std::vector<char> piece(std::min(most, size));
  std::uintmax_t left = size;
  while (left > 0)
  {
    const std::size_t n = opened.read(piece.data(), std::min(most, left));
    if (n == 0)
      break;
    use(piece.data(), n);
    left -= n;
  }
  return left == 0;
}

std::string head(const std::filesystem::path &file, const std::size_t size)
{
  std::string text;
  read_pieces(file, size, [&](const char *const piece, const std::size_t n) { text.append(piece, n); });
  return text;
}

std::string tail(const std::filesystem::path &file, const std::size_t size)
{
  OrdinaryFile opened(file);
  opened.go_to(opened.size() - std::min<std::uintmax_t>(opened.size(), size));
  return opened.read(size);
}

void rename(const std::filesystem::path &from, const std::filesystem::path &to)
{
  if (::rename(from.c_str(), to.c_str()) != 0)
    fail(to, "cannot be written", errno);
}

void cut(const std::filesystem::path &file, const std::uintmax_t size)
{
  const Descriptor descriptor(file, O_WRONLY | O_NOFOLLOW, "cannot be written");
  descriptor.ordinary_size();
  if (!descriptor.cut(size))
    fail(file, "cannot be written", errno);
}

Identity identity(const std::filesystem::path &file)
{
  struct stat status
  {
  };
  return ::stat(file.c_str(), &status) == 0 ? Identity(status.st_dev, status.st_ino) : Identity();
}

void synchronize(const std::filesystem::path &file)
{
  const Descriptor descriptor(file, O_RDONLY, "cannot be written");
  // Some file systems have nothing to do for folders and answer EINVAL.
  if (::fsync(descriptor.number()) != 0 && errno != EINVAL)
    fail(file, "cannot be written", errno);
}

/// Locks a file in the folder instead: network file systems lock only what is open for writing, and so no
/// folders.
static FolderLock lock_file(const std::filesystem::path &file)
{
  const int descriptor =
      ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, readable_by_all);
  if (descriptor < 0)
    fail(file, "cannot be written", errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
    return {descriptor, false};
  ::close(descriptor);
  return {-1, true};
}

FolderLock lock_folder(const std::filesystem::path &folder)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    fail(folder, "cannot be opened", errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return {descriptor, false};
  const bool is_taken = errno == EWOULDBLOCK;
  ::close(descriptor);
  return is_taken ? FolderLock{-1, true} : lock_file(folder / ".lock");
}

void close(const int descriptor)
{
  if (descriptor >= 0)
    ::close(descriptor);
}
} // namespace orthocone::posix
