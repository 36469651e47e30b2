// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/toml_section_internal.hpp>

#define TOML_HEADER_ONLY 1
// Damaged text breaks assertions of its key parser, after which it comes to an error that says what is wrong.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <limpet/io/error.hpp>
#include <string_view>
#include <utility>

namespace limpet::app {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool is_one(double number, Numbers which) {
  if (!std::isfinite(number)) return false;
  switch (which) {
    case Numbers::any:
      return true;
    case Numbers::not_negative:
      return number >= 0;
    case Numbers::positive:
      return number > 0;
    case Numbers::fraction:
      return number >= 0 && number <= 1;
  }
  return false;
}

std::string described(Numbers which) {
  switch (which) {
    case Numbers::any:
      break;
    case Numbers::not_negative:
      return " of 0 or more";
    case Numbers::positive:
      return " more than 0";
    case Numbers::fraction:
      return " from 0 to 1";
  }
  return "";
}

std::optional<double> to_number(const toml::node& node, Numbers which) {
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  return number && is_one(*number, which) ? number : std::nullopt;
}

/// Where a string or comment that begins at `at` ends: behind its last character.
std::size_t end_of_span(std::string_view text, std::size_t at) {
  const char quote = text[at];
  if (quote == '#') return std::min(text.find('\n', at), text.size());
  const std::string three(3, quote);
  const bool lines = text.substr(at, 3) == three;
  for (std::size_t i = at + (lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (lines ? text.substr(i, 3) == three : text[i] == quote)
      return i + (lines ? 3 : 1);
    else if (text[i] == '\n' && !lines)
      return i;
  }
  return text.size();
}

/// TOML has characters beyond ASCII in strings and comments alone. The parser (3.3) may do anything with
/// others.
void require_ascii_syntax(std::string_view text, const std::string& path) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  for (std::size_t at = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; at < text.size();) {
    if (text[at] == '#' || text[at] == '"' || text[at] == '\'') {
      at = end_of_span(text, at);
      continue;
    }
    if (static_cast<unsigned char>(text[at]) >= 0x80)
      throw io::InputError(
          path + ":" + std::to_string(1 + std::ranges::count(text.substr(0, at), '\n')),
          "has a character beyond ASCII outside strings and comments; put the text in quotes");
    ++at;
  }
}

/// A parser's message may have line breaks; ours is one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

struct TomlSection::Inside {
  std::shared_ptr<const toml::table> file;  ///< owns the tables
  const toml::table* table = nullptr;
  std::string path, name;  ///< name: of the table; empty: the whole file
};

TomlSection::TomlSection(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
TomlSection::~TomlSection() = default;
TomlSection::TomlSection(TomlSection&&) noexcept = default;

TomlSection TomlSection::parse(const std::string& text, const std::string& path) {
  require_ascii_syntax(text, path);
  try {
    auto inside = std::make_unique<Inside>();
    inside->file = std::make_shared<const toml::table>(toml::parse(text, path));
    inside->table = inside->file.get();
    inside->path = path;
    return TomlSection(std::move(inside));
  } catch (const toml::parse_error& error) {
    throw io::InputError(path + ":" + std::to_string(error.source().begin.line),
                         one_line(std::string(error.description())));
  }
}

std::string TomlSection::called(const std::string& key) const {
  return "'" + key + "'" + (inside_->name.empty() ? "" : " in [" + inside_->name + "]");
}

void TomlSection::fail(const std::string& key, const std::string& what) const {
  const toml::node* node = inside_->table->get(key);
  const toml::source_region& where = node ? node->source() : inside_->table->source();
  throw io::InputError(inside_->path + ":" + std::to_string(std::max(1u, unsigned{where.begin.line})), what);
}

void TomlSection::allow(const std::vector<std::string>& known) const {
  const toml::key* first = nullptr;  // in the file
  for (const auto& [key, node] : *inside_->table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    if (!first || key.source().begin < first->source().begin) first = &key;
  }
  if (!first) return;
  throw io::InputError(inside_->path + ":" + std::to_string(first->source().begin.line),
                       "unknown key " + called(std::string(first->str())) + "; known are: " + joined(known));
}

bool TomlSection::has(const std::string& key) const { return inside_->table->contains(key); }

bool TomlSection::is_text(const std::string& key) const {
  return has(key) && inside_->table->get(key)->is_string();
}

bool TomlSection::is_list(const std::string& key) const {
  return has(key) && inside_->table->get(key)->is_array();
}

std::optional<TomlSection> TomlSection::section(const std::string& key,
                                                const std::vector<std::string>& known) const {
  std::optional<TomlSection> found = table(key);
  if (found) found->allow(known);
  return found;
}

std::string TomlSection::name_of(const std::string& key) const {
  return inside_->name.empty() ? key : inside_->name + "." + key;
}

std::optional<TomlSection> TomlSection::table(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  const toml::table* table = inside_->table->get(key)->as_table();
  if (!table)
    fail(key, called(key) + " must be a table: begin it with [" + name_of(key) + "] on a line of its own");
  return TomlSection(std::make_unique<Inside>(Inside{inside_->file, table, inside_->path, name_of(key)}));
}

std::vector<std::string> TomlSection::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *inside_->table) keys.emplace_back(key.str());
  return keys;
}

