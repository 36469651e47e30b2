// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace limpet::testing {

/// A test with a folder of its own, gone when it ends.
class TemporaryFolder : public ::testing::Test {
 protected:
  TemporaryFolder() { std::filesystem::create_directories(folder_); }
  ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  /// Writes a file there; its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  /// All bytes of the file at `path`, wherever it is.
  static std::string read(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  /// What is in the folder, sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  /// Tests run side by side: the name says which test and which process. A test with parameters has a slash.
  static std::string own_name() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = "limpet-" + std::string(test->test_suite_name()) + "-" + test->name() + "-" +
                       std::to_string(::getpid());
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
  }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() / own_name();
};

}  // namespace limpet::testing
