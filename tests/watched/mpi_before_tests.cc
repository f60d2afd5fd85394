// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Where sanitizers watch, MPI starts before all tests of a binary, unwatched: whichever of them needs it
// first would be said to leak what MPI does not free.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdlib>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace orthocone::test
{
namespace
{
class MpiBeforeTests : public ::testing::Environment
{
public:
  void SetUp() override
  {
#ifdef __SANITIZE_ADDRESS__
    const __lsan::ScopedDisabler unwatched;
#endif
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0); // no daemon beside a single process
    MPI_Init(nullptr, nullptr);
  }
};

// gtest owns it.
::testing::Environment *const mpi_before_tests = ::testing::AddGlobalTestEnvironment(new MpiBeforeTests);
} // namespace
} // namespace orthocone::test
