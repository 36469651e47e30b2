// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/temporary_file.hpp>
#include <memory>

namespace limpet::survey {

/// A point of a scan that has been read, and how many records that are no point were passed over just before
/// it.
struct ReadPoint {
  model::SensorPoint point;
  bool has_axis = false;
  std::int64_t skipped = 0;
};

/// Points that have been read and not handed out yet, in order, so that what comes only once, as through a
/// pipe, can be looked at before it is modelled. The first hundred thousand are held in memory, those behind
/// them in a TemporaryFile.
class Backlog {
 public:
  Backlog();
  ~Backlog();
  Backlog(Backlog&&) noexcept;
  Backlog& operator=(Backlog&&) noexcept;

  /// Precondition: nothing has been taken yet, or nothing is left. Errors: io::OutputError when there is no
  /// space for the temporary file.
  void add(const ReadPoint& point);
  /// Hands out the first `most` points, and leaves them here. Precondition: nothing has been taken yet.
  void for_each(std::int64_t most, const std::function<void(const ReadPoint&)>& look);
  /// Takes the first point; false when there is none.
  bool take(ReadPoint& point);
  /// The first point, which stays; null when there is none. Precondition: nothing has been taken yet.
  const ReadPoint* first() const { return in_memory_.empty() ? nullptr : &in_memory_.front(); }
  /// Points that are left.
  std::int64_t size() const { return size_; }

 private:
  struct Stored;  ///< a point as it lies in the file
  struct OnDisk;

  std::deque<ReadPoint> in_memory_;
  std::unique_ptr<OnDisk> on_disk_;
  std::int64_t size_ = 0;
};

}  // namespace limpet::survey
