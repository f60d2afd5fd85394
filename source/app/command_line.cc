// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "command_line.h"

#include "scene_picture.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <boost/program_options.hpp>

#include <sstream>

namespace orthocone
{
namespace
{
namespace po = boost::program_options;

unsigned int threads_from(const std::string &text)
{
  constexpr unsigned int most = 1024;
  const auto number = parse_count(text);
  if (!number || *number < 1 || *number > most)
    throw InputError("command line: --threads = " + shown(text) + ": allowed is a whole number from 1 to " +
                     std::to_string(most));
  return *number;
}

unsigned int jobs_from(const std::string &text)
{
  constexpr unsigned int most = 400; // two files each, of usually 1024
  const auto number = parse_count(text);
  if (!number || *number < 1 || *number > most)
    throw InputError("command line: --jobs = " + shown(text) + ": allowed is a whole number from 1 to " +
                     std::to_string(most));
  return *number;
}

/// The options, whose values go to `line`.
po::options_description options_of(CommandLine &line)
{
  po::options_description options("options");
  const auto add = [&](const char *const words, const po::value_semantic *const value, const char *const help)
  { options.add_options()(words, value, help); };
  const auto add_switch = [&](const char *const words, bool &is_set, const char *const help)
  { add(words, po::bool_switch(&is_set), help); };
  add("set", po::value(&line.overrides), "\"Section/Entry=value\": overrides one entry; may be repeated");
  add("output,o", po::value(&line.output_folder), "run folder (default: output/<parameter file's stem>)");
  add_switch("check", line.check, "read all input, print the model as it would be computed, and stop");
  add("picture", po::value(&line.picture),
      "with --check: draw the scene with its mesh, loads and gap to this file, a .svg or .png");
  add_switch("resume", line.resume, "continue from the checkpoint in the run folder");
  add("threads",
      po::value<std::string>()->notifier([&](const std::string &text) { line.threads = threads_from(text); }),
      "threads of BLAS (default: one for each core that no other program uses)");
  add_switch("insist", line.insist, "run even if the memory will probably not suffice");
  add_switch("batch", line.batch,
             "run the command lines on standard input, each a line such as [\"FILE.prm\", \"--quiet\"], in "
             "one process, which saves their starts (tools/sweep uses it)");
  add("jobs",
      po::value<std::string>()->notifier([&](const std::string &text) { line.jobs = jobs_from(text); }),
      "with --batch: run so many lines at a time, and answer each with its number when it ends");
  add_switch("quiet,q", line.quiet, "print errors only");
  add_switch("list", line.list, "print the scenes that come with the program, a line each, and stop");
  add("new", po::value(&line.rig),
      "copy the rig of this name to the new file FILE.prm and stop; --list names them (prm/rigs)");
  add_switch("defaults", line.defaults, "print a complete commented parameter file and stop");
  add_switch("schema", line.schema, "print a JSON schema of parameter files, for editors, and stop");
  add_switch("columns", line.columns,
             "print name, unit and meaning of every column and field of the results and stop");
  add_switch("help,h", line.help, "print this text and stop");
  add_switch("version", line.version, "print the versions of program and libraries and stop");
  return options;
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

/// Throws InputError where the option --picture has no name of a picture, or no --check.
static void check_picture(const CommandLine &line)
{
  const std::string given = "command line: --picture = '" + shown(line.picture) + "'";
  if (!is_name_of_picture(line.picture) || line.picture[0] == '-')
    throw InputError(given + ": allowed is the name of a file that ends in .svg or .png, as in 'orthocone "
                             "--check --picture scene.svg my.prm'");
  if (!line.check)
    throw InputError(given + " without --check: allowed is 'orthocone --check --picture scene.svg my.prm', "
                             "which draws the scene and computes nothing");
}

/// Throws InputError where --batch has another option than --jobs, or --jobs stands without it.
static void check_batch(const CommandLine &line, const int argc)
{
  if (line.jobs > 0 && !line.batch)
    throw InputError("command line: --jobs = " + std::to_string(line.jobs) +
                     " without --batch: allowed is 'orthocone --batch --jobs N'");
  if (line.batch && argc > (line.jobs == 0 ? 2 : 4))
    throw InputError("command line: --batch stands alone, or with --jobs N; files and options come from "
                     "standard input");
}

CommandLine parse_command_line(const int argc, const char *const *const argv)
{
  CommandLine line;
  po::options_description all = options_of(line);
  all.add_options()("file", po::value(&line.parameter_file));
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
    po::notify(values);
  }
  catch (const po::error &error)
  {
    throw InputError(std::string("command line: ") + shown(error.what()) +
                     "; 'orthocone --help' lists the options");
  }
  if (values.count("output") != 0 &&
      (line.output_folder.empty() || is_followed_by_option("--output", argc, argv) ||
       is_followed_by_option("-o", argc, argv)))
    throw InputError(
        "command line: --output = '" + shown(line.output_folder) +
        "': allowed is the name of a folder (one that begins with '-' is written behind '--output=')");
  if (values.count("new") != 0 && line.rig.empty())
    throw InputError("command line: --new = '': allowed is the name of a rig, as in 'orthocone --new "
                     "sphere_on_flat my.prm'");
  if (values.count("picture") != 0)
    check_picture(line);
  check_batch(line, argc);
  if (line.parameter_file.empty() && line.rig.empty() && !line.batch && !line.prints())
    throw InputError(
        "command line: a parameter file is missing, as in 'orthocone prm/paper/case_b.prm'; 'orthocone "
        "--list' lists those that come with the program, 'orthocone --help' the options");
  return line;
}

std::string usage()
{
  CommandLine unused;
  std::ostringstream text;
  text << "Usage: orthocone [options] FILE.prm\n\n"
       << "Computes contact of elastic bodies under cyclic loads, with orthotropic friction and a slip rule "
          "of its own.\n\n"
       << options_of(unused)
       << "\nexample: orthocone prm/paper/case_b.prm --set \"Mesh/Resolution=fine\" -o output/fine\n"
       << "\nexit codes: 0 done, 2 wrong command line or parameter file, 3 a load step could not "
       << "be solved or failed a check,\n            4 a file could not be read or written, 130 interrupted "
          "(--resume goes "
          "on)\n";
  return text.str();
}
} // namespace orthocone
