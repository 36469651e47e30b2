// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <cstdio>
#include <limpet/app/commands.hpp>
#include <limpet/app/estimate.hpp>
#include <limpet/app/point_stream.hpp>
#include <limpet/model/model.hpp>
#include <optional>
#include <string>

/// What `limpet model` chooses by the scan, as far as its arguments leave that open.
namespace limpet::app {

/// What the scan says of itself, from a look ahead that is taken when first asked for, and once.
class LookAhead {
 public:
  explicit LookAhead(PointStream& scan) : scan_(scan) {}

  const Estimate& estimate();
  /// How many points the scan has; −1: not known.
  std::int64_t points() const;

 private:
  std::int64_t most() const;

  PointStream& scan_;
  std::optional<Estimate> found_;
};

/// The scan as messages name it.
std::string name_of(const PointStream& scan, const ModelArguments& args);

/// With --json - standard output is for the summary alone.
std::FILE* for_people(const ModelArguments& args);

/// Throws io::InputError when the scan holds no point, or not what --noise asks for.
void require_points(PointStream& scan, const ModelArguments& args);

/// λ, noise and tolerance as given, or else from the scan. Throws io::InputError when that does not tell.
model::Parameters choose_parameters(const ModelArguments& args, PointStream& scan, LookAhead& ahead);

/// Says which of the parameters were not given.
void say_choice(const ModelArguments& args, const model::Parameters& parameters);

/// Of the voxels by which a scan that says no axes is oriented (see Orientation), scan's unit.
double voxel_edge(LookAhead& ahead, double resolution);

/// Gives such a scan its axes from its own shape, which can only be a guess.
void orient(PointStream& scan, const ModelArguments& args, double voxel_edge);

}  // namespace limpet::app
