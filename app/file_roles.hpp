// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

namespace limpet::app {

/// The files of a command by what they are for, so that none takes the place of another.
///
///     FileRoles files;
///     files.reads("SCAN", args.scan);
///     files.writes("-o", args.model);
///     files.require_apart();  // before any work
class FileRoles {
 public:
  /// "-" is standard input; an empty path is no file.
  void reads(const std::string& role, const std::string& path);
  /// "-" is standard output; an empty path is no file.
  void writes(const std::string& role, const std::string& path);
  /// A model, whose format the ending tells, and what is written beside it.
  void writes_model(const std::string& role, const std::string& path);

  /// Refuses an output that cannot be written, that is one of the inputs or another output, by whatever names
  /// (links, hard links, ./) and be it the file to which standard output goes, or that would replace a side
  /// file of another program; and standard input where it is to be read twice. Devices, as /dev/null, may be
  /// named again and again. Nothing is changed. Throws UsageError, io::OutputError.
  void require_apart() const;

 private:
  struct File {
    std::string role, path;
    bool written = false;
  };
  void require_outputs() const;

  std::vector<File> files_;
  std::vector<std::string> side_files_;
};

}  // namespace limpet::app
