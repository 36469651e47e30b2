// Copyright the limpet authors. GPL-3.0-or-later.
#include "cloud_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace limpet::benchmarks {

CloudFile::CloudFile(const CloudSpec& spec, const Limits& limits) {
  std::string name = limits.scratch + "/limpet_bench_XXXXXX";
  descriptor_ = ::mkstemp(name.data());
  if (descriptor_ < 0) throw std::runtime_error("cannot write in " + limits.scratch);
  ::unlink(name.c_str());
  answer_ = ask_process({{"what", "cloud"}, {"spec", spec}, {"cloud", path()}}, limits.own_seconds);
  if (!answer_.contains("failed")) return;
  ::close(descriptor_);
  throw std::runtime_error("no cloud: " + answer_["failed"].get<std::string>());
}

CloudFile::~CloudFile() { ::close(descriptor_); }

NamedFile::NamedFile(const Limits& limits, const std::string& ending)
    : path_(limits.scratch + "/limpet_bench_XXXXXX" + ending) {
  const int descriptor = ::mkstemps(path_.data(), static_cast<int>(ending.size()));
  if (descriptor < 0) throw std::runtime_error("cannot write in " + limits.scratch);
  ::close(descriptor);
}

NamedFile::~NamedFile() { ::unlink(path_.c_str()); }

}  // namespace limpet::benchmarks
