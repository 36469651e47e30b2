// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet::app {

/// From now on the first SIGINT or SIGTERM only sets a flag, so that what there is can be written; a second
/// one ends the program as usual.
void catch_interrupts();

/// True once a signal has come.
bool interrupted();

}  // namespace limpet::app
