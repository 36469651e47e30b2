// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/kinematics/robot.hpp>
#include <numbers>

namespace limpet::kinematics {

/// What the manipulator arm of thesis §4.3 is made of. Lengths are those of the thesis, where it has them.
struct ArmOptions {
  double link_length = 1;
  /// Of the links. The thesis has no value for it. This one leaves a link that is held a sensing range away
  /// from a surface three quarters of that range, and makes it as thin against its length as arms are.
  double radius = 0.05;
  double sensing_range = 0.2;
  /// How much of link 4, before the control point, has no body: "the description of the control point's link
  /// does not include the control point and the region of radius δ surrounding" it (§3.3), and δ is 0.1.
  double bare_tip = 0.1;
  double ceiling_rad = 3.8 * (std::numbers::pi / 180);  ///< γ
};

/// The same arm, all lengths of it `factor` times as long.
ArmOptions scaled(ArmOptions, double factor);

/// The four-link manipulator arm (thesis §4.3, figures 39 and 40): links of one length, the first immobile,
/// so that the first joints are at its end; six revolute joints without limits, two at the base of each
/// moving link, whose axes cross there at right angles; the control point at the end of link 4. Sensors: 17
/// at the control point, the directions of the point robot without those that point back into the arm; then
/// 40, 40 and 36 around links 2 to 4.
///
/// The figures are lost, so this is chosen: in the configuration 0 the arm stands straight up, from the
/// origin along z, and the joints turn about x and y. 40 = 10 × 4 and 36 = 9 × 4: rings of four sensors at
/// every tenth of a link, every other ring turned by 45°, on link 4 without the one at the control point. A
/// link is a capsule, its sensors are on its surface and look straight outwards.
///
/// Links, in this order: link1, turn2, link2, turn3, link3, turn4, link4, where turn2 is what the first joint
/// of link 2 moves: it has no extent. Throws std::invalid_argument unless radius and bare tip are 0 or more,
/// together less than nine tenths of a link, and the other values positive.
Robot arm(const ArmOptions& = {});

}  // namespace limpet::kinematics
