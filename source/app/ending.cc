// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "ending.h"

#include <orthocone/base/text.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <new>
#include <sstream>

namespace orthocone
{
Ending ending_of_exception()
{
  try
  {
    throw;
  }
  catch (const InputError &error)
  {
    return {ExitCode::wrong_input, error.what()};
  }
  catch (const FileError &error)
  {
    return {ExitCode::file_error, error.what()};
  }
  catch (const std::filesystem::filesystem_error &error)
  {
    return {ExitCode::file_error, shown_path(error.path1().string()) + ": " + error.code().message()};
  }
  catch (const dealii::ExceptionBase &error) // what() draws a box
  {
    std::ostringstream text;
    error.print_info(text);
    return {ExitCode::unsolved_step, trimmed(text.str())};
  }
  catch (const std::bad_alloc &)
  {
    return {ExitCode::unsolved_step, "memory runs out; a coarser mesh or a reduced Mesh/Model needs less"};
  }
  catch (const std::exception &error)
  {
    return {ExitCode::unsolved_step, error.what()};
  }
}
} // namespace orthocone
