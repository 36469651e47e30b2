// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

/// The numbers that decide, each with where it comes from and what it was measured against. What a user may
/// set is in Parameters; what only bounds work or memory says so.
namespace limpet::model::internal {

// Young segments, which keep their sensor points (rule `dissolve`, docs/rules.md).

/// Points up to which a segment is young. DESIGN: at 64 points the normal of a patch of λ² is known to about
/// a degree at a noise of λ/50. Measured with the experiments on segmentation rules: 32 to 128 do as well.
inline constexpr std::int64_t kYoung = 64;
/// Where points lie densely, 64 of them span too little to tell planes apart: then up to so many, while they
/// span less than kYoungArea (λ²), which is what 64 points span at five points per λ².
inline constexpr std::int64_t kMostYoung = 512;
inline constexpr double kYoungArea = 12;
/// A sensor point goes through at most this many dissolved segments, so that insertion ends.
inline constexpr int kMaxReturns = 4;
/// A patch of point segments that is promoted together has at least so many points (rule `patch`).
inline constexpr std::int64_t kPatch = 8;
/// A young segment is dissolved when this part of its points fits mature neighbours: one in five
/// (DESIGN §4: this is what removes slivers across edges).
inline constexpr std::size_t kFittingShare = 5;
/// Below one part in this many of the points that the rest of the scene received, what waits is no surface
/// (rule `arrival`); outliers that form planes are at one in a hundred and less on streams of 10⁸ points.
inline constexpr double kArrivalShare = 30;
/// Point segments of fewer points than this may expire; five is where promotion begins.
inline constexpr std::int64_t kFewestKept = 5;

// Relief (docs/noise.md), measured on nine Kinect images.

/// Points in a square that are too few to tell its height.
inline constexpr double kFewInSquare = 6;
/// Part of the tolerance by which a surface may bend within λ, and to which its height is known at best.
inline constexpr double kBend = 1.0 / 8, kKnown = 1.0 / 10;

// Charts and published planes (DESIGN §3).

/// tan² of the tilt between plane and chart beyond which the polygon gets a new chart (1°), and beyond which
/// a plane is not published on a chart at all (2.5°).
inline constexpr double kRechartTilt2 = 3.047e-4, kMaxTilt2 = 1.906e-3;
/// A plane is published anew when it moves a line of intersection by λ over this (DESIGN §3).
inline constexpr double kPublishPart = 16;

// Shared edges and corners (thesis §2.6, §2.7).

/// The copies of a shared edge's end, each rounded in its own chart, may be this many grid steps / sin θ
/// apart, θ the angle between the planes. The oracle allows 4.
inline constexpr double kEndSteps = 3.5;
/// Grid steps: no shorter shared edge is formed, nor left by a corner (λ/256); and a shorter one is given up
/// when planes move.
inline constexpr double kLeastSharedSteps = 16, kLeastKeptSteps = 8;
/// Below this sine of the angle between them (1.1°) two planes have no line to share edges on.
inline constexpr double kLeastSine = 0.02;
/// Grid steps: nearer than this to a vertex, a cut of the perimeter is at the vertex itself.
inline constexpr double kSameSteps = 3;
/// λ: how far sections are looked for from their line while readings come, and at the end of input
/// (rule `voids`); and the shortest edge that makes two segments neighbours, then and at last.
inline constexpr double kSectionReach = 1, kLastSectionReach = 5, kLeastNeighbours = 2,
                        kLastLeastNeighbours = 0.25;
/// λ: so far beyond what has changed sections may reach, at a look.
inline constexpr double kSectionReachOn = 2;
/// Two segments that face the same way to within 60° (its cosine) may lie on each other (thesis §2.9).
inline constexpr double kSameWay = 0.5;

// Bounds of work: with these an operation ends, and gives up where it would be slow.

inline constexpr std::size_t kMaxRing = 64;  ///< segments around one corner
inline constexpr int kMaxCornerOpen = 64;    ///< open edges between two shared ones that may meet in a corner
inline constexpr int kMaxOrderSteps = 256;   ///< edges to the next shared one, when asked whether order stays
inline constexpr int kMaxRepositionTries = 12;  ///< then all edges of the segment are unshared
inline constexpr int kMaxPairsFormed = 64;      ///< by one look at two segments
inline constexpr int kWaitingSeen = 8;  ///< polygons that wait for step 4, of which a set takes up so many
inline constexpr std::int64_t kFewestLooks = 4, kPointsPerLook = 4;  ///< looks at pairs in a set
/// Step 4 and the fit wait until a polygon has one part in so many more points (DESIGN §3).
inline constexpr std::int64_t kGrowthPart = 32;
inline constexpr int kMaxMergeRounds = 50;   ///< of step 2 in one set
inline constexpr int kMaxFinishRounds = 20;  ///< of steps 2 to 5 for each reach that finish() takes

}  // namespace limpet::model::internal
