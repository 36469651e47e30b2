// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/error.hpp>
#include <limpet/io/ply_header.hpp>
#include <limpet/io/scan_columns.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

class PlyReader final : public ScanReader {
 public:
  PlyReader(SourcePtr source, const ScanOptions& options)
      : source_(std::move(source)), header_(read_ply_header(*source_)) {
    const std::string where = source_->here_line();
    for (const PlyElement& element : header_.elements) {
      if ((element.name == "face" || element.name == "tristrips") && element.count > 0) {
        refuse_mesh(*source_, where, "is a mesh (" + std::to_string(element.count) + " faces)");
      }
    }
    const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const PlyElement& element) { return element.name == "vertex"; });
    if (vertex == header_.elements.end()) throw InputError(where, "the header promises no 'vertex' element");
    vertex_ = &*vertex;
    std::vector<std::string> names;
    for (const PlyProperty& property : vertex->properties) {
      names.push_back(property.is_list ? "" : property.name);  // a list is no coordinate, whatever its name
    }
    columns_.emplace(names, options, where);
    std::size_t offset = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      roles_.push_back(columns_->role(i));
      const NumberType type = vertex->properties[i].type;
      if (roles_.back() != ScanColumns::kRoles) places_.push_back({offset, type, roles_.back()});
      offset += size_of(type);
    }
    for (auto element = header_.elements.begin(); element != vertex; ++element) skip_element(*element);
  }

  std::int64_t promised() const override { return vertex_->count; }

  bool next(ScanRecord& record) override {
    while (read_ < vertex_->count) {
      if (!read_record(*vertex_, true)) truncated(*vertex_, read_);
      ++read_;
      if (columns_->make(row_, record)) return true;
      ++skipped_;
    }
    if (!ended_) {
      ended_ = true;
      read_tail();
    }
    return false;
  }

 private:
  bool ascii() const { return header_.encoding == PlyHeader::Encoding::kAscii; }
  bool swapped() const { return header_.encoding == PlyHeader::Encoding::kBigEndian; }
  std::string here() const { return ascii() ? source_->here_line() : source_->here_byte(); }

  [[noreturn]] void truncated(const PlyElement& element, std::int64_t found) const {
    throw InputError(here(), "the file ends after " + std::to_string(found) + " of the " +
                                 std::to_string(element.count) + " '" + element.name +
                                 "' records its header promises (truncated?)");
  }

  /// Takes one record; a vertex goes to row_. False at the end of the file.
  bool read_record(const PlyElement& element, bool is_vertex) {
    if (ascii()) return read_line(element, is_vertex);
    const std::size_t size = element.fixed_size;
    if (size == 0) return read_varying(element, is_vertex);
    const std::string_view bytes = source_->take(size);
    if (bytes.empty()) return false;
    if (is_vertex) {
      for (const Place& place : places_)
        row_[place.role] = decode(bytes.data() + place.offset, place.type, swapped());
    }
    return true;
  }

  bool read_varying(const PlyElement& element, bool is_vertex) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const NumberType type = property.is_list ? property.count_type : property.type;
      const std::string_view bytes = source_->take(size_of(type));
      if (bytes.empty()) return false;
      const double value = decode(bytes.data(), type, swapped());
      if (property.is_list) {
        if (value < 0) throw InputError(here(), "the length of a list is negative");
        if (!source_->skip(static_cast<std::uint64_t>(value) * size_of(property.type))) return false;
      } else if (is_vertex && roles_[i] != ScanColumns::kRoles) {
        row_[roles_[i]] = value;
      }
    }
    return true;
  }

  bool read_line(const PlyElement& element, bool is_vertex) {
    std::string_view line;
    std::string_view token;
    do {
      if (!source_->line(line)) return false;
      token = next_token(line);
    } while (token.empty());
    const auto number = [&](std::string_view text) {
      double value = 0;
      if (text.empty()) fail_short();
      if (!parse_double(text, value)) throw InputError(here(), no_number(text));
      return value;
    };
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (i > 0) token = next_token(line);
      const PlyProperty& property = element.properties[i];
      if (!property.is_list) {
        const double value = number(token);
        if (is_vertex && roles_[i] != ScanColumns::kRoles) row_[roles_[i]] = value;
        continue;
      }
      std::int64_t count = 0;
      if (token.empty()) fail_short();
      if (!parse_integer(token, count) || count < 0)
        throw InputError(here(), in_quotes(token) + " is not a length");
      for (; count > 0; --count) number(next_token(line));
    }
    if (const auto more = next_token(line); !more.empty()) {
      throw InputError(here(), in_quotes(more) + " after the numbers the header announces for a line");
    }
    return true;
  }

  [[noreturn]] void fail_short() const {
    throw InputError(here(), std::string("fewer numbers than the header announces for a line") +
                                 (source_->at_end() ? " (truncated?)" : ""));
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty()) return;  // its records have no bytes, however many are promised
    for (std::int64_t i = 0; i < element.count; ++i) {
      if (!read_record(element, false)) truncated(element, i);
    }
  }

  /// What follows the points must be what the header says, or points have been lost.
  void read_tail() {
    for (const PlyElement* element = vertex_ + 1;
         element != header_.elements.data() + header_.elements.size(); ++element) {
      skip_element(*element);
    }
    std::string_view rest;
    while (!(rest = source_->peek(1)).empty()) {
      if (std::string_view(" \t\r\n").find(rest[0]) == std::string_view::npos) {
        throw InputError(here(), "the file goes on after the " + std::to_string(vertex_->count) +
                                     " points its header announces");
      }
      source_->skip(1);
    }
  }

  struct Place {
    std::size_t offset;
    NumberType type;
    ScanColumns::Role role;
  };

  SourcePtr source_;
  PlyHeader header_;
  const PlyElement* vertex_ = nullptr;
  std::optional<ScanColumns> columns_;
  std::vector<ScanColumns::Role> roles_;  ///< by property
  std::vector<Place> places_;             ///< in a record of fixed size
  ScanColumns::Row row_{};
  std::int64_t read_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<ScanReader> open_ply(SourcePtr source, const ScanOptions& options) {
  return std::make_unique<PlyReader>(std::move(source), options);
}

}  // namespace limpet::io
