// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/run_merger_internal.hpp>

#include <algorithm>
#include <utility>

namespace limpet::survey {

bool RunMerger::later(const Run& a, const Run& b) {
  return a.first.key != b.first.key ? a.first.key > b.first.key : a.number > b.number;
}

void RunMerger::end_run() {
  sorted_->write();
  ends_.push_back(sorted_->size());
  bytes_ = sorted_->bytes();
}

bool RunMerger::next(StoredReading& reading) {
  if (!merging_) open_runs();
  while (next_merged(reading)) {
    const std::size_t pass = passes_.pass_of(reading.key);
    if (pass == 0) return true;
    put_off(reading, pass);
  }
  if (sorted_) end_merge();
  while (!cursor_ || !cursor_->next(reading)) {
    cursor_.reset();
    if (pass_ < put_off_.size()) put_off_[pass_].reset();
    if (++pass_ >= put_off_.size()) return false;
    cursor_ = std::make_unique<RecordCursor<StoredReading>>(*put_off_[pass_]);
  }
  return true;
}

void RunMerger::open_runs() {
  merging_ = true;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    Run run{RecordCursor<StoredReading>(*sorted_, i == 0 ? 0 : ends_[i - 1], ends_[i]), {}, i};
    if (run.rest.next(run.first)) heap_.push_back(std::move(run));
  }
  std::make_heap(heap_.begin(), heap_.end(), later);
}

bool RunMerger::next_merged(StoredReading& reading) {
  if (heap_.empty()) return false;
  std::pop_heap(heap_.begin(), heap_.end(), later);
  Run& run = heap_.back();
  reading = run.first;
  if (run.rest.next(run.first))
    std::push_heap(heap_.begin(), heap_.end(), later);
  else
    heap_.pop_back();
  return true;
}

void RunMerger::put_off(const StoredReading& reading, std::size_t pass) {
  while (put_off_.size() <= pass) put_off_.push_back(put_off_.empty() ? nullptr : std::make_unique<File>());
  put_off_[pass]->append(reading);
}

/// The sorted runs are no longer needed: their space is given back.
void RunMerger::end_merge() {
  sorted_.reset();
  for (const auto& file : put_off_) {
    if (!file) continue;
    file->write();
    bytes_ += file->bytes();
  }
}

}  // namespace limpet::survey
