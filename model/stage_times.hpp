// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet::model {

/// Where the time of updates went, step by step (thesis §2.3), in seconds.
struct StageTimes {
  double insertion = 0;   ///< points find their segments (steps 1 and 2a for points)
  double dissolving = 0;  ///< young segments beside mature polygons
  double mergers = 0;     ///< of polygons
  double fissures = 0;    ///< step 3
  double sharing = 0;     ///< steps 4 and 5
  double rest = 0;        ///< flags, outliers, and what else finishing does
};

}  // namespace limpet::model
