// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/io/color.hpp>
#include <limpet/io/triangulate.hpp>
#include <string>
#include <vector>

/// A drawing made ready for any medium. Units are pixels; x to the right, y down; points in panels carry
/// as z the distance from the viewer, in pixels too.
namespace limpet::drawing {

constexpr io::Color kPaper = {255, 255, 255}, kInk = {38, 42, 50}, kPale = {120, 126, 136};
constexpr io::Color kSharedEdge = {38, 42, 50}, kLoosePoint = {64, 90, 160};
constexpr io::Color kBackSide = {168, 170, 174};
constexpr io::Color kWayBegins = {40, 130, 200}, kWayEnds = {176, 0, 84};
constexpr io::Color kRobot = {104, 118, 138}, kRay = {10, 143, 106}, kMiss = {179, 186, 196},
                    kSeeing = {224, 164, 0};

/// One boundary cycle of a face: point i, and the colour of the edge from it to the next.
struct Outline {
  std::vector<Eigen::Vector3d> points;
  std::vector<io::Color> edges;
  bool open(std::size_t i) const { return edges[i] != kSharedEdge; }
};

/// A face, filled with one colour.
struct Patch {
  std::vector<Outline> outlines;
  std::vector<io::Triangle> triangles;  ///< over the concatenated outlines
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  io::Color fill{};
  bool round = false;  ///< a facet of something round: without lines on its rim or dots at its corners
};

/// A short straight part of a way or of a ray, with round ends; a dot where both ends are one.
struct LinePiece {
  Eigen::Vector3d from, to;
  double width = 1;
  io::Color color{};
};

/// A picture of one model from one side. Nothing is drawn outside of its rectangle.
struct Panel {
  double left = 0, top = 0, width = 0, height = 0;
  std::vector<Patch> patches;
  std::vector<Eigen::Vector3d> loose;
  std::vector<LinePiece> lines;
  double shared_width = 1.6, open_width = 2.6, vertex_radius = 2.4, loose_radius = 1.6, way_width = 1.2;
};

/// A line of text: (left, base) is the left end of its base line, `size` the height of its capitals.
struct Label {
  double left = 0, base = 0, size = 0;
  io::Color color = kInk;
  std::string text;
};

/// A straight stroke with round ends, on top of everything; a dot where both ends are one.
struct Mark {
  Eigen::Vector2d from, to;
  double width = 1;
  io::Color color = kInk;
};

struct Sheet {
  int width = 0, height = 0;
  std::vector<Panel> panels;
  std::vector<Label> labels;
  std::vector<Mark> marks;
};

}  // namespace limpet::drawing
