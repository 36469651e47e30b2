// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/checkpoint_keeper.hpp>

#include <cstdio>
#include <limpet/io/error.hpp>
#include <new>

namespace limpet::app {

void CheckpointKeeper::keep(const std::function<Checkpoint()>& taken) {
  std::string failure;
  try {
    save_checkpoint(path_, taken(), scan_);
  } catch (const io::OutputError& error) {
    failure = error.what();
  } catch (const std::bad_alloc&) {
    failure = path_ + ": cannot be written: there is not enough memory for the state of the run";
  }
  if (!failure.empty() && failure_.empty())
    std::fprintf(stderr, "limpet: warning: %s; the run goes on, and tries again\n", failure.c_str());
  failure_ = failure;
}

}  // namespace limpet::app
