// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "posix_file.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
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

/// An open file that is closed at the end of its scope.
class Descriptor
{
public:
  Descriptor(const std::filesystem::path &file, const int flags, const char *const task)
      : file_(file),
        task_(task),
        descriptor_(::open(file.c_str(), flags | O_CLOEXEC, readable_by_all))
  {
    if (descriptor_ < 0)
      fail(file_, task_, errno);
  }
  ~Descriptor() { posix::close(descriptor_); }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;

  int number() const { return descriptor_; }

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

std::uintmax_t append(const std::filesystem::path &file, const std::string &content,
                      const std::optional<std::uintmax_t> size)
{
  if (size && ::access(file.c_str(), F_OK) != 0)
    throw FileError(shown_path(file.string()) + ": was removed during the run");
  Descriptor descriptor(file, O_WRONLY | O_APPEND | O_NOFOLLOW | (size ? 0 : O_CREAT), "cannot be written");
  struct stat before
  {
  };
  if (::fstat(descriptor.number(), &before) != 0)
    fail(file, "cannot be written", errno);
  if (size && static_cast<std::uintmax_t>(before.st_size) != *size)
    throw FileError(shown_path(file.string()) + ": was changed during the run by something else");
  try
  {
    descriptor.write_all(content);
    descriptor.close();
  }
  catch (const FileError &)
  {
    if (::truncate(file.c_str(), before.st_size) != 0)
      throw FileError(shown_path(file.string()) + ": ends with half a line, which cannot be removed (" +
                      std::strerror(errno) + ")");
    throw;
  }
  return static_cast<std::uintmax_t>(before.st_size) + content.size();
}

std::string read(const std::filesystem::path &file)
{
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream)
    fail(file, "cannot be read", errno != 0 ? errno : EIO);
  return content.str();
}

bool read_pieces(const std::filesystem::path &file, const std::uintmax_t size,
                 const std::function<void(const char *piece, std::size_t n)> &use)
{
  constexpr std::uintmax_t most = 1 << 16;
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> piece(std::min(most, size));
  std::uintmax_t left = size;
  while (left > 0 &&
         stream.read(piece.data(), static_cast<std::streamsize>(std::min(most, left))).gcount() > 0)
  {
    use(piece.data(), static_cast<std::size_t>(stream.gcount()));
    left -= static_cast<std::uintmax_t>(stream.gcount());
  }
  if (!stream.is_open() || stream.bad())
    fail(file, "cannot be read", errno != 0 ? errno : EIO);
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
  errno = 0;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const auto end = static_cast<std::streamoff>(stream.tellg());
  const auto n = std::min(end, static_cast<std::streamoff>(size));
  std::string text(std::max<std::streamoff>(n, 0), '\0');
  if (!stream.seekg(end - n) || !stream.read(text.data(), n))
    fail(file, "cannot be read", errno != 0 ? errno : EIO);
  return text;
}

void rename(const std::filesystem::path &from, const std::filesystem::path &to)
{
  if (::rename(from.c_str(), to.c_str()) != 0)
    fail(to, "cannot be written", errno);
}

void cut(const std::filesystem::path &file, const std::uintmax_t size)
{
  if (::truncate(file.c_str(), static_cast<off_t>(size)) != 0)
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
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, readable_by_all);
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
