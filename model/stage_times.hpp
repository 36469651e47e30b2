// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet::model {

/// The time spent on each stage of the updates (steps of thesis §2.3), in seconds.
struct StageTimes {
  double insertion = 0;   ///< points joining segments (steps 1 and 2a for points)
  double dissolving = 0;  ///< dissolving young segments beside mature polygons
  double mergers = 0;     ///< of polygons (step 2a)
  double fissures = 0;    ///< step 3
  double sharing = 0;     ///< steps 4 and 5, and redundant segments
  double rest = 0;        ///< flags, outliers, and the other work of finish()
};

}  // namespace limpet::model
