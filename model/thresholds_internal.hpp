// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

/// Thresholds, with their sources and what they were measured against. Those that a user may set are in
/// Parameters; those that only bound work or memory come last.
namespace limpet::model::internal {

// Young segments, which keep their sensor points (rule `dissolve`, docs/rules.md).

/// Most points of a young segment. With 64 points, the normal of a patch of λ² is known to about a degree at
/// a noise of λ/50. In the experiments on segmentation rules, 32 to 128 did as well.
inline constexpr std::int64_t kYoung = 64;
/// Where points are dense, 64 of them span too little to tell planes apart. Then a segment is young with up
/// to this many points, as long as they span less than kYoungArea (in λ²), about what 64 points span at five
/// points per λ².
inline constexpr std::int64_t kMostYoung = 512;
inline constexpr double kYoungArea = 12;
/// A segment is not dissolved by rule `dissolve` if one of its points has been in this many that were, so
/// that insertion ends.
inline constexpr int kMaxReturns = 4;
/// Fewest points of a patch of point segments that is promoted together (rule `patch`).
inline constexpr std::int64_t kPatch = 8;
/// A young segment is dissolved when at least one in this many of its points fits mature neighbours. This is
/// what removes slivers across edges.
inline constexpr std::size_t kFittingShare = 5;
/// A segment that got fewer points than one in this many of what its area would get elsewhere in the scene is
/// no surface (rule `arrival`). Outliers that form planes get one in a hundred and less on streams of 10⁸
/// points.
inline constexpr double kArrivalShare = 30;
/// Point segments of fewer points than this may expire; five is where promotion begins.
inline constexpr std::int64_t kFewestKept = 5;

/// Fewest points of a young polygon that are given back, and by how much less they and the others lie off
/// their planes then, in variances (rule `strays`).
inline constexpr std::size_t kFewestStrays = 2;
inline constexpr double kStrayGain = 16;

// Relief (docs/noise.md), measured on nine Kinect images.

/// Fewest points with which the height of a square is taken from the square alone.
inline constexpr double kFewInSquare = 6;
/// Parts of the tolerance: by how much a surface may bend within λ, and how well its height is known at best.
inline constexpr double kBend = 1.0 / 8, kKnown = 1.0 / 10;

// Charts and published planes.

/// tan² of the tilt between plane and chart beyond which the polygon gets a new chart (1°), and beyond which
/// a plane is not published on a chart at all (2.5°).
inline constexpr double kRechartTilt2 = 3.047e-4, kMaxTilt2 = 1.906e-3;
/// A plane is published anew when it may move a line of intersection by more than λ over this.
inline constexpr double kPublishPart = 16;

// Shared edges and corners (thesis §2.6, §2.7).

/// The two copies of a shared edge's end, each rounded in its own chart, may be this many grid steps / sin θ
/// apart, θ being the angle between the planes. The laws of audit/ allow 4.
inline constexpr double kEndSteps = 3.5;
/// In grid steps: the shortest shared edge that is formed, or left by a corner (about λ/256); and the
/// shortest one that is kept when planes move.
inline constexpr double kLeastSharedSteps = 16, kLeastKeptSteps = 8;
/// Below this sine of the angle between them (1.1°) two planes have no line to share edges on.
inline constexpr double kLeastSine = 0.02;
/// Below this sine of the angle between them two lines say too little of where they meet; a corner's edges
/// then run on in one line. Its place is found by other planes, and may be this far (λ) from theirs. The laws
/// of audit/ allow a fifth and a quarter.
inline constexpr double kRunsOnSine = 0.199, kRunsOnReach = 0.24;
/// Part of the largest of the sums of squares of planes below which they do not determine a point.
inline constexpr double kDetermined = 0.01;
/// In grid steps: how far a corner steps back between its edges where it would touch another vertex, and how
/// far it may then be from the planes of its neighbours.
inline constexpr double kDoubledSteps = 1.25, kDoubledOff = 1.9;
/// In λ: a shared edge up to this long gives way when a corner at one of its ends would turn it round.
inline constexpr double kShortCorner = 0.5;
/// In grid steps: a cut of the perimeter within this distance of a vertex is made at the vertex itself.
inline constexpr double kSameSteps = 3;
/// In λ: how far sections may be from their line while readings come, and at the end of input (rule `voids`);
/// and the shortest edge that makes two segments neighbours, while readings come and in the last rounds.
inline constexpr double kSectionReach = 1, kLastSectionReach = 5, kLeastNeighbours = 2,
                        kLastLeastNeighbours = 0.25;
/// In λ, and in lengths of the edge: how deep a bay may be that a shared edge closes, if one of the two
/// allows it. Chance reaches 2.3 λ into a corner.
inline constexpr double kDeepBay = 2.3, kDeepestBay = 3;
/// In λ: how far beyond a changed place sections may reach when it is looked at.
inline constexpr double kSectionReachOn = 2;
/// Cosine of the largest angle, 60°, between the normals of two segments one of which may lie on the other
/// (thesis §2.9).
inline constexpr double kSameWay = 0.5;

/// A segment that is redundant by position lies on others with at least so many times its points: of two that
/// were felt alike neither is (rule `position`).
inline constexpr std::int64_t kLargerPart = 2;
/// In λ: the least length and the greatest mean width of a sliver across an edge, which is deleted although
/// it shares edges with the faces there (rule `position`). Two in sixty CAD parts at 36 points per λ².
inline constexpr double kLeastSliver = 4, kSliverWidth = 0.9;
/// In λ: the greatest mean width of a polygon that got only what another left over along its edge, and the
/// part of that one's density below which it did. Along edges of 18° to 26° in CAD parts at 36 points per λ²
/// such slivers are 1.5 to 3.1 λ wide and were felt 0.4 to 0.5 times as densely.
inline constexpr double kLeftOverWidth = 4, kLeftOverPart = 0.6;
/// In λ: the greatest mean width of what lies across an edge of faces that were all felt more densely. Two in
/// sixty CAD parts at 36 points per λ² are 1.2 and 1.5 λ wide and were felt 0.4 and 0.5 times as densely.
inline constexpr double kAcrossWidth = 2;

// Pinches (rule `pinches`).

/// In λ: how far from the lines of two others' planes a polygon is asked whether it is there. A merger of two
/// parts closes what is nearer than half of this.
inline constexpr double kPinchDepth = 0.75;
/// In λ: how far along the lines the others are asked for.
inline constexpr double kPinchArm = 1.5;
/// In λ: what is wider there is no bridge between two parts that came near each other. Two corners of 90°
/// make one of λ, of 60° one of 1.7.
inline constexpr double kPinchWidth = 1.75;
/// Least sine of half the angle between the two lines.
inline constexpr double kLeastPinchSine = 0.25;
/// In λ²: the smallest part that is taken for a face.
inline constexpr double kLeastPart = 2;
/// Fewest readings that a part may stand for.
inline constexpr std::int64_t kFewestOfPart = 5;

// What finishing may add (rule `voids`, chance.cpp).

/// So many empty discs as large as one that is closed may be left by chance in a whole scan.
inline constexpr double kDiscsByChance = 0.01;
/// In λ: by how much readings lie outside a perimeter on average, of which those within λ/4 have not extended
/// it (rule `near`). None left a false hole in 2 of 6 plates at three points per λ², λ/4 filled half of the
/// true ones of 2.7 λ there.
inline constexpr double kUnextended = 1.0 / 8;
/// In λ: the smallest half side of a square of places that is divided further.
inline constexpr double kLeastPlace = 1.0 / 24;

// Readings that pass through a polygon (rule `rays`).

/// In λ, beside noise and tolerance: how far a reading must be behind a plane that it has passed, and in
/// gaps, how far from the perimeter it must pass to have passed through the polygon: perimeters reach out a
/// little.
inline constexpr double kPassedBehind = 0.25, kPassedInside = 0.25;
/// In readings to λ²: so many are looked at.
inline constexpr double kLookedAt = 4;
/// A polygon is no surface when at least so many of these have passed through it, and one reading for so many
/// of its own.
inline constexpr std::int64_t kFewestPassages = 3, kPassedShare = 4;
/// In λ: how far apart places are kept where readings have passed, and how many of them.
inline constexpr double kPassagesApart = 0.5;
inline constexpr std::size_t kMostPassages = 64;
/// A place is not filled where at least so many have passed.
inline constexpr std::int64_t kFewestThroughVoid = 2;

// Bounds of work: they make an operation end, and give up where it would be slow.

inline constexpr std::size_t kMaxRing = 64;  ///< segments around one corner
inline constexpr int kMaxCornerOpen = 64;    ///< open edges between two shared ones that may meet in a corner
inline constexpr int kMaxOrderSteps = 256;   ///< edges searched for the next shared one, in order_stays()
inline constexpr int kMaxRepositionTries = 12;  ///< then all edges that were to move are unshared
inline constexpr int kMaxPairsFormed = 64;      ///< by one look at two segments
inline constexpr int kWaitingSeen = 8;          ///< polygons waiting for step 4 that a set takes up
inline constexpr std::int64_t kFewestLooks = 4,
                              kPointsPerLook = 4;  ///< looks at pairs in a set
/// Step 4 and the fit wait until a polygon has grown by one part in this many.
inline constexpr std::int64_t kGrowthPart = 32;
/// Rounds in which the strays of one young polygon are found; turns over all of them, as what one gives back
/// may be another's stray.
inline constexpr int kMaxPartingRounds = 8, kMaxPartingTurns = 3;
inline constexpr int kMaxMergeRounds = 50;   ///< of step 2 in one set
inline constexpr int kMaxFinishRounds = 20;  ///< of steps 2 to 5 for each reach that finish() takes

}  // namespace limpet::model::internal
