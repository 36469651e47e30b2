// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <fstream>
#include <limpet/app/run_file.hpp>
#include <limpet/model/digest.hpp>
#include <string>

namespace limpet::app {

/// Records a run while it goes on (docs/run_format.md): after each set the file holds all sets so far, so
/// that a run that is killed leaves them. The file is made at the first set, over an old one. Nothing in it
/// depends on time: the same run gives the same bytes.
class RunRecord {
 public:
  RunRecord(std::string path, const RunHead&);

  /// Errors: io::OutputError.
  void add(const RunSet&);
  /// Nothing may be added afterwards. Errors: io::OutputError.
  void end(const RunEnd&);

 private:
  void begin();
  void put(const std::string& lines);
  [[noreturn]] void fail() const;

  std::string path_;
  RunHead head_;
  std::ofstream file_;
  model::Digest digest_;  ///< of the bytes so far, as they were put
  std::int64_t sets_ = 0;
};

}  // namespace limpet::app
