// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/curve.hpp>
#include <limpet/survey/key_sort_internal.hpp>
#include <limpet/survey/ordered_points.hpp>
#include <limpet/survey/passes_internal.hpp>
#include <limpet/survey/run_merger_internal.hpp>

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

namespace limpet::survey {
namespace {

/// In a run in memory: the reading, its sort key twice, and what a deque takes beside.
constexpr std::size_t kBytesPerReading = sizeof(Reading) + 2 * sizeof(SortKey) + sizeof(void*);

}  // namespace

/// Holds a run of readings in memory. Where all fit, they are handed out from there; otherwise each full run
/// is written to disk in the order of its keys, and RunMerger hands them out.
class OrderedPoints::Sorter {
 public:
  Sorter(Source source, Ordering ordering) : source_(std::move(source)), ordering_(std::move(ordering)) {}

  bool next(Reading& reading) {
    if (source_) read_all();
    return runs_ ? next_from_disk(reading) : next_from_memory(reading);
  }

  std::int64_t points() const { return before_run_ + static_cast<std::int64_t>(run_.size()); }
  std::int64_t bytes_on_disk() const { return runs_ ? runs_->bytes() : 0; }

 private:
  void read_all() {
    const Source source = std::exchange(source_, {});
    const std::size_t most = std::clamp<std::size_t>(ordering_.memory_bytes / kBytesPerReading, 1,
                                                     std::numeric_limits<std::uint32_t>::max());
    for (Reading reading; source(reading);) {
      if (!curve_) curve_.emplace(reading.point.position, ordering_.cell);
      if (run_.size() == most) write_run();
      reading.place = points();
      run_.push_back(reading);
    }
    if (ordering_.stop && ordering_.stop()) return forget();
    if (runs_)
      write_run();
    else
      sort_passes();
  }
  void forget() {
    run_.clear();
    runs_.reset();
  }

  /// The run's keys in order: first by cell, then by chance, then as they came.
  std::vector<SortKey> sorted_keys() const {
    std::vector<SortKey> keys;
    keys.reserve(run_.size());
    for (const Reading& reading : run_) {
      const auto index = static_cast<std::uint32_t>(keys.size());
      keys.push_back({sort_key(curve_->place(reading.point.position), reading.place), index});
    }
    sort_by_key(keys);
    return keys;
  }

  void write_run() {
    if (!runs_) runs_.emplace();
    for (const SortKey& key : sorted_keys()) {
      const Reading& reading = run_[key.index];
      runs_->add({key.key, StoredPoint(reading.point), reading.skipped, reading.place});
    }
    runs_->end_run();
    before_run_ += static_cast<std::int64_t>(run_.size());
    run_.clear();
  }

  bool next_from_disk(Reading& reading) {
    StoredReading stored;
    if (!runs_->next(stored)) return false;
    reading = {stored.point.restored(), stored.skipped, stored.place};
    return true;
  }

  void sort_passes() {
    order_ = sorted_keys();
    Passes passes;
    for (SortKey& key : order_) key.key = passes.pass_of(key.key);
    sort_by_key(order_);
  }

  bool next_from_memory(Reading& reading) {
    if (next_ == order_.size()) return false;
    constexpr std::size_t kAhead = 16;  // readings lie all over the memory
    if (next_ + kAhead < order_.size()) __builtin_prefetch(&run_[order_[next_ + kAhead].index]);
    reading = run_[order_[next_++].index];
    return true;
  }

  Source source_;  ///< until it has been read
  Ordering ordering_;
  std::optional<Curve> curve_;
  std::deque<Reading> run_;
  std::int64_t before_run_ = 0;    ///< readings in earlier runs
  std::optional<RunMerger> runs_;  ///< of a scan that does not fit into memory
  std::vector<SortKey> order_;     ///< in which the run is handed out
  std::size_t next_ = 0;           ///< of these
};

OrderedPoints::OrderedPoints(Source source, Ordering ordering)
    : sorter_(std::make_unique<Sorter>(std::move(source), std::move(ordering))) {}
OrderedPoints::OrderedPoints(PointStream& points, Ordering ordering)
    : OrderedPoints([&points](Reading& reading) { return points.next(reading); }, std::move(ordering)) {}
OrderedPoints::~OrderedPoints() = default;
OrderedPoints::OrderedPoints(OrderedPoints&&) noexcept = default;
OrderedPoints& OrderedPoints::operator=(OrderedPoints&&) noexcept = default;

bool OrderedPoints::next(Reading& reading) { return sorter_->next(reading); }

bool OrderedPoints::next_set(std::vector<model::SensorPoint>& set, std::size_t size) {
  set.clear();
  for (Reading reading; set.size() < size && next(reading);) set.push_back(reading.point);
  return !set.empty();
}

std::int64_t OrderedPoints::points() const { return sorter_->points(); }
std::int64_t OrderedPoints::bytes_on_disk() const { return sorter_->bytes_on_disk(); }

}  // namespace limpet::survey
