// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The reader of checkpoints: any bytes give a checkpoint that can be written again, or CheckpointError. The
// input is read as it is, and as the content behind a header that fits: no fuzzer guesses a checksum.
#include <orthocone/output/checkpoint.h>

#include <boost/crc.hpp>

#include <cstdint>
#include <cstdlib>

using namespace orthocone;

namespace
{
void read(const std::string &bytes)
{
  try
  {
    const std::string again = encode(decode(bytes));
    if (encode(decode(again)) != again)
      std::abort();
  }
  catch (const CheckpointError &)
  {
  }
}

std::string with_header(const std::string &content)
{
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return "orthocone-checkpoint " + std::to_string(checkpoint_format) + " " + std::to_string(content.size()) +
         " " + std::to_string(crc.checksum()) + "\n" + content;
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *const data, const std::size_t size)
{
  const std::string bytes(reinterpret_cast<const char *>(data), size);
  read(bytes);
  read(with_header(bytes));
  return 0;
}
