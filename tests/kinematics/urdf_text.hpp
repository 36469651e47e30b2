// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>

/// URDFs put together from pieces.
namespace limpet::kinematics::testing {

inline std::string robot_of(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"robot\">\n" + inside + "</robot>\n";
}

inline std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

inline std::string shape(const std::string& geometry, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry>" + geometry + "</geometry></collision>";
}

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inside + "</joint>\n";
}

}  // namespace limpet::kinematics::testing
