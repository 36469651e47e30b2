// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <limpet/drawing/page_data.hpp>
#include <limpet/drawing/timeline.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/model/parameters.hpp>
#include <limpet/simulation/mesh.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace limpet::app::internal {

/// Three numbers.
nlohmann::json json_of(const Eigen::Vector3d&);
/// A robot as docs/page_format.md has it.
nlohmann::json json_of(const kinematics::Robot&);

/// Puts together what a page shows (docs/page_format.md).
class PageBuilder {
 public:
  /// `kind`: model or run. `name`: of the file.
  PageBuilder(const std::string& kind, const std::string& name, const model::Parameters&,
              const drawing::TimelineSpace&);

  nlohmann::json head;
  drawing::PageData data;

  /// The true surface, to be seen beside or over the model.
  void add_truth(const std::string& name, const simulation::Mesh&);
  void add(const drawing::Timeline&);
  std::string bytes() const { return data.bytes(head.dump()); }

 private:
  drawing::TimelineSpace space_;
};

}  // namespace limpet::app::internal
