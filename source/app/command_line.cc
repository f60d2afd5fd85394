// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "command_line.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <boost/program_options.hpp>

#include <sstream>

namespace orthocone
{
namespace
{
namespace po = boost::program_options;

po::options_description visible_options()
{
  po::options_description options("options");
  options.add_options()("set", po::value<std::vector<std::string>>(),
                        "\"Section/Entry=value\": overrides one entry; may be repeated")(
      "output,o", po::value<std::string>(), "run folder (default: output/<parameter file's stem>)")(
      "check", "read everything, print the resolved model, compute nothing")(
      "resume", "continue from the checkpoint in the run folder")(
      "threads", po::value<std::string>(),
      "threads of BLAS (default: one for each core that nobody else is busy on)")(
      "insist", "run even if the memory is likely not to suffice")(
      "batch",
      "run command lines from standard input, each a line such as [\"FILE.prm\", \"--quiet\"], without the "
      "time of a start (tools/sweep does)")("quiet,q", "print errors only")(
      "list", "print the scenes that come with the program, a line each, and stop")(
      "defaults", "print a complete commented parameter file and stop")(
      "columns", "print name, unit and meaning of every column and field of the results and stop")(
      "help,h", "print this text and stop")("version",
                                            "print the versions of program and libraries and stop");
  return options;
}

unsigned int threads_from(const std::string &text)
{
  constexpr unsigned int most = 1024;
  const auto number = parse_count(text);
  if (!number || *number < 1 || *number > most)
    throw InputError("command line: --threads = " + shown(text) + ": allowed is a whole number from 1 to " +
                     std::to_string(most));
  return *number;
}

CommandLine from(const po::variables_map &values)
{
  CommandLine line;
  if (values.count("set") != 0)
    line.overrides = values["set"].as<std::vector<std::string>>();
  if (values.count("output") != 0)
    line.output_folder = values["output"].as<std::string>();
  if (values.count("file") != 0)
    line.parameter_file = values["file"].as<std::string>();
  if (values.count("threads") != 0)
    line.threads = threads_from(values["threads"].as<std::string>());
  line.batch = values.count("batch") != 0;
  line.check = values.count("check") != 0;
  line.resume = values.count("resume") != 0;
  line.insist = values.count("insist") != 0;
  line.quiet = values.count("quiet") != 0;
  line.defaults = values.count("defaults") != 0;
  line.list = values.count("list") != 0;
  line.columns = values.count("columns") != 0;
  line.help = values.count("help") != 0;
  line.version = values.count("version") != 0;
  return line;
}
} // namespace

/// Whether an option that needs a value is followed by another option.
static bool is_followed_by_option(const std::string &option, const int argc, const char *const *const argv)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == option && argv[i + 1][0] == '-')
      return true;
  return false;
}

CommandLine parse_command_line(const int argc, const char *const *const argv)
{
  po::options_description all;
  all.add(visible_options()).add_options()("file", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("file", 1);
  po::variables_map values;
  try
  {
    // Abbreviations are not allowed, because an option that is added later must not change the meaning of a
    // script.
    constexpr auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              values);
  }
  catch (const po::error &error)
  {
    throw InputError(std::string("command line: ") + shown(error.what()) +
                     "; 'orthocone --help' lists the options");
  }
  CommandLine line = from(values);
  if (values.count("output") != 0 &&
      (line.output_folder.empty() || is_followed_by_option("--output", argc, argv) ||
       is_followed_by_option("-o", argc, argv)))
    throw InputError(
        "command line: --output = '" + shown(line.output_folder) +
        "': allowed is the name of a folder (one that begins with '-' is written behind '--output=')");
  if (line.batch && argc > 2)
    throw InputError("command line: --batch stands alone; files and options come from standard input");
  if (line.parameter_file.empty() && !line.batch && !line.prints())
    throw InputError(
        "command line: a parameter file is missing, as in 'orthocone prm/paper/case_b.prm'; 'orthocone "
        "--list' lists those that come with the program, 'orthocone --help' the options");
  return line;
}

std::string usage()
{
  std::ostringstream text;
  text << "Usage: orthocone [options] FILE.prm\n\n"
       << "Elastic bodies in contact under cyclic loads, with orthotropic friction and a slip rule of its "
          "own.\n\n"
       << visible_options()
       << "\nexample: orthocone prm/paper/case_b.prm --set \"Mesh/Resolution=fine\" -o output/fine\n"
       << "\nexit codes: 0 done, 2 wrong command line or parameter file, 3 a load step could not "
       << "be solved or failed a check,\n            4 a file could not be read or written, 130 interrupted "
          "(--resume goes "
          "on)\n";
  return text.str();
}
} // namespace orthocone
