// Copyright the limpet authors. GPL-3.0-or-later.
#include <filesystem>
#include <limpet/app/pages.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/native.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>
#include <stdexcept>

#include "page_builder_internal.hpp"

namespace limpet::app {
namespace {

model::Model load(const std::string& path) {
  const model::ModelRecord record = io::load_native(path);
  try {
    return model::Model(record);
  } catch (const std::invalid_argument& error) {
    throw io::InputError(path, std::string("the model is damaged: ") + error.what() +
                                   "; 'limpet check' tells all that is wrong");
  }
}

/// The middle of all there is: near it floats are fine.
Eigen::Vector3d middle_of(const model::View& view) {
  std::vector<model::SegmentId> segments;
  view.segments(segments);
  Eigen::AlignedBox3d box;
  for (const model::SegmentId id : segments) box.extend(view.segment(id)->box);
  return box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(box.center());
}

}  // namespace

std::string page_of_model(const std::string& path, const PageOptions& options) {
  const model::Model model = load(path);
  const drawing::TimelineSpace space{middle_of(model.view()),
                                     drawing::timeline_step(model.parameters().resolution)};
  internal::PageBuilder page("model", std::filesystem::path(path).filename().string(), model.parameters(),
                             space);
  drawing::Timeline timeline(space);
  const auto reasons = model.open_edges();
  timeline.add(model.view(), {}, {.reasons = &reasons});
  page.add(timeline);
  if (options.truth) page.add_truth(options.truth_name, *options.truth);
  return page.bytes();
}

}  // namespace limpet::app
