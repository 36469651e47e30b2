// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/io/error.hpp>
#include <limpet/model/parameters.hpp>
#include <limpet/survey/estimate.hpp>
#include <limpet/survey/noise_law.hpp>
#include <limpet/survey/point_stream.hpp>
#include <limpet/survey/resolution_law.hpp>
#include <optional>
#include <string>

/// Looks at a scan before it is modelled, and chooses what to model it to.
///
///     survey::PointStream points("scan.ply");
///     const survey::Choice choice = survey::choose(points);
///     if (!points.has_axes()) points.orient(choice.voxel_edge);
///     model::Model model(choice.parameters);
///     survey::OrderedPoints ordered(points, {.cell = choice.near_resolution});
///     std::vector<model::SensorPoint> set;
///     while (ordered.next_set(set)) model.update(set);
///     model.finish();
///
/// That is what `limpet model` does, too, and gives the same model to the last bit.
namespace limpet::survey {

/// What is known of a scan beforehand, lengths in the scan's unit. What is left out is chosen from the scan.
struct Known {
  std::optional<ResolutionLaw> resolution{};  ///< λ
  std::optional<NoiseLaw> noise{};
  std::optional<double> tolerance{};  ///< how far from its plane a surface may be
  /// All that no scan tells. The resolution, noise and tolerance in it are not looked at.
  model::Parameters others{};
};

/// What was chosen, and what it was chosen by.
struct Choice {
  model::Parameters parameters;
  Known known;  ///< as given
  std::optional<Estimate>
      estimate;  ///< what the scan tells about itself; nothing where nothing had to be asked
  /// Of the voxels by which a scan without sensing axes is oriented (PointStream::orient()), scan's unit; 0:
  /// the scan says its axes.
  double voxel_edge = 0;
  /// λ where the scan is near its sensors (at 5 % of the ranges), or everywhere: the cell of the curve along
  /// which it is put in order (Ordering::cell), scan's unit.
  double near_resolution = 0;
  std::int64_t points = -1;  ///< how many points the scan has; -1: not known
};

/// The scan has too few points on a surface, or none, to choose a resolution by.
class TooFewPoints : public io::InputError {
  using io::InputError::InputError;
};

/// Chooses λ, the noise and the tolerance, as far as they are not known, from the first two million points;
/// the points are still all to be read afterwards. So are the places of the sensors, where λ grows with the
/// range. Of a pipe, nothing is modelled before so many have come: give resolution and noise for one that
/// never ends. What is chosen has four significant digits, so that it can be printed and given again. The
/// same scan gives the same choice. Precondition: nothing of the stream has been read. Errors: io::InputError
/// when the scan holds no point, or when the noise or λ is known to grow with the range but the scan does not
/// say its points' ranges; TooFewPoints.
Choice choose(PointStream& points, const Known& known = {});

/// Throws io::InputError when the scan holds no point. Precondition: nothing has been read yet.
void require_points(PointStream& points);

/// Says what was chosen and why, a line each for resolution, noise and tolerance, for people.
std::string explanation(const Choice& choice);

}  // namespace limpet::survey
