// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// deal.II reads DEAL_II_NUM_THREADS while it is loaded, before main(), and a number that it does not know
// ends the process with a stack trace. So the variable is looked at earlier still: functions of an
// executable's .preinit_array come before what its libraries do (System V ABI, "Initialization and
// Termination Functions"). The C library is hardly there yet; strings and two system calls are all that is
// used.
#include <unistd.h>

#include <cstring>

namespace
{
constexpr char variable[] = "DEAL_II_NUM_THREADS=";

/// A whole number above 0 that an int holds.
bool is_number_of_threads(const char *const text)
{
  const std::size_t digits = std::strspn(text, "0123456789"), zeros = std::strspn(text, "0");
  return text[digits] == '\0' && digits > zeros && digits - zeros < 10;
}

void write(const char *const text, const std::size_t size)
{
  if (::write(STDERR_FILENO, text, size) < 0)
    return; // there is no one to tell
}

void check_thread_variable(int, char **, char **const environment)
{
  constexpr std::size_t most = 40; // of a message
  constexpr int wrong_input = 2;
  constexpr char begin[] = "orthocone: DEAL_II_NUM_THREADS = ", end[] = ": allowed is a whole number > 0\n";
  for (char **entry = environment; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, variable, sizeof variable - 1) == 0)
      if (const char *const value = *entry + sizeof variable - 1; !is_number_of_threads(value))
      {
        write(begin, sizeof begin - 1);
        write(value, strnlen(value, most));
        write(end, sizeof end - 1);
        ::_exit(wrong_input);
      }
}

__attribute__((section(".preinit_array"), used)) void (*const first)(int, char **,
                                                                     char **) = &check_thread_variable;
} // namespace
