// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "process.hpp"

namespace limpet::benchmarks {

/// Rows of words and numbers: Markdown that can be read as it stands, and CSV that loses nothing.
class Table {
 public:
  struct Column {
    std::string name;  ///< of the CSV's column; in Markdown without underscores
    int digits = 3;    ///< significant ones in Markdown, not counting those before the point
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}
  /// A cell for each column, in their order; null where there is nothing to say.
  void add(std::vector<Json> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  std::string markdown() const;
  /// A list of rows, each an object of its cells by their columns' names.
  Json json() const;
  /// Throws std::runtime_error if the file cannot be written.
  void write_csv(const std::string& path) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Json>> rows_;
};

}  // namespace limpet::benchmarks
