// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "table.hpp"

namespace limpet::benchmarks {

/// A report in a folder: report.md, and a .md and a .csv for each table. Parts are kept in files of their
/// own, so that one can be measured anew; report.md is all of them, in their order.
class ReportPage {
 public:
  /// `commit` as it is to be named; `head` is what report.md begins with; `parts` are the tables' names, in
  /// order. Makes the folder if need be.
  ReportPage(std::string folder, const std::string& commit, std::string head, std::vector<std::string> parts);

  /// Throws std::runtime_error if a file cannot be written.
  void add(const std::string& title, const std::string& said, const Table& table, const std::string& name,
           bool has_picture = false);
  const std::string& folder() const { return folder_; }

 private:
  void write(const std::string& name, const std::string& text) const;

  std::string folder_, where_, head_;
  std::vector<std::string> parts_;
};

}  // namespace limpet::benchmarks
