// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of moments.hpp, fit.hpp and model.hpp on streams as no sensor gives them, each by the
// name of what it is about. What holds of scans of shapes is in invariance_test.cpp.
#include <functional>
#include <limits>
#include <map>

#include <limpet/model/fit_internal.hpp>

#include "../expect_law.hpp"
#include "../generators/streams.hpp"
#include "grid_clouds.hpp"
#include "ledger.hpp"
#include "neighbour_ledger.hpp"
#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using properties::about_zero;
using properties::expect_law;
using properties::one_of;
using properties::power_of_two;
using properties::streams;
using properties::whole;

// Moments

/// On few places, in a line, in a plane or anywhere, up to the edge of the range, on one side of the origin.
Cloud any_cloud() {
  const auto parts = *rc::gen::container<std::vector<std::array<std::int64_t, 3>>>(
      rc::gen::container<std::array<std::int64_t, 3>>(rc::gen::inRange<std::int64_t>(1, 1000)));
  const int kind = one_of(4);
  const auto scale = static_cast<std::int64_t>(power_of_two(0, 36));
  Cloud cloud{{scale, scale, scale}};
  for (const auto& p : parts) {
    if (kind == 0) cloud.push_back({scale * (1 + p[0] % 2), scale * (1 + p[1] % 2), scale});
    if (kind == 1) cloud.push_back({scale * p[0], 2 * scale * p[0], scale + p[0]});
    if (kind == 2) cloud.push_back({scale * p[0], scale * p[1], scale * (p[0] + p[1]) + p[2] % 2});
    if (kind == 3) cloud.push_back({scale * p[0], scale * p[1], scale * p[2]});
  }
  return cloud;
}

TEST(MomentsLaws, OrderAndGroupingDoNotMatter) {
  expect_law("Moments (1)", 500, [] {
    Cloud cloud = any_cloud();
    const Moments all = moments_of(cloud);
    const auto cut = static_cast<std::size_t>(whole(0, 99)) % cloud.size();
    const auto first = cloud.begin(), middle = first + static_cast<std::ptrdiff_t>(cut);
    Moments parts = moments_of({middle, cloud.end()});
    parts.add(moments_of({first, middle}));
    RC_ASSERT(same(all, parts));
    std::reverse(cloud.begin(), cloud.end());
    RC_ASSERT(same(all, moments_of(cloud)));
  });
}

TEST(MomentsLaws, TranslationOnOneSideOfTheOriginKeepsTheCovarianceExactly) {
  expect_law("Moments (2)", 500, [] {
    Cloud cloud = any_cloud();
    const Eigen::Matrix3d covariance = moments_of(cloud).covariance(0.25);
    const GridPoint by{whole(0, 1) << 46, whole(0, 1000), whole(0, 1) << 40};
    for (auto& p : cloud)
      for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
    RC_ASSERT(moments_of(cloud).covariance(0.25) == covariance);
  });
}

TEST(MomentsLaws, AxesTurnedOrMirroredTurnCentroidAndCovarianceExactly) {
  expect_law("Moments (3)", 500, [] {
    Cloud cloud = any_cloud();
    const Moments before = moments_of(cloud);
    Eigen::Matrix3d turn;  // x, y, z become y, -z, x, or with other signs
    const double sx = one_of(2) ? -1 : 1, sy = one_of(2) ? -1 : 1, sz = one_of(2) ? -1 : 1;
    turn << 0, sx, 0, 0, 0, sy, sz, 0, 0;
    for (auto& p : cloud)
      p = {static_cast<std::int64_t>(sx) * p[1], static_cast<std::int64_t>(sy) * p[2],
           static_cast<std::int64_t>(sz) * p[0]};
    const Moments after = moments_of(cloud);
    RC_ASSERT(after.centroid(0.5) == turn * before.centroid(0.5));
    RC_ASSERT(after.covariance(0.5) == turn * before.covariance(0.5) * turn.transpose());
  });
}

