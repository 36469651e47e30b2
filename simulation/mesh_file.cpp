// Copyright the limpet authors. GPL-3.0-or-later.
//
// The files are read here and not by OpenMesh, whose readers round positions to single precision, stop at a
// comment before an OFF header, take other comments for numbers, and refuse surfaces that are no manifold:
// a world to be scanned may be all of that.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limpet/io/byte_source.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/ply_header.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/mesh.hpp>
#include <string_view>
#include <utility>

namespace limpet::simulation {
namespace {

struct Soup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
};

/// Words of a text, comments (from # to the line's end) left out.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word; empty at the end of the text, or of the line if `same_line`.
  std::string_view next(bool same_line = false) {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (rest_.starts_with("\\\n") || rest_.starts_with("\\\r\n")) {  // OBJ: the line goes on
        rest_.remove_prefix(rest_.find('\n') + 1);
      } else if (c == '\n' && same_line) {
        return {};
      } else if (std::isspace(static_cast<unsigned char>(c))) {
        rest_.remove_prefix(1);
      } else {
        break;
      }
    }
    std::size_t length = 0;
    while (length < rest_.size() && !std::isspace(static_cast<unsigned char>(rest_[length]))) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

 private:
  std::string_view rest_;
};

template <typename Number>
Number number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A value too small for a double is as good as zero, but from_chars calls it an error.
  if (error == std::errc::result_out_of_range && word.find("e-") != std::string_view::npos) return 0;
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    throw MeshError(word.empty() ? "the file ends too early"
                                 : "not a number: " + std::string(word.substr(0, 40)));
  return value;
}

Eigen::Vector3d position(Words& words) {
  Eigen::Vector3d p;
  for (int k = 0; k < 3; ++k) p[k] = number<double>(words.next());
  return p;
}

/// A count from a file's header, distrusted: memory is taken as the data come, not as the header says.
long count(std::string_view word) {
  const long n = number<long>(word);
  if (n < 0 || n > 1'000'000'000) throw MeshError("no sensible count: " + std::string(word));
  return n;
}

Soup read_off(std::string_view text) {
  Words words(text);
  std::string_view word = words.next();
  if (word.ends_with("OFF")) {
    if (word.find_first_of("4n") != std::string_view::npos)
      throw MeshError("OFF of other than three dimensions");
    word = words.next();
    if (word == "BINARY") throw MeshError("binary OFF cannot be read");
  }
  const long vertices = count(word), polygons = count(words.next());
  words.skip_line();  // the number of edges, which many files leave out
  Soup soup;
  for (long v = 0; v < vertices; ++v) {
    soup.vertices.push_back(position(words));
    words.skip_line();
  }
  for (long f = 0; f < polygons; ++f) {
    std::vector<int>& polygon = soup.polygons.emplace_back();
    for (long corners = count(words.next()); corners > 0; --corners)
      polygon.push_back(number<int>(words.next()));
    words.skip_line();
  }
  return soup;
}

Soup read_obj(std::string_view text) {
  Words words(text);
  Soup soup;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      soup.vertices.push_back(position(words));
    } else if (word == "f") {
      std::vector<int>& polygon = soup.polygons.emplace_back();
      for (word = words.next(true); !word.empty(); word = words.next(true)) {
        const int v = number<int>(word.substr(0, word.find('/')));
        polygon.push_back(v < 0 ? static_cast<int>(soup.vertices.size()) + v : v - 1);
      }
    }
    words.skip_line();
  }
  return soup;
}

/// Little-endian bytes, as STL has them.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  template <typename Number>
  Number take() {
    if (rest_.size() < sizeof(Number)) throw MeshError("the file ends too early");
    Number value;
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
  }

 private:
  std::string_view rest_;
};

