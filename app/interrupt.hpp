// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet::app {

/// From now on the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that what there is can be written; a
/// second one, of whichever kind, ends the program as usual. A SIGHUP that is ignored stays so.
void catch_interrupts();

/// True once a signal has come.
bool interrupted();

}  // namespace limpet::app
