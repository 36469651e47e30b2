// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/stages.hpp>

#include <algorithm>
#include <limpet/app/arguments.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>
#include <sstream>
#include <utility>

namespace limpet::app {

void Stages::look(const model::Model& model) {
  if (count_ < 2 || ++sets_ < next_) return;
  std::ostringstream native;
  const model::ModelRecord record = model.record();
  io::write_native(native, record);
  kept_.push_back({record.points, std::move(native).str()});
  if (kept_.size() >= 4 * static_cast<std::size_t>(count_)) {
    for (std::size_t i = 0; 2 * i + 1 < kept_.size(); ++i) kept_[i] = std::move(kept_[2 * i + 1]);
    kept_.resize(kept_.size() / 2);
    interval_ *= 2;
  }
  next_ = sets_ + interval_;
}

std::string Stages::state() const {
  std::string text;
  for (const std::int64_t number : {interval_, next_, sets_, static_cast<std::int64_t>(kept_.size())})
    text += std::to_string(number) + "\n";
  for (const Kept& kept : kept_)
    text += std::to_string(kept.points) + "\n" + std::to_string(kept.native.size()) + "\n" + kept.native;
  return text;
}

void Stages::restore(std::string_view state) {
  const auto require = [](bool good) {
    if (!good) throw io::InputError("the stages of a checkpoint are damaged");
  };
  const auto number = [&] {
    std::int64_t x = 0;
    const auto end = std::min(state.find('\n'), state.size());
    require(end < state.size() && io::parse_integer(state.substr(0, end), x) && x >= 0);
    state.remove_prefix(end + 1);
    return x;
  };
  interval_ = number(), next_ = number(), sets_ = number();
  kept_.clear();
  for (std::int64_t left = number(); left > 0; --left) {
    const std::int64_t points = number(), size = number();
    require(static_cast<std::uint64_t>(size) <= state.size());
    kept_.push_back({points, std::string(state.substr(0, static_cast<std::size_t>(size)))});
    state.remove_prefix(static_cast<std::size_t>(size));
  }
  require(state.empty());
}

std::vector<std::string> Stages::names(const std::string& path, int count) {
  std::vector<std::string> names;
  const std::string extension = io::extension_of(path);
  const std::string stem = extension.empty() ? path : path.substr(0, path.size() - extension.size() - 1);
  for (int i = 1; i <= count; ++i) names.push_back(stem + ".stage" + std::to_string(i) + ".limpet");
  return names;
}

void Stages::save(const std::string& path, const model::ModelRecord& final_model, Outputs& outputs) const {
  int i = 0;
  for (const std::string& name : names(path, count_)) {
    if (++i == count_ || kept_.empty()) {
      outputs.attempt(name, [&] { io::save_native(name, final_model); });
      continue;
    }
    // The kept one nearest to the i-th part of the way.
    const std::int64_t wanted = final_model.points * i / count_;
    const auto nearest = std::min_element(kept_.begin(), kept_.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.points - wanted) < std::abs(b.points - wanted);
    });
    outputs.attempt(name, [&] { save_text(name, nearest->native); });
  }
}

}  // namespace limpet::app
