// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/kinematics/robot.hpp>

namespace limpet::kinematics {

/// r of thesis §3.3: no point of the robot (of its bodies, its sensors and switches, the control point) is
/// ever farther than this from the axis of any revolute joint that moves it. An upper bound: what a joint
/// carries is taken to stretch as far as its parts' lengths add up to, within the limits of prismatic joints
/// and without regard to those of revolute ones. 0 for a robot without revolute joints; infinite where a
/// prismatic joint without limits is beyond a revolute one.
double largest_reach(const Robot&);

/// γ by thesis §3.3: the largest changes of the actuators for which no joint moves any point of the robot
/// farther than its sensors sense: for prismatic joints the sensing range, for revolute ones the range
/// divided by largest_reach(), and half of each where a robot has both. No ceiling for kinds of joints that
/// it does not have.
///
/// As in the thesis this looks at one joint at a time. The length of the vector of changes of n joints being
/// γ, a point can be moved by up to √n times the range when all turn it the same way, each as far from it as
/// the farthest: a check of clearance along the step is still needed. Precondition: the range is positive.
/// Throws std::invalid_argument when the reach is infinite.
Ceilings ceilings_for(const Robot&, double sensing_range);

}  // namespace limpet::kinematics