void TomlSection::each(const std::string& key, const std::vector<std::string>& known,
                       const std::function<void(const TomlSection&)>& take) const {
  if (!has(key)) return;
  const toml::array* array = inside_->table->get(key)->as_array();
  const std::string wrong =
      called(key) + " must be a list of tables, as in " + key + " = [{ " + known[0] + " = … }]";
  if (!array) fail(key, wrong);
  for (const toml::node& node : *array) {
    if (!node.is_table()) fail(key, wrong);
    TomlSection found(
        std::make_unique<Inside>(Inside{inside_->file, node.as_table(), inside_->path, name_of(key)}));
    found.allow(known);
    take(found);
  }
}

std::optional<double> TomlSection::number(const std::string& key, Numbers which) const {
  if (!has(key)) return std::nullopt;
  const auto number = to_number(*inside_->table->get(key), which);
  if (!number) fail(key, called(key) + " must be a number" + described(which));
  return number;
}

std::optional<std::int64_t> TomlSection::whole(const std::string& key, std::int64_t least,
                                               std::int64_t most) const {
  if (!has(key)) return std::nullopt;
  const toml::node& node = *inside_->table->get(key);
  const auto number = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!number || *number < least || *number > most) {
    fail(key, called(key) + " must be a whole number of " + std::to_string(least) + " or more" +
                  (most < std::numeric_limits<std::int64_t>::max() ? ", up to " + std::to_string(most) : ""));
  }
  return number;
}

bool TomlSection::flag(const std::string& key) const {
  if (!has(key)) return false;
  const toml::node& node = *inside_->table->get(key);
  if (!node.is_boolean()) fail(key, called(key) + " must be true or false");
  return *node.value<bool>();
}

std::optional<std::string> TomlSection::text(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  const toml::node& node = *inside_->table->get(key);
  if (!node.is_string()) fail(key, called(key) + " must be a text in quotes");
  return node.value<std::string>();
}

std::optional<std::vector<std::string>> TomlSection::texts(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  if (is_text(key)) return std::vector<std::string>{*text(key)};
  std::vector<std::string> values;
  const toml::array* array = inside_->table->get(key)->as_array();
  bool good = array != nullptr;
  for (std::size_t i = 0; good && i < array->size(); ++i) {
    good = (*array)[i].is_string();
    values.push_back((*array)[i].value<std::string>().value_or(""));
  }
  if (!good) fail(key, called(key) + " must be a text in quotes, or a list of them");
  return values;
}

std::string TomlSection::beside(const std::string& name) const {
  return (std::filesystem::path(inside_->path).parent_path() / name).lexically_normal().string();
}

std::optional<std::string> TomlSection::file(const std::string& key) const {
  const auto name = text(key);
  if (!name) return std::nullopt;
  std::string found = beside(*name);
  std::error_code error;
  if (name->empty() || !std::filesystem::exists(found, error))
    fail(key, called(key) + " names a file that is not there: " + found +
                  "; names are relative to the scene file");
  return found;
}

std::optional<std::vector<double>> TomlSection::numbers(const std::string& key, std::size_t least,
                                                        std::size_t most, Numbers which) const {
  if (!has(key)) return std::nullopt;
  std::vector<double> values;
  const toml::array* array = inside_->table->get(key)->as_array();
  bool good = array && array->size() >= least && array->size() <= most;
  for (std::size_t i = 0; good && i < array->size(); ++i) {
    const auto number = to_number((*array)[i], which);
    good = number.has_value();
    values.push_back(number.value_or(0));
  }
  const std::string count = std::to_string(least) + (least < most ? " to " + std::to_string(most) : "");
  if (!good) fail(key, called(key) + " must be a list of " + count + " numbers" + described(which));
  return values;
}

std::optional<std::vector<int>> TomlSection::indices(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  std::vector<int> values;
  const toml::array* array = inside_->table->get(key)->as_array();
  bool good = array != nullptr;
  for (std::size_t i = 0; good && i < array->size(); ++i) {
    const auto number = (*array)[i].is_integer() ? (*array)[i].value<int>() : std::nullopt;
    good = number && *number >= 0;
    values.push_back(number.value_or(0));
  }
  if (!good) fail(key, called(key) + " must be a list of whole numbers of 0 or more");
  return values;
}

std::optional<Eigen::Vector3d> TomlSection::vector(const std::string& key) const {
  const auto values = numbers(key, 3, 3, Numbers::any);
  if (!values) return std::nullopt;
  return Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
}

void TomlSection::require_one(const std::vector<std::string>& keys, bool needed) const {
  std::string first;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (!first.empty()) fail(key, called(key) + " and '" + first + "' exclude each other: leave one out");
    first = key;
  }
  if (first.empty() && needed) fail("", "[" + inside_->name + "] needs one of these keys: " + joined(keys));
}

}  // namespace limpet::app
