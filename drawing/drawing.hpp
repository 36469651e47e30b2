// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/drawing/robot_figure.hpp>
#include <limpet/model/open_edges.hpp>
#include <limpet/model/record.hpp>
#include <optional>
#include <string>
#include <vector>

namespace limpet::drawing {

/// One model on the sheet, and the text above it.
struct Figure {
  model::ModelRecord model;
  std::string caption;
  std::vector<model::OpenEdge> open_edges = {};  ///< why they are open, where that is known
  /// A way past the model, world; where faces hide it, it is not seen. A dot at each place.
  std::vector<Eigen::Vector3d> way = {};
  std::optional<RobotFigure> robot = {};  ///< as solids, lit; its rays and switches where nothing hides them
};

/// A parallel projection.
struct View {
  Eigen::Vector3d toward =
      -Eigen::Vector3d::UnitZ();                  ///< where the viewer looks, world; need not have length 1
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< upwards in the picture, world; not along `toward`
  std::string name;                               ///< written under the picture; may be empty
};

struct DrawOptions {
  int width = 1600;         ///< of the sheet, pixels, 200 to 16384; the height follows
  std::vector<View> views;  ///< empty: default_views
  bool common_frame =
      true;  ///< all figures in one place at one scale (stages of growth), or each fills its own
  bool loose_points = true;  ///< dots where point segments are
  bool vertices = true;      ///< dots at vertices
  bool legend = true;        ///< what the colours mean, and how much there is of it
};

/// Views that show these models well: two opposite oblique ones and one from above for bodies; for what was
/// seen from one side only, three from that side. For several figures the first two.
std::vector<View> default_views(const std::vector<Figure>& figures);

/// The view from a direction, given as seen from the model (world; need not have length 1), and named by it.
/// Where no `up` is given, up is z, or y in a view along z. Errors: std::invalid_argument when the direction
/// has no length or `up` lies along it.
View view_from(const Eigen::Vector3d& from, const std::optional<Eigen::Vector3d>& up = {});

/// Draws models onto one sheet, as PNG or SVG by the extension of `path`: one figure with its views side by
/// side, or several side by side (four in a row) with their views below each other. Faces in a colour per
/// segment, shaded, their back sides grey; shared edges dark, open edges in a colour for each thing that
/// refused them a neighbour, orange where that is not known or there is none; ways blue where they begin and
/// red where they end, over faces that are paler then; robots dark, their rays green, pale where they met
/// nothing, switches that see something amber. The same models give the same bytes. Errors:
/// OutputError, also for another extension; std::invalid_argument for options out of bounds.
void draw(const std::vector<Figure>& figures, const std::string& path, const DrawOptions& options);

}  // namespace limpet::drawing