Soup read_stl(std::string_view data) {
  Soup soup;
  const auto add_triangle_when_full = [&] {
    const int n = static_cast<int>(soup.vertices.size());
    if (n % 3 == 0) soup.polygons.push_back({n - 3, n - 2, n - 1});
  };
  // Some binary files start with "solid" too, so the size decides.
  std::uint32_t triangles = 0;
  if (data.size() >= 84) triangles = Bytes(data.substr(80)).take<std::uint32_t>();
  if (data.size() >= 84 && (data.size() == 84 + 50 * std::size_t{triangles} || !data.starts_with("solid"))) {
    Bytes bytes(data.substr(84));
    for (std::uint32_t t = 0; t < triangles; ++t) {
      for (int k = 0; k < 3; ++k) bytes.take<float>();  // the normal: told by the corners' order as well
      for (int corner = 0; corner < 3; ++corner) {
        Eigen::Vector3d p;
        for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(bytes.take<float>());
        soup.vertices.push_back(p);
        add_triangle_when_full();
      }
      bytes.take<std::uint16_t>();
    }
    return soup;
  }
  if (!data.starts_with("solid")) throw MeshError("neither text nor binary STL");
  Words words(data);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid" || word == "endsolid") words.skip_line();  // a name may be any word
    if (word != "vertex") continue;
    soup.vertices.push_back(position(words));
    add_triangle_when_full();
  }
  return soup;
}

/// The numbers of a PLY file's body, whichever way they are written.
class PlyBody {
 public:
  PlyBody(std::string_view body, io::PlyHeader::Encoding encoding)
      : words_(body), bytes_(body), encoding_(encoding) {}

  double next(io::NumberType type) {
    if (encoding_ == io::PlyHeader::Encoding::kAscii) return number<double>(words_.next());
    const std::size_t size = io::size_of(type);
    if (bytes_.size() < size) throw MeshError("the file ends too early");
    const double value = io::decode(bytes_.data(), type, encoding_ == io::PlyHeader::Encoding::kBigEndian);
    bytes_.remove_prefix(size);
    return value;
  }

  std::vector<int> next_list(const io::PlyProperty& property) {
    const double length = next(property.count_type);
    if (!(length >= 0 && length < 1e9)) throw MeshError("no sensible length of a list");
    std::vector<int> list;
    for (long k = 0; k < static_cast<long>(length); ++k) {
      const double v = next(property.type);
      list.push_back(std::abs(v) < 2e9 ? static_cast<int>(v) : -1);
    }
    return list;
  }

 private:
  Words words_;
  std::string_view bytes_;
  io::PlyHeader::Encoding encoding_;
};

/// `data` is all of the file at `path`.
Soup read_ply(const std::string& path, std::string_view data) {
  io::ByteSource source(path);
  const io::PlyHeader header = io::read_ply_header(source);
  PlyBody body(data.substr(std::min(static_cast<std::size_t>(source.offset()), data.size())),
               header.encoding);
  Soup soup;
  for (const io::PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no room in the file, however many there are
    for (std::int64_t i = 0; i < element.count; ++i) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (const io::PlyProperty& property : element.properties) {
        if (property.is_list) {
          auto list = body.next_list(property);
          if (element.name == "face" && property.name.starts_with("vertex_ind"))
            soup.polygons.push_back(std::move(list));
          continue;
        }
        const double value = body.next(property.type);
        if (property.name.size() == 1 && property.name >= "x" && property.name <= "z")
          p[property.name.front() - 'x'] = value;
      }
      if (element.name == "vertex") soup.vertices.push_back(p);
    }
  }
  return soup;
}

using Format = Soup (*)(const std::string& path, std::string_view data);

Format format_of(const std::string& path) {
  const std::string ending = io::extension_of(path);
  if (ending == "off") return [](const std::string&, std::string_view data) { return read_off(data); };
  if (ending == "stl") return [](const std::string&, std::string_view data) { return read_stl(data); };
  if (ending == "obj") return [](const std::string&, std::string_view data) { return read_obj(data); };
  if (ending == "ply") return read_ply;
  throw MeshError("not a mesh file (known: .off, .stl, .obj, .ply)");
}

void require_file(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw MeshError("is a folder, not a mesh file");
  if (std::filesystem::is_character_file(path)) throw MeshError("is a device, not a mesh file");
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string data{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw MeshError("cannot be read");
  return data;
}

}  // namespace

Mesh load_mesh(const std::string& path, double planarity, bool keep_inward) {
  try {
    require_file(path);
    const Format read = format_of(path);
    const Soup soup = read(path, bytes_of(path));
    Mesh mesh = make_mesh(soup.vertices, soup.polygons, planarity);
    if (!keep_inward && count_edges(mesh).open == 0 && signed_volume(mesh) < 0)
      for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
  } catch (const io::InputError& error) {  // names the file
    throw MeshError(error.what());
  } catch (const MeshError& error) {
    throw MeshError(path + ": " + error.what());
  }
}

}  // namespace limpet::simulation