TEST(MomentsLaws, PowersOfTwoScaleThemExactly) {
  expect_law("Moments (4)", 500, [] {
    const Moments m = moments_of(any_cloud());
    const double scale = power_of_two(-60, 60);
    RC_ASSERT(m.centroid(scale) == scale * m.centroid(1));
    RC_ASSERT(m.covariance(scale) == scale * scale * m.covariance(1));
  });
}

// Fit

TEST(FitLaws, TheAxesAreOrthonormalTheVariancesOrderedAndTheNormalFacesOut) {
  expect_law("Fit (1) (2)", 500, [] {
    const Moments m = moments_of(any_cloud());
    const Eigen::Vector3d inside(static_cast<double>(about_zero(3)), static_cast<double>(about_zero(3)), 1);
    const Fit fit = fit_to(m, 1, inside);
    RC_ASSERT(fit.u1 >= fit.u2 && fit.u2 >= fit.u3 && fit.u3 >= 0);
    RC_ASSERT(fit.normal.dot(inside) <= 0);
    if (m.count() < 2) return;
    Eigen::Matrix3d axes;
    axes << fit.axis1, fit.axis2, fit.normal;
    RC_ASSERT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-12);
    const Fit other = fit_to(m, 1, -inside);
    if (fit.normal.dot(inside) != 0) RC_ASSERT(other.normal == -fit.normal);
  });
}

TEST(FitLaws, TranslationOnOneSideOfTheOriginKeepsAllButTheCentroidExactly) {
  expect_law("Fit (3)", 500, [] {
    Cloud cloud = any_cloud();
    const Eigen::Vector3d inside(0, 1, 2);
    const Fit before = fit_to(moments_of(cloud), 0.5, inside);
    for (auto& p : cloud) p[0] += std::int64_t{1} << 45, p[2] += 12345;
    const Fit after = fit_to(moments_of(cloud), 0.5, inside);
    RC_ASSERT(after.u1 == before.u1 && after.u2 == before.u2 && after.u3 == before.u3);
    RC_ASSERT(after.normal == before.normal && after.axis1 == before.axis1 && after.axis2 == before.axis2);
  });
}

// Model

void for_sets_of(const properties::Stream& stream,
                 const std::function<void(Model&, const std::vector<Change>&)>& look) {
  Model model(stream.parameters);
  for (const auto& set : stream.sets) look(model, model.update(set));
  look(model, model.finish());
}

std::string bytes_of(const properties::Stream& stream) {
  Model model(stream.parameters);
  for (const auto& set : stream.sets) model.update(set);
  model.finish();
  return bytes(model.record());
}

TEST(ModelLaws, TheOracleFindsNothing) {
  expect_law("Model (1)", 150, [] {
    for_sets_of(*streams(), [](Model& model, const auto&) { RC_ASSERT(broken_laws(model.record()) == ""); });
  });
}

TEST(ModelLaws, TheSameCallsGiveTheSameBytes) {
  expect_law("Model (2)", 150, [] {
    const properties::Stream stream = *streams();
    RC_ASSERT(bytes_of(stream) == bytes_of(stream));
  });
}

TEST(ModelLaws, EveryReadingIsAccountedFor) {
  expect_law("Model (3)", 150, [] {
    const properties::Stream stream = *streams();
    std::int64_t readings = 0;
    std::size_t next = 0;
    for_sets_of(stream, [&](Model& model, const auto&) {
      if (next < stream.sets.size()) readings += std::ssize(stream.sets[next++]);
      const Counts counts = model.counts();
      RC_ASSERT(counts.points + counts.refused == readings);
      RC_ASSERT(points_in_segments(model.record()) + counts.expired == counts.points);
    });
  });
}

