// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The reader of parameter files: any bytes give parameters, or one of the two errors with a message of one
// line. Parameters that are accepted are also checked, and read again from what is written of them.
#include <orthocone/base/errors.h>
#include <orthocone/scene/parameters.h>

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace orthocone;

namespace
{
namespace fs = std::filesystem;

/// A file of the fuzzer's own, in memory where the system has such a folder.
fs::path own_file(const std::string &ending)
{
  const fs::path memory = "/dev/shm";
  const fs::path folder = fs::exists(memory) ? memory : fs::temp_directory_path();
  return folder / ("orthocone-fuzz-" + std::to_string(getpid()) + ending);
}

void require(const bool condition)
{
  if (!condition)
    std::abort();
}

std::string written(const Parameters &parameters)
{
  std::ostringstream text;
  write_parameters(parameters, text);
  return text.str();
}

void read(const std::string &file)
{
  try
  {
    const Parameters parameters = read_parameters(file);
    check_parameters(parameters);
    parameter_warnings(parameters);
    const std::string text = written(parameters);
    const std::string again = own_file("-again.prm");
    std::ofstream(again) << text;
    require(written(read_parameters(again)) == text);
    fs::remove(again);
  }
  catch (const InputError &error)
  {
    require(std::string(error.what()).find('\n') == std::string::npos);
  }
  catch (const FileError &error)
  {
    require(std::string(error.what()).find('\n') == std::string::npos);
  }
}
} // namespace

/// The first byte chooses the format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *const data, const std::size_t size)
{
  if (size == 0)
    return 0;
  const fs::path file = own_file(data[0] == '{' ? ".json" : ".prm");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
  read(file.string());
  fs::remove(file);
  return 0;
}
