// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/error.hpp>
#include <limpet/io/scan_columns.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

constexpr std::size_t kMaxColumns = 256;

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r,;");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

std::vector<std::string> tokens_of(std::string_view line) {
  std::vector<std::string> tokens;
  for (auto token = next_token(line, true); !token.empty(); token = next_token(line, true)) {
    tokens.emplace_back(token);
  }
  return tokens;
}

class TableReader final : public ScanReader {
 public:
  TableReader(SourcePtr source, const ScanOptions& options) : source_(std::move(source)), options_(options) {}

  std::int64_t promised() const override { return promised_; }

  bool next(ScanRecord& record) override {
    std::string_view line;
    while (source_->line(line)) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (is_comment(line)) {
        if (!columns_) read_names(line);
        continue;
      }
      if (!columns_ && !begin(line)) continue;
      read_row(line);
      if (++rows_ > promised_ && promised_ >= 0) {
        throw InputError(source_->here_line(),
                         "more points than the " + std::to_string(promised_) + " the first line promises");
      }
      if (columns_->make(row_, record)) return true;
      ++skipped_;
    }
    if (rows_ < promised_) {
      throw InputError(source_->here_line(), "the file ends after " + std::to_string(rows_) + " of the " +
                                                 std::to_string(promised_) +
                                                 " points its first line promises");
    }
    return false;
  }

 private:
  /// A comment or a first line of words names the columns when it has x, y and z among them.
  bool read_names(std::string_view line) {
    while (line.starts_with('#') || line.starts_with('/')) line.remove_prefix(1);
    std::vector<std::string> names = tokens_of(line);
    for (std::string& name : names) {
      std::erase(name, '"');
      if (name == "X" || name == "Y" || name == "Z") name[0] = static_cast<char>(name[0] - 'A' + 'a');
    }
    const auto has = [&](const char* name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!has("x") || !has("y") || !has("z") || names.size() > kMaxColumns) return false;
    names_ = std::move(names);
    return true;
  }

  /// Colours where normals could be: whole numbers up to 255, larger than any normal's.
  static bool is_colour(const std::vector<std::string>& tokens) {
    std::int64_t largest = 0;
    for (std::size_t i = 3; i < 6; ++i) {
      std::int64_t value = 0;
      if (!parse_integer(tokens[i], value) || value < 0 || value > 255) return false;
      largest = std::max(largest, value);
    }
    return largest > 9;
  }

  /// Settles the columns by the first line of numbers; false when that line is a count of the points.
  bool begin(std::string_view line) {
    const std::vector<std::string> tokens = tokens_of(line);
    if (tokens.size() == 1 && promised_ < 0) {
      if (parse_integer(tokens[0], promised_) && promised_ >= 0) return false;
    }
    double number = 0;
    if (names_.empty() && !tokens.empty() && !parse_double(tokens[0], number) && read_names(line))
      return false;
    if (tokens.size() < 3 || tokens.size() > kMaxColumns) {
      throw InputError(source_->here_line(),
                       "expected 'x y z' or 'x y z nx ny nz', found " + in_quotes(line));
    }
    width_ = tokens.size();
    if (names_.size() != width_) {
      names_ = {"x", "y", "z"};
      if (width_ >= 6 && !is_colour(tokens)) names_.insert(names_.end(), {"nx", "ny", "nz"});
      names_.resize(width_);
    }
    columns_.emplace(names_, options_, source_->here_line());
    for (std::size_t i = 0; i < width_; ++i) roles_.push_back(columns_->role(i));
    return true;
  }

  void read_row(std::string_view line) {
    for (std::size_t i = 0; i < width_; ++i) {
      const std::string_view token = next_token(line, true);
      double value = 0;
      if (token.empty()) {
        throw InputError(source_->here_line(), std::to_string(i) + " numbers where the first line has " +
                                                   std::to_string(width_) +
                                                   (source_->at_end() ? " (truncated?)" : ""));
      }
      if (!parse_double(token, value))
        throw InputError(source_->here_line(), in_quotes(token) + " is not a number");
      if (roles_[i] != ScanColumns::kRoles) row_[roles_[i]] = value;
    }
    if (const auto token = next_token(line, true); !token.empty()) {
      throw InputError(source_->here_line(),
                       in_quotes(token) + " after the " + std::to_string(width_) + " numbers of a line");
    }
  }

  SourcePtr source_;
  ScanOptions options_;
  std::vector<std::string> names_;
  std::vector<ScanColumns::Role> roles_;
  std::optional<ScanColumns> columns_;
  std::size_t width_ = 0;
  std::int64_t rows_ = 0, promised_ = -1;
  ScanColumns::Row row_{};
};

}  // namespace

std::unique_ptr<ScanReader> open_table(SourcePtr source, const ScanOptions& options) {
  return std::make_unique<TableReader>(std::move(source), options);
}

}  // namespace limpet::io
