// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/backlog.hpp>
#include <limpet/survey/stored_point_internal.hpp>

#include <optional>

namespace limpet::survey {
namespace {

constexpr std::size_t kInMemory = 100'000;

}  // namespace

struct Backlog::Stored {
  explicit Stored(const ReadPoint& read)
      : point(read.point), skipped(read.skipped), has_axis(read.has_axis ? 1 : 0) {}
  Stored() = default;
  ReadPoint restored() const { return {point.restored(), has_axis != 0, skipped}; }

  StoredPoint point;
  std::int64_t skipped, has_axis;
};

struct Backlog::OnDisk {
  RecordFile<Stored> file;
  std::optional<RecordCursor<Stored>> taken;  ///< stands behind the last point taken
};

Backlog::Backlog() = default;
Backlog::~Backlog() = default;
Backlog::Backlog(Backlog&&) noexcept = default;
Backlog& Backlog::operator=(Backlog&&) noexcept = default;

void Backlog::add(const ReadPoint& point) {
  ++size_;
  if (in_memory_.size() < kInMemory && !on_disk_) {
    in_memory_.push_back(point);
    return;
  }
  if (!on_disk_) on_disk_ = std::make_unique<OnDisk>();
  on_disk_->file.append(Stored(point));
}

void Backlog::for_each(std::int64_t most, const std::function<void(const ReadPoint&)>& look) {
  for (const ReadPoint& point : in_memory_)
    if (most-- > 0) look(point);
  if (!on_disk_) return;
  on_disk_->file.write();
  RecordCursor<Stored> cursor(on_disk_->file);
  for (Stored stored; most-- > 0 && cursor.next(stored);) look(stored.restored());
}

bool Backlog::take(ReadPoint& point) {
  if (!in_memory_.empty()) {
    point = in_memory_.front();
    in_memory_.pop_front();
  } else if (!on_disk_) {
    return false;
  } else {
    if (!on_disk_->taken) {
      on_disk_->file.write();
      on_disk_->taken.emplace(on_disk_->file);
    }
    Stored stored;
    if (!on_disk_->taken->next(stored)) {
      on_disk_.reset();
      return false;
    }
    point = stored.restored();
  }
  --size_;
  return true;
}

}  // namespace limpet::survey
