// Copyright the limpet authors. GPL-3.0-or-later.
#include "table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace limpet::benchmarks {
namespace {

std::string grouped(std::string digits) {
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), 1, ',');
  return digits;
}

/// To so many significant digits, but never without those before the point.
std::string number_text(double number, int digits) {
  const int before = number == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", std::clamp(digits - before, 0, 6), number);
  return text.data();
}

std::string cell_text(const Json& cell, int digits) {
  if (cell.is_null()) return "";
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_number_float()) {
    const auto number = cell.get<double>();
    return number < 1000 ? number_text(number, digits) : grouped(number_text(number, digits));
  }
  if (cell.is_boolean()) return cell.get<bool>() ? "yes" : "no";
  return grouped(cell.dump());
}

/// Characters, not bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
  const std::string space(width - width_of(text), ' ');
  return to_the_right ? space + text : text + space;
}

}  // namespace

std::string Table::markdown() const {
  std::vector<std::vector<std::string>> texts(1);
  for (const Column& c : columns_) {
    texts[0].push_back(c.name);
    std::replace(texts[0].back().begin(), texts[0].back().end(), '_', ' ');
  }
  for (const auto& row : rows_) {
    auto& text = texts.emplace_back();
    for (std::size_t c = 0; c < columns_.size(); ++c) text.push_back(cell_text(row[c], columns_[c].digits));
  }
  std::string head, rule, body;
  for (std::size_t r = 0; r < texts.size(); ++r) {
    std::string& line = r == 0 ? head : body;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      std::size_t width = 3;
      for (const auto& text : texts) width = std::max(width, width_of(text[c]));
      const bool is_number =
          std::any_of(rows_.begin(), rows_.end(), [&](const auto& row) { return row[c].is_number(); });
      line.append("| ").append(padded(texts[r][c], width, is_number)).append(" ");
      if (r == 0) rule.append("|").append(width + 1, '-').append(1, is_number ? ':' : '-');
    }
    line.append("|\n");
  }
  return head.append(rule).append("|\n").append(body);
}

Json Table::json() const {
  Json rows = Json::array();
  for (const auto& cells : rows_) {
    Json row;
    for (std::size_t c = 0; c < columns_.size(); ++c) row[columns_[c].name] = cells[c];
    rows.push_back(row);
  }
  return rows;
}

void Table::write_csv(const std::string& path) const {
  std::ofstream file(path);
  const auto write = [&](const auto& cells, auto text_of) {
    for (std::size_t c = 0; c < cells.size(); ++c) file << (c ? "," : "") << text_of(cells[c]);
    file << '\n';
  };
  write(columns_, [](const Column& c) { return c.name; });
  for (const auto& row : rows_) write(row, [](const Json& c) { return c.is_null() ? "" : c.dump(); });
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace limpet::benchmarks
