// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/simulation/mesh.hpp>
#include <string>

namespace limpet::app {

/// What a page shows beside the model or run itself.
struct PageOptions {
  std::string truth_name;
  const simulation::Mesh* truth = nullptr;  ///< the true surface, where it is known
  bool times = false;  ///< of each update, as measured now; else a page has the same bytes each time
  bool quiet = false;
};

/// The data of a page (docs/page_format.md) that shows a native model file. Errors: io::InputError, also when
/// the model is none that can be gone on with (Model's constructor).
std::string page_of_model(const std::string& path, const PageOptions&);

/// The data of a page that plays a recorded run. Its follower is asked again, as it was in the run, for what
/// it was after; where it moves otherwise than the run did, as that of another version may, that is left out
/// and a warning says so. Errors: io::InputError.
std::string page_of_run(const std::string& path, const PageOptions&);

}  // namespace limpet::app
