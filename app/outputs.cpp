// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/outputs.hpp>

#include <limpet/io/error.hpp>
#include <new>

namespace limpet::app {

void Outputs::attempt(const std::string& name, const std::function<void()>& write) {
  try {
    write();
  } catch (const io::OutputError& error) {
    add(error.what());
  } catch (const std::bad_alloc&) {
    add(name + ": there is not enough memory to write it");
  }
}

void Outputs::add(const std::string& failure) { failures_ += (failures_.empty() ? "" : "; ") + failure; }

void Outputs::require_all() const {
  if (failed()) throw io::OutputError(failures_);
}

}  // namespace limpet::app