TEST(ModelLaws, TheChangesTellAllThatHappened) {
  expect_law("Model (4)", 150, [] {
    Ledger segments;
    NeighbourLedger neighbours;
    for_sets_of(*streams(), [&](Model& model, const std::vector<Change>& changes) {
      RC_ASSERT(segments.read(changes, model.record()) == "");
      RC_ASSERT(neighbours.read(changes, model.record()) == "");
    });
  });
}

TEST(ModelLaws, SharedEdgesArePairedAndSurfacesAreTheirComponents) {
  expect_law("Model (5)", 150, [] {
    for_sets_of(*streams(), [](Model& model, const auto&) {
      const ModelRecord record = model.record();
      std::map<std::uint64_t, std::uint64_t> partner, segment, surface;
      for (const auto& s : record.polygon_segments)
        for (const auto& c : s.cycles)
          for (const auto& v : c) {
            segment[v.edge] = s.id;
            if (v.partner) partner[v.edge] = v.partner;
          }
      const auto surfaces = model.surfaces();
      for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (const SegmentId id : surfaces[i]) RC_ASSERT(surface.emplace(id.value, i).second);
      for (const auto& [edge, other] : partner) {
        RC_ASSERT(partner.count(other) == 1u && partner[other] == edge);
        RC_ASSERT(segment[edge] != segment[other]);
        RC_ASSERT(surface.at(segment[edge]) == surface.at(segment[other]));
      }
    });
  });
}

TEST(ModelLaws, LookingChangesNothing) {
  expect_law("Model (6)", 100, [] {
    const properties::Stream stream = *streams();
    Model model(stream.parameters);
    if (one_of(2)) model.keep_labels();
    if (one_of(2)) model.measure_stages();
    for (const auto& set : stream.sets) {
      model.update(set);
      model.record(), model.surfaces(), model.counts(), model.labels();
    }
    model.open_edges();
    model.finish();
    RC_ASSERT(bytes(model.record()) == bytes_of(stream));
  });
}

TEST(ModelLaws, ReadingsThatAreNoneAreCountedAndChangeNothingElse) {
  expect_law("Model (7)", 100, [] {
    const properties::Stream stream = *streams();
    Model with(stream.parameters), without(stream.parameters);
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::int64_t refused = 0;
    for (const auto& set : stream.sets) {
      auto spoilt = set;
      for (auto n = whole(0, 2); n > 0; --n, ++refused) {
        const auto at = spoilt.begin() + whole(0, 99) % (std::ssize(spoilt) + 1);
        const Vector3d position = one_of(2) ? Vector3d(none, 0, 0) : Vector3d::Zero();
        spoilt.insert(at, SensorPoint{position, Vector3d::Zero(), 0});
      }
      with.update(spoilt);
      without.update(set);
    }
    with.finish(), without.finish();
    ModelRecord a = with.record();
    const ModelRecord b = without.record();
    RC_ASSERT(a.refused == b.refused + refused);
    a.refused = b.refused;
    RC_ASSERT(bytes(a) == bytes(b));
  });
}

TEST(ModelLaws, ItComesBackFromItsRecord) {
  expect_law("Model (8)", 100, [] {
    const properties::Stream stream = *streams();
    Model model(stream.parameters);
    for (const auto& set : stream.sets) model.update(set);
    const Model again(model.record());
    RC_ASSERT(bytes(again.record()) == bytes(model.record()));
  });
}

TEST(ModelLaws, AnEmptySetIsCountedAndChangesNothingElse) {
  expect_law("Model (9)", 100, [] {
    const properties::Stream stream = *streams();
    Model model(stream.parameters);
    for (const auto& set : stream.sets) {
      model.update(set);
      const ModelRecord before = model.record();
      const bool reported = !model.update({}).empty();
      ModelRecord after = model.record();
      RC_ASSERT(after.sets == before.sets + 1);
      after.sets = before.sets;
      RC_ASSERT(!reported && bytes(after) == bytes(before));
    }
  });
}

}  // namespace
}  // namespace limpet::model
