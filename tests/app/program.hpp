// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "../temporary_folder.hpp"

namespace limpet::app::testing {

struct Result {
  int code = 0;  ///< exit code; minus the signal's number when one ended the program
  std::string out, err;
  long error_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

struct Surroundings {
  std::string folder;                                          ///< to run in; empty: here
  std::vector<std::pair<std::string, std::string>> variables;  ///< of the environment
  std::string input;                                           ///< a file for standard input; empty: nothing
  int output = -1;  ///< a descriptor for standard output; -1: a file
};

/// A test with a folder of its own, gone when it ends, and the program to run in it.
class ProgramTest : public limpet::testing::TemporaryFolder {
 protected:
  /// Starts the program; what it says goes to files.
  pid_t start(const std::vector<std::string>& arguments, const Surroundings& around = {}) const {
    const pid_t child = ::fork();
    if (child == 0) {
      std::vector<char*> argv{const_cast<char*>("limpet")};
      for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
      argv.push_back(nullptr);
      for (const auto& [name, value] : around.variables) ::setenv(name.c_str(), value.c_str(), 1);
      if (!around.folder.empty() && ::chdir(around.folder.c_str()) != 0) ::_exit(126);
      redirect(around.input.empty() ? "/dev/null" : around.input, O_RDONLY, STDIN_FILENO);
      redirect(path("stdout"), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
      if (around.output >= 0 && ::dup2(around.output, STDOUT_FILENO) < 0) ::_exit(125);
      redirect(path("stderr"), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
      ::execv(LIMPET_PROGRAM, argv.data());
      ::_exit(127);
    }
    return child;
  }

  Result finish(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read(path("stdout")),
            read(path("stderr"))};
  }

  Result run(const std::vector<std::string>& arguments, const Surroundings& around = {}) const {
    return finish(start(arguments, around));
  }

  /// A small scan of a shape; its name.
  std::string scan(const std::string& name, const std::string& shape, long points,
                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"scan", shape, "-o", path(name), "--points", std::to_string(points)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return path(name);
  }

  /// One line that begins with the program's name, exit code 2, never a crash.
  static void expect_refused(const Result& result, const std::string& part) {
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_EQ(result.error_lines(), 1) << result.err;
    EXPECT_TRUE(result.err.starts_with("limpet: ")) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("bug"), std::string::npos) << result.err;
  }

 private:
  static void redirect(const std::string& path, int flags, int to) {
    const int file = ::open(path.c_str(), flags, 0644);
    if (file < 0 || ::dup2(file, to) < 0) ::_exit(125);
    ::close(file);
  }
};

}  // namespace limpet::app::testing
