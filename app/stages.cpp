// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/stages.hpp>

#include <algorithm>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>

namespace limpet::app {

void Stages::look(const model::Model& model) {
  if (count_ < 2 || ++sets_ < next_) return;
  kept_.push_back(model.record());
  if (kept_.size() >= 4 * static_cast<std::size_t>(count_)) {
    for (std::size_t i = 0; 2 * i + 1 < kept_.size(); ++i) kept_[i] = std::move(kept_[2 * i + 1]);
    kept_.resize(kept_.size() / 2);
    interval_ *= 2;
  }
  next_ = sets_ + interval_;
}

std::vector<std::string> Stages::save(const std::string& path, const model::ModelRecord& final_model) const {
  std::vector<std::string> names;
  const std::string extension = io::extension_of(path);
  const std::string stem = extension.empty() ? path : path.substr(0, path.size() - extension.size() - 1);
  for (int i = 1; i <= count_; ++i) {
    const model::ModelRecord* record = &final_model;
    if (i < count_ && !kept_.empty()) {
      // The kept one nearest to the i-th part of the way.
      const std::int64_t wanted = final_model.points * i / count_;
      record = &*std::min_element(kept_.begin(), kept_.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.points - wanted) < std::abs(b.points - wanted);
      });
    }
    names.push_back(stem + ".stage" + std::to_string(i) + ".limpet");
    io::save_native(names.back(), *record);
  }
  return names;
}

}  // namespace limpet::app
