// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/checkpoint_keeper.hpp>

#include <cstdio>
#include <limpet/io/error.hpp>

namespace limpet::app {

void CheckpointKeeper::keep(const Checkpoint& checkpoint) {
  try {
    save_checkpoint(path_, checkpoint);
    failure_.clear();
  } catch (const io::OutputError& error) {
    if (failure_.empty())
      std::fprintf(stderr, "limpet: warning: %s; the run goes on, and tries again\n", error.what());
    failure_ = error.what();
  }
}

}  // namespace limpet::app
