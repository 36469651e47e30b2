// Copyright the limpet authors. GPL-3.0-or-later.
#include "stream_case.hpp"

#include <ctime>

#include <algorithm>
#include <exception>
#include <sstream>

#include "../geometry/perimeter_shapes.hpp"
#include "../model/ledger.hpp"
#include "../model/random_streams.hpp"

namespace limpet::cases {

using namespace model;
using model::testing::broken_laws;
using model::testing::bytes;
using model::testing::Ledger;
using model::testing::points_in_segments;

namespace {

/// What the streams' generators ask of a random generator, from bytes.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : random_(bytes) {}
  std::uint64_t next() { return random_.bits(); }
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(random_.whole(0, static_cast<std::int64_t>(count) - 1));
  }
  double uniform() { return random_.unit(); }
  double uniform(double low, double high) { return low + (high - low) * random_.unit(); }
  double normal() {  // nearly: the sum of six even ones
    double sum = -3;
    for (int i = 0; i < 6; ++i) sum += random_.unit();
    return 1.4142135623730951 * sum;
  }
  std::size_t left() const { return random_.left(); }

 private:
  shapes::Random random_;
};

/// Readings on a lattice of λ/4, axes in 26 directions, three bytes each.
StreamCase lattice_stream(Choices& choose) {
  StreamCase c;
  c.parameters = model::testing::random_streams::parameters(choose);
  c.parameters.resolution = 1;
  const auto coordinate = [&] { return static_cast<double>(choose.below(32)) / 4; };
  while (choose.left() > 0 && c.sets.size() < 60) {
    auto& set = c.sets.emplace_back();
    const double height = coordinate();
    const auto kind = choose.below(4);
    for (auto n = 1 + choose.below(30); n > 0; --n) {
      const double x = coordinate(), y = coordinate();
      const double z = kind == 0 ? coordinate() : kind == 1 ? height : kind == 2 ? height + x / 2 : 0;
      const auto away = choose.below(27);
      const auto part = [&](std::uint64_t of) { return static_cast<double>(away / of % 3) - 1; };
      Eigen::Vector3d axis(part(1), part(3), part(9));
      if (kind != 0 && choose.below(4) != 0) axis = {0, 0, -1};
      set.push_back({{x, y, z}, axis, 0});
    }
  }
  return c;
}

std::string why_unsound(const ModelRecord& record, std::int64_t given) {
  if (record.points + record.refused != given)
    return "points and refused records are not all that were given";
  if (points_in_segments(record) + record.expired != record.points) return "points have gone lost";
  return "";
}

std::uint64_t processor_time_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(now.tv_nsec);
}

/// A model that is judged after every call.
class StreamTrial {
 public:
  StreamTrial(const Parameters& p, StreamFigures& figures) : model_(p), figures_(figures) {}

  std::optional<BrokenLaw> update(std::span<const SensorPoint> set, const std::string& when) {
    given_ += static_cast<std::int64_t>(set.size());
    return judged(
        when, [&]() -> auto& { return model_.update(set); });
  }
  std::optional<BrokenLaw> finish() {
    return judged(
        "finished", [&]() -> auto& { return model_.finish(); });
  }

  /// What is written is read back to the same, and a model made of it is the same too.
  std::optional<BrokenLaw> judge_record() const {
    const std::string text = bytes(model_.record());
    std::istringstream stream(text);
    const ModelRecord again = io::read_native(stream, "record");
    if (bytes(again) != text) return BrokenLaw{"native", "the native file reads back to other bytes"};
    if (bytes(Model(again).record()) != text) return BrokenLaw{"native", "a model made of it is another"};
    return std::nullopt;
  }

  /// Goes on with a model made of the state.
  std::optional<BrokenLaw> restore() {
    const std::string state = model_.state();
    model_ = Model::from_state(state);
    if (model_.state() != state) return BrokenLaw{"state", "a model made of the state has another"};
    return std::nullopt;
  }

 private:
  template <class Call>
  std::optional<BrokenLaw> judged(const std::string& when, Call&& call) {
    const std::uint64_t begin = processor_time_ns();
    const std::vector<Change>& changes = call();
    figures_.longest_ns = std::max(figures_.longest_ns, processor_time_ns() - begin);
    ++figures_.sets;
    const ModelRecord record = model_.record();
    if (const auto broken = broken_laws(record); !broken.empty())
      return BrokenLaw{"audit", when + ": " + broken};
    if (const auto lost = why_unsound(record, given_); !lost.empty())
      return BrokenLaw{"readings", when + ": " + lost};
    if (const auto untold = ledger_.read(changes, record); !untold.empty())
      return BrokenLaw{"changes", when + ": " + untold};
    return std::nullopt;
  }

  Model model_;
  Ledger ledger_;
  StreamFigures& figures_;
  std::int64_t given_ = 0;
};

std::optional<BrokenLaw> run(const StreamCase& c, StreamFigures& figures) {
  StreamTrial trial(c.parameters, figures);
  for (std::size_t i = 0; i < c.sets.size(); ++i) {
    if (auto broken = trial.update(c.sets[i], "set " + std::to_string(i + 1))) return broken;
    if (i != c.sets.size() / 2) continue;
    if (auto broken = trial.judge_record()) return broken;
    if (auto broken = trial.restore()) return broken;
  }
  if (auto broken = trial.finish()) return broken;
  return trial.judge_record();
}

}  // namespace

StreamCase stream_of(std::span<const std::uint8_t> bytes) {
  Choices choose(bytes);
  if (choose.below(2) == 0) return lattice_stream(choose);
  const auto stream = model::testing::random_stream(choose, 60);
  return {stream.parameters, stream.sets, {}};
}

std::optional<BrokenLaw> broken_law(const StreamCase& c, StreamFigures* figures) {
  StreamFigures own;
  try {
    return run(c, figures ? *figures : own);
  } catch (const std::exception& error) {
    return BrokenLaw{"exception", error.what()};
  }
}

}  // namespace limpet::cases
