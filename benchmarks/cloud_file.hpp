// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>

#include "sections.hpp"

/// What the processes of a measurement hand each other.
namespace limpet::benchmarks {

/// A cloud for the processes to read: a file without a name, so that nothing is left of it whatever happens.
class CloudFile {
 public:
  /// Throws std::runtime_error if there is no cloud.
  CloudFile(const CloudSpec&, const Limits&);
  ~CloudFile();
  CloudFile(const CloudFile&) = delete;
  CloudFile& operator=(const CloudFile&) = delete;

  /// As the processes see it, which inherit it.
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  /// "points", "faces", "resolution".
  const Json& answer() const { return answer_; }

 private:
  int descriptor_;
  Json answer_;
};

/// A place for what a process leaves to others: a mesh, a scan. It has a name, since the name's ending
/// (".off") tells the format, for as long as this object lives.
class NamedFile {
 public:
  NamedFile(const Limits&, const std::string& ending);
  ~NamedFile();
  NamedFile(const NamedFile&) = delete;
  NamedFile& operator=(const NamedFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace limpet::benchmarks
