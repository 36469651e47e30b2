// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace limpet::survey {

/// Bytes in a file that has no name and is gone when the program ends, however it ends. TMPDIR says in which
/// folder it lies, else /tmp.
class TemporaryFile {
 public:
  /// Errors: io::OutputError when it cannot be made.
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Writes behind what is there. Errors: io::OutputError when there is no space.
  void append(const void* bytes, std::size_t size);
  /// Precondition: so many bytes have been written there. Errors: io::OutputError when they cannot be read.
  void read(std::int64_t from, void* bytes, std::size_t size) const;
  std::int64_t size() const { return size_; }

 private:
  int file_;
  std::int64_t size_ = 0;
};

/// Records of one type in a temporary file, read by any number of RecordCursor.
template <class Record>
class RecordFile {
  static_assert(std::is_trivially_copyable_v<Record>);

 public:
  /// Errors: those of TemporaryFile.
  void append(const Record& record) {
    unwritten_.push_back(record);
    if (unwritten_.size() == kBuffered) write();
  }
  /// To be called between the last record appended and the first read.
  void write() {
    if (unwritten_.empty()) return;
    file_.append(unwritten_.data(), unwritten_.size() * sizeof(Record));
    unwritten_.clear();
  }
  void read(std::int64_t from, Record* records, std::size_t count) const {
    file_.read(from * static_cast<std::int64_t>(sizeof(Record)), records, count * sizeof(Record));
  }
  /// Records written.
  std::int64_t size() const { return file_.size() / static_cast<std::int64_t>(sizeof(Record)); }
  std::int64_t bytes() const { return file_.size(); }

  static constexpr std::size_t kBuffered = 1024;  ///< records

 private:
  TemporaryFile file_;
  std::vector<Record> unwritten_;
};

/// Reads a part of a file of records in order.
template <class Record>
class RecordCursor {
 public:
  /// The records from `from` to before `to`, or to the end. The file has to outlive the cursor.
  explicit RecordCursor(const RecordFile<Record>& file, std::int64_t from = 0,
                        std::int64_t to = std::numeric_limits<std::int64_t>::max())
      : file_(&file), next_(from), end_(std::min(to, file.size())) {}

  /// False at the end. Errors: those of TemporaryFile.
  bool next(Record& record) {
    if (at_ == read_.size()) {
      const auto count = std::min<std::int64_t>(end_ - next_, RecordFile<Record>::kBuffered);
      if (count <= 0) return false;
      read_.resize(static_cast<std::size_t>(count));
      file_->read(next_, read_.data(), read_.size());
      next_ += count;
      at_ = 0;
    }
    record = read_[at_++];
    return true;
  }

 private:
  const RecordFile<Record>* file_;
  std::int64_t next_, end_;
  std::vector<Record> read_;
  std::size_t at_ = 0;  ///< in `read_`
};

}  // namespace limpet::survey
