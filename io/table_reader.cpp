// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/error.hpp>
#include <limpet/io/scan_columns.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/table_dialect.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

constexpr std::size_t kMaxColumns = 256;
constexpr std::string_view kCoordinates[] = {"x", "y", "z"};

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

/// Programs that write tables fill them up with rows that have separators only.
bool is_empty(std::string_view line) { return line.find_first_not_of(" \t,;") == std::string_view::npos; }

std::vector<std::string> tokens_of(std::string_view line) {
  std::vector<std::string> tokens;
  for (auto token = next_token(line, true); !token.empty(); token = next_token(line, true)) {
    tokens.emplace_back(token);
  }
  return tokens;
}

/// The names of columns as they are looked for: without quotes and blanks, coordinates in lower case.
std::vector<std::string> plain(std::vector<std::string> names) {
  for (std::string& name : names) {
    std::erase(name, '"');
    name = without_blanks(name);
    if (name == "X" || name == "Y" || name == "Z") name[0] = static_cast<char>(name[0] - 'A' + 'a');
  }
  return names;
}

bool has_coordinates(const std::vector<std::string>& names) {
  return std::all_of(std::begin(kCoordinates), std::end(kCoordinates), [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

class TableReader final : public ScanReader {
 public:
  TableReader(SourcePtr source, const ScanOptions& options) : source_(std::move(source)), options_(options) {}

  std::int64_t promised() const override { return promised_; }

  bool next(ScanRecord& record) override {
    std::string_view line;
    while (source_->line(line)) {
      line = without_blanks(line);
      if (line.empty()) continue;
      if (is_comment(line)) {
        read_comment(line);
        continue;
      }
      if (is_empty(line) || (!columns_ && !begin(line))) continue;
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
  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_->here_line(), what); }

  [[noreturn]] void fail_expected(std::string_view line) const {
    fail("expected 'x y z' or 'x y z nx ny nz', found " + in_quotes(line));
  }

  void read_comment(std::string_view line) {
    // Lines that end in another way than those before would be lost in it.
    if (line.find_first_of("\r\n") != std::string_view::npos)
      fail("some lines end with line feeds, others with carriage returns alone; end them all alike");
    if (columns_) return;
    line.remove_prefix(std::min(line.find_first_not_of("#/"), line.size()));
    read_names(line);
  }

  /// A comment or a first line of words names the columns when it has x, y and z among them.
  bool read_names(std::string_view line) {
    std::vector<std::string> names = plain(tokens_of(line));
    if (!has_coordinates(names) || names.size() > kMaxColumns) return false;
    names_ = std::move(names);
    names_line_ = line;
    return true;
  }

  /// Names may have blanks in them where something else separates, and some columns may have none. A comment
  /// may be anything; a line of names is not.
  void match_names(const std::vector<std::string>& tokens) {
    if (names_.size() == width_) return;
    if (!names_.empty()) {
      const auto names = plain(dialect_->fields(names_line_));
      if (names.size() == width_ && has_coordinates(names)) {
        names_ = names;
        return;
      }
      if (has_line_of_names_)
        fail(std::to_string(width_) + " numbers under " + std::to_string(names_.size()) +
             " names; name each column once");
    }
    may_be_halves_ = dialect_->could_be_halves(tokens);
    names_ = {"x", "y", "z"};
    if (width_ >= 6 && !is_colour(tokens)) names_.insert(names_.end(), {"nx", "ny", "nz"});
    names_.resize(width_);
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

  /// Settles the columns by the first line of numbers; false when that line is a count of the points, or
  /// names the columns.
  bool begin(std::string_view line) {
    const std::vector<std::string> words = tokens_of(line);
    if (words.size() == 1 && promised_ < 0) {
      if (parse_integer(words[0], promised_) && promised_ >= 0) return false;
    }
    double number = 0;
    const bool is_words = !parse_double(words[0], number);
    if (names_.empty() && is_words && read_names(line)) {
      has_line_of_names_ = true;
      return false;
    }
    if (is_words && names_.empty() && words.size() >= 3)
      fail(no_number(words[0]) + "; a first line of names has x, y and z among them");
    if (is_words && words.size() < 3) fail_expected(line);
    dialect_.emplace(line, source_->here_line());
    const std::vector<std::string> tokens = dialect_->fields(line);
    if (tokens.size() < 3 || tokens.size() > kMaxColumns) fail_expected(line);
    width_ = tokens.size();
    match_names(tokens);
    columns_.emplace(names_, options_, source_->here_line());
    for (std::size_t i = 0; i < width_; ++i) roles_.push_back(columns_->role(i));
    return true;
  }

  void read_row(std::string_view line) {
    for (std::size_t i = 0; i < width_; ++i) {
      if (line.empty()) {
        fail(std::to_string(i) + " numbers where the first line has " + std::to_string(width_) +
             (source_->at_end() ? " (truncated?)" : ""));
      }
      const std::string_view token = dialect_->cut(line);
      double value = 0;
      if (!dialect_->number(token, value)) fail(dialect_->fault(token));
      if (may_be_halves_ && i % 2 == 1 && TableDialect::has_idle_zero(token)) {
        fail(in_quotes(token) +
             " is half a number: commas are decimal signs or set off thousands here; write "
             "decimal points, or separate the numbers by semicolons");
      }
      if (roles_[i] != ScanColumns::kRoles) row_[roles_[i]] = value;
    }
    if (!line.empty()) {
      fail(in_quotes(dialect_->cut(line)) + " after the " + std::to_string(width_) + " numbers of a line");
    }
  }

  SourcePtr source_;
  ScanOptions options_;
  std::vector<std::string> names_;
  std::string names_line_;  ///< where they were found
  bool has_line_of_names_ = false, may_be_halves_ = false;
  std::optional<TableDialect> dialect_;
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
