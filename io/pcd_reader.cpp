// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/error.hpp>
#include <limpet/io/lzf.hpp>
#include <limpet/io/pcd_header.hpp>
#include <limpet/io/scan_columns.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/text.hpp>
#include <new>
#include <utility>

namespace limpet::io {
namespace {

class PcdReader final : public ScanReader {
 public:
  PcdReader(SourcePtr source, const ScanOptions& options)
      : source_(std::move(source)), header_(read_pcd_header(*source_)) {
    std::vector<std::string> names;
    for (const PcdField& field : header_.fields) names.push_back(field.count == 1 ? field.name : "");
    ScanOptions chosen = options;
    if (!chosen.viewpoint) chosen.viewpoint = header_.viewpoint;
    columns_.emplace(names, chosen, source_->here_line());
    for (std::size_t i = 0, column = 0; i < names.size(); ++i) {
      const PcdField& field = header_.fields[i];
      if (const auto role = columns_->role(i); role != ScanColumns::kRoles) {
        places_.push_back({record_size_, column, field.type, role});
      }
      record_size_ += field.count * size_of(field.type);
      column += field.count;
      width_ = column;
    }
    if (header_.encoding == PcdHeader::Encoding::kCompressed) unpack();
  }

  std::int64_t promised() const override { return header_.points; }

  bool next(ScanRecord& record) override {
    while (read_ < header_.points) {
      if (!read_record()) {
        if (!damage_.empty()) throw InputError(source_->here_byte(), damage_);
        throw InputError(
            header_.encoding == PcdHeader::Encoding::kAscii ? source_->here_line() : source_->here_byte(),
            "the file ends after " + std::to_string(read_) + " of the " + std::to_string(header_.points) +
                " points its header promises (truncated?)");
      }
      ++read_;
      if (columns_->make(row_, record)) return true;
      ++skipped_;
    }
    if (!damage_.empty()) throw InputError(source_->here_byte(), std::exchange(damage_, {}));
    if (header_.encoding == PcdHeader::Encoding::kAscii) check_tail();
    return false;
  }

 private:
  bool read_record() {
    switch (header_.encoding) {
      case PcdHeader::Encoding::kAscii:
        return read_line();
      case PcdHeader::Encoding::kBinary:
        return read_binary();
      case PcdHeader::Encoding::kCompressed:
        return read_unpacked();
    }
    return false;
  }

  bool read_binary() {
    const std::string_view bytes = source_->take(record_size_);
    if (bytes.empty()) return false;
    for (const Place& place : places_)
      row_[place.role] = decode(bytes.data() + place.offset, place.type, false);
    return true;
  }

  /// Compressed points lie field by field: all x, then all y, ...
  bool read_unpacked() {
    for (const Place& place : places_) {
      const std::size_t size = size_of(place.type);
      const std::size_t at = place.offset * static_cast<std::size_t>(header_.points) + read_ * size;
      if (at + size > unpacked_.size()) return false;
      row_[place.role] = decode(unpacked_.data() + at, place.type, false);
    }
    return true;
  }

  bool read_line() {
    std::string_view line;
    std::string_view token;
    do {
      if (!source_->line(line)) return false;
      token = next_token(line);
    } while (token.empty());
    auto place = places_.begin();
    std::size_t column = 0;
    for (; !token.empty(); token = next_token(line), ++column) {
      double value = 0;
      if (!parse_double(token, value)) throw InputError(source_->here_line(), no_number(token));
      if (place != places_.end() && place->column == column) row_[(place++)->role] = value;
    }
    if (column != width_) {
      throw InputError(source_->here_line(), std::to_string(column) + " numbers where the header announces " +
                                                 std::to_string(width_) +
                                                 (source_->at_end() ? " (truncated?)" : ""));
    }
    return true;
  }

  void check_tail() {
    std::string_view line;
    while (source_->line(line)) {
      if (!next_token(line).empty()) {
        throw InputError(
            source_->here_line(),
            "the file goes on after the " + std::to_string(header_.points) + " points its header announces");
      }
    }
  }

  /// Holds what the compressed block gives; damage is kept for when the points before it have been given out.
  void unpack() {
    const std::string_view sizes = source_->take(8);
    if (sizes.empty()) {
      damage_ = "the file ends before its compressed points (truncated?)";
      return;
    }
    const auto packed_size = static_cast<std::size_t>(decode(sizes.data(), NumberType::kUint32, false));
    const auto size = static_cast<std::size_t>(decode(sizes.data() + 4, NumberType::kUint32, false));
    if (size / record_size_ != static_cast<std::size_t>(header_.points) || size % record_size_ != 0) {
      damage_ = "the compressed block holds " + std::to_string(size) + " bytes, which are not the " +
                std::to_string(header_.points) + " points of " + std::to_string(record_size_) +
                " bytes its header promises";
      header_.points = 0;
      return;
    }
    std::string packed;
    try {
      while (packed.size() < packed_size) {
        const std::string_view piece = source_->peek(1).substr(0, packed_size - packed.size());
        if (piece.empty()) break;
        packed += piece;
        source_->skip(piece.size());
      }
      unpacked_ = unpack_lzf(packed, size);
    } catch (const std::bad_alloc&) {
      const std::size_t megabytes = (packed_size + size) / 1'000'000;
      throw InputError(source_->name(),
                       "its compressed points take " + std::to_string(megabytes) +
                           " MB of memory, which there are not; convert the file to DATA binary, "
                           "which is read as it comes");
    }
    if (packed.size() < packed_size) {
      damage_ = "the file ends within its compressed points (truncated?)";
    } else if (unpacked_.size() < size) {
      damage_ = "the compressed points are damaged";
    }
  }

  struct Place {
    std::size_t offset;  ///< in a record
    std::size_t column;  ///< in a line
    NumberType type;
    ScanColumns::Role role;
  };

  SourcePtr source_;
  PcdHeader header_;
  std::optional<ScanColumns> columns_;
  std::vector<Place> places_;
  std::size_t record_size_ = 0, width_ = 0;
  std::vector<char> unpacked_;
  std::string damage_;
  ScanColumns::Row row_{};
  std::int64_t read_ = 0;
};

}  // namespace

std::unique_ptr<ScanReader> open_pcd(SourcePtr source, const ScanOptions& options) {
  return std::make_unique<PcdReader>(std::move(source), options);
}

}  // namespace limpet::io
