// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstdio>

namespace limpet::survey {

/// Points kept in a temporary file, so that standard input, which comes only once, can be gone through twice.
/// The file has no name and is gone when the program ends, however it ends; TMPDIR says where it lies.
class PointSpool {
 public:
  struct Entry {
    Eigen::Vector3d position;
    std::int64_t skipped;  ///< records passed over just before it
  };

  /// Errors: io::OutputError when no temporary file can be made.
  PointSpool();
  ~PointSpool();
  PointSpool(const PointSpool&) = delete;
  PointSpool& operator=(const PointSpool&) = delete;

  /// Errors: io::OutputError when there is no space.
  void write(const Entry& entry);
  /// From now on entries are read, from the first. Errors as of write().
  void rewind();
  /// False at the end.
  bool read(Entry& entry);

 private:
  std::FILE* file_ = nullptr;
};

}  // namespace limpet::survey
