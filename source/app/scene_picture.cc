// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene_picture.h"

#include "shipped_scenes.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// A file without a name, which vanishes with this object. What is written there can be read by a process
/// that is started later, however long it is, whereas a pipe would be full.
class ScratchFile
{
public:
  ScratchFile()
      : file_(std::tmpfile())
  {
    if (file_ == nullptr)
      throw FileError(std::string("--picture: no temporary file can be made (") + std::strerror(errno) + ")");
  }
  ~ScratchFile() { std::fclose(file_); }
  ScratchFile(const ScratchFile &) = delete;
  ScratchFile &operator=(const ScratchFile &) = delete;

  int descriptor() const { return ::fileno(file_); }

  void write(const std::string &text)
  {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
      throw FileError(std::string("--picture: the temporary file cannot be written (") +
                      std::strerror(errno) + ")");
    std::rewind(file_);
  }

  std::string content()
  {
    constexpr std::size_t most = 10000;
    std::string text(most, '\0');
    std::rewind(file_);
    text.resize(std::fread(text.data(), 1, most, file_));
    return text;
  }

private:
  std::FILE *file_;
};

fs::path folder_of_tools()
{
  const fs::path beside_scenes = folder_of_shipped_scenes().parent_path() / "tools";
  if (!fs::is_regular_file(beside_scenes / "scene/scene.py"))
    throw FileError("--picture: the program that draws it is not in " + shown_path(beside_scenes.string()) +
                    "/scene");
  return beside_scenes;
}

/// Runs a program to its end, with a file as standard input and one for what it prints as errors. Returns
/// its exit code, or -1 where it could not be started or did not end by itself.
int run_tool(const std::vector<std::string> &words, const int input, const int errors)
{
  std::vector<char *> argv;
  for (const std::string &word : words)
    argv.push_back(const_cast<char *>(word.c_str())); // as posix_spawn asks for it; it changes nothing
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, errors, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  pid_t child = -1;
  const int fault = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (fault != 0)
    return -1;
  int status = -1;
  pid_t ended = -1;
  do
    ended = ::waitpid(child, &status, 0);
  while (ended == -1 && errno == EINTR); // a signal that the program itself has caught
  return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The last line that is not empty: of a Python program it says what is wrong. The name of the program in
/// front means nothing to users.
std::string last_line(const std::string &text)
{
  const std::string name = "scene: ";
  std::string last;
  for (const std::string &line : split(text, '\n'))
    last = line.empty() ? last : line;
  return last.rfind(name, 0) == 0 ? last.substr(name.size()) : last;
}
} // namespace

bool is_name_of_picture(const std::string &file)
{
  const std::string ending = fs::path(file).extension().string();
  return ending == ".svg" || ending == ".png";
}

void draw_scene(const std::string &description, const std::string &title, const std::string &file)
{
  const fs::path tools = folder_of_tools();
  ScratchFile input, errors;
  input.write(description);
  const int code = run_tool({(tools / "python").string(), "numpy,matplotlib",
                             (tools / "scene/scene.py").string(), "--title", title, "--output", file},
                            input.descriptor(), errors.descriptor());
  if (code != 0)
  {
    const std::string why = last_line(errors.content());
    throw FileError("--picture: " + (why.empty() ? "the program that draws it did not end well" : why));
  }
}
} // namespace orthocone
