// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "metis_order.h"

#include <fcntl.h>
#include <metis.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace orthocone
{
namespace
{
static_assert(std::is_same<idx_t, int>::value, "CHOLMOD's indices are METIS'");

/// Memory that is shared with a child process.
class SharedArray
{
public:
  explicit SharedArray(const std::size_t n)
      : bytes_(std::max<std::size_t>(n, 1) * sizeof(int)),
        memory_(::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if (memory_ == MAP_FAILED)
      throw std::bad_alloc();
  }
  ~SharedArray() { ::munmap(memory_, bytes_); }
  SharedArray(const SharedArray &) = delete;
  SharedArray &operator=(const SharedArray &) = delete;

  int *begin() const { return static_cast<int *>(memory_); }

private:
  std::size_t bytes_;
  void *memory_;
};

int dissect(std::vector<int> &starts, std::vector<int> &neighbours, int *const order)
{
  idx_t n = static_cast<idx_t>(starts.size()) - 1;
  std::vector<idx_t> inverse(n);
  return METIS_NodeND(&n, starts.data(), neighbours.data(), nullptr, nullptr, order, inverse.data());
}

/// The work of the child: it dies with its parent, prints nothing, and returns METIS' result as its exit
/// code.
[[noreturn]] void dissect_and_exit(std::vector<int> &starts, std::vector<int> &neighbours, int *const order)
{
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0)
  {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  int result = METIS_ERROR_MEMORY;
  try
  {
    result = dissect(starts, neighbours, order);
  }
  catch (const std::bad_alloc &)
  {
  }
  ::_exit(result == METIS_OK ? 0 : result == METIS_ERROR_MEMORY ? 1 : 2);
}

/// METIS' result, from how the child ended. A child that is killed was most likely the largest process of a
/// machine without memory.
int result_of(const pid_t child)
{
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      return METIS_ERROR;
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGKILL ? METIS_ERROR_MEMORY : METIS_ERROR;
  return WEXITSTATUS(status) == 0 ? METIS_OK : WEXITSTATUS(status) == 1 ? METIS_ERROR_MEMORY : METIS_ERROR;
}
} // namespace

void order_by_metis(std::vector<int> &starts, std::vector<int> &neighbours, std::vector<int> &order)
{
  const std::size_t n = starts.size() - 1;
  const SharedArray shared(n);
  const pid_t child = ::fork();
  if (child == 0)
    dissect_and_exit(starts, neighbours, shared.begin());
  // Where no process can be made, METIS runs here.
  const int result = child < 0 ? dissect(starts, neighbours, shared.begin()) : result_of(child);
  if (result == METIS_ERROR_MEMORY)
    throw std::bad_alloc();
  if (result != METIS_OK)
    throw std::runtime_error("ordering the stiffness: METIS fails");
  std::copy_n(shared.begin(), n, order.begin());
}
} // namespace orthocone
