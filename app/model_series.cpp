// Copyright the limpet authors. GPL-3.0-or-later.
#include <filesystem>
#include <limpet/app/model_series.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/drawing/page.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/model/model.hpp>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// Models of a series, one by one, and the list of them.
class Series {
 public:
  explicit Series(const std::string& path) : path_(path), folder_(fs::path(path).replace_extension()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw io::OutputError(folder_.string() + ": the folder cannot be made: " + error.message());
  }

  void add(std::int64_t sets, const model::ModelRecord& model) {
    const std::string name = "stage" + std::to_string(count_++) + ".vtp";
    io::save_mesh((folder_ / name).string(), model);
    list_ += "    <DataSet timestep=\"" + std::to_string(sets) + "\" part=\"0\" file=\"" +
             drawing::html_text(folder_.filename().string()) + "/" + name + "\"/>\n";
  }

  void close() {
    io::OutputFile file(path_);
    file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" +
               list_ + "  </Collection>\n</VTKFile>\n");
    file.close();
  }

 private:
  std::string path_;
  fs::path folder_;
  std::string list_;
  int count_ = 0;
};

}  // namespace

model::ModelRecord model_at_end(const std::string& run) {
  RunReader reader(run);
  model::Model model = model_before(reader.head());
  for (RunSet set; reader.next(set);) model.update(set.sensed.points);
  if (!reader.is_whole() || reader.end().reason != "interrupted") model.finish();
  return model.record();
}

void save_series(const std::string& path, const std::string& run, int stages, bool quiet) {
  const std::int64_t total = count_sets(run);
  RunReader reader(run);
  model::Model model = model_before(reader.head());
  Series series(path);
  Progress progress("playing", total, quiet);
  std::int64_t sets = 0, next = 1;
  for (RunSet set; reader.next(set);) {
    model.update(set.sensed.points);
    progress.step(++sets);
    if (sets * stages >= next * total) {
      series.add(sets, model.record());
      next = sets * stages / total + 1;
    }
  }
  if (!reader.is_whole() || reader.end().reason != "interrupted") {
    model.finish();
    series.add(sets + 1, model.record());
  }
  progress.clear();
  series.close();
}

}  // namespace limpet::app
