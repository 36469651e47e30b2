// Copyright the limpet authors. GPL-3.0-or-later.
// Where the robot's links and sensors are, of its joints' positions (as kinematics::Posture has it).
import { Matrix4, Vector3 } from "three";

/// Poses of the links in the scene. `shift` is added to the world's places.
export function linkPoses(robot, joints, shift) {
  const poses = [];
  let joint = 0;
  robot.links.forEach((link) => {
    const m = link.mounting;
    const mounting = new Matrix4().set(
      m[0],
      m[1],
      m[2],
      m[9],
      m[3],
      m[4],
      m[5],
      m[10],
      m[6],
      m[7],
      m[8],
      m[11],
      0,
      0,
      0,
      1,
    );
    const pose = link.parent >= 0 ? poses[link.parent].clone() : new Matrix4().makeTranslation(...shift);
    pose.multiply(mounting);
    if (link.kind !== "fixed") {
      const q = joints[joint++];
      const axis = new Vector3(...link.axis);
      pose.multiply(
        link.kind === "prismatic"
          ? new Matrix4().makeTranslation(axis.multiplyScalar(q))
          : new Matrix4().makeRotationAxis(axis, q),
      );
    }
    poses.push(pose);
  });
  return poses;
}

/// Of each sensor, or switch, its position, its axis and its range.
export function sensorPoses(sensors, poses) {
  return sensors.map(({ link, position, axis, range }) => ({
    position: new Vector3(...position).applyMatrix4(poses[link]),
    axis: new Vector3(...axis).transformDirection(poses[link]),
    range,
  }));
}
export const jointCount = (robot) => robot.links.filter((link) => link.kind !== "fixed").length;
