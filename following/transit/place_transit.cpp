// Copyright the limpet authors. GPL-3.0-or-later.
#include "steering_internal.hpp"
#include "transit_internal.hpp"
#include "travel_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

class PlaceTransit final : public Transit {
 public:
  PlaceTransit(double resolution, double step, const Clearance& clearance)
      : travel_(resolution, step), step_(step), clearance_(clearance) {}

  void arrive(const Observation& seen) override {
    travel_.arrive(seen.model.view(), clearance_, seen.posture.control_point());
  }
  bool begin(const Wanted& wanted) override { return travel_.begin(wanted); }
  bool begin_to(const Vector3d& place) override {
    travel_.begin(place);
    return true;
  }
  void stop() override { travel_.stop(); }
  void arrived() override { travel_.arrived(); }
  bool is_under_way() const override { return travel_.is_under_way(); }
  Vector3d goal() const override { return travel_.goal(); }
  std::vector<Vector3d> way() const override {
    return {travel_.way_back().rbegin(), travel_.way_back().rend()};
  }

  Travel::Progress look(const Observation& seen, bool has_moved) override {
    const auto progress = travel_.look(seen.posture.control_point(), has_moved);
    const bool goes_round =
        progress == Travel::Progress::stopped && travel_.go_round(seen.model.view(), clearance_);
    return goes_round ? Travel::Progress::good : progress;
  }

  Motion next(const Observation& seen) override {
    const model::View view = seen.model.view();
    const Steering steering(view, clearance_, seen.posture, step_);
    return {travel_.next(steering, seen.posture.control_point()), {}, Mode::travel};
  }

 private:
  Travel travel_;
  double step_;
  const Clearance& clearance_;
};

}  // namespace

std::unique_ptr<Transit> make_place_transit(double resolution, double step, const Clearance& clearance) {
  return std::make_unique<PlaceTransit>(resolution, step, clearance);
}

}  // namespace limpet::following::internal
