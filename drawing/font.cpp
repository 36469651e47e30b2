// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/drawing/font.hpp>
#include <string_view>

namespace limpet::drawing {
namespace {

// Every letter is one or more polylines, a pair of digits a point: x from 0 to 4, y from 0 (top of capitals)
// over 2 (top of small letters) and 6 (base line) to 8 (descenders). A polyline of one point twice is a dot.
constexpr std::string_view kGlyphs[95] = {
    "", "2024 2626", "1012 3032", "1016 3036 0242 0444", "413010010213334445361605 2026",
    "0010110100 3545463635 4006", "4612112031320405163644", "2022", "30212536", "10212516", "2125 0244 0442",
    "2125 0343", "2617", "1333", "2626", "0640",
    // 0 to 9
    "103041453616050110", "112026 1636", "01103041420646", "0110304142334445361605 2333", "36300444",
    "4000023243453606", "4130100105163645443303", "004016", "13020110304142331304051636454433",
    "0516364541301001021343",
    // : ; < = > ? @
    "2323 2626", "2323 2617", "311335", "0242 0444", "113315", "01103041422324 2626",
    "343212144441301001051646",
    // A to Z
    "062046 1434", "003041423303 334445360600", "4130100105163645", "00304145360600", "40000646 0333",
    "400006 0333", "41301001051636454323", "0006 4046 0343", "1030 2026 1636", "3035261605", "0006 4004 1346",
    "000646", "0600234046", "06004640", "103041453616050110", "06003041423303", "103041453616050110 2446",
    "06003041423303 2346", "413010010213334445361605", "0040 2026", "000516364540", "002640", "0016233640",
    "0046 4006", "002340 2326", "00400646",
    // [ \ ] ^ _ `
    "30202636", "0046", "10202616", "122032", "0747", "1021",
    // a to z
    "12324346 441405163645", "0006 0312324345361605", "4332120305163645", "4046 4332120305163645",
    "044443321203051636", "30201116 0232", "4332120305163645 4247381807", "0006 0312324346", "2226 2020",
    "32372818 3030", "0006 3205 1436", "202536", "0206 03122326 23324346", "0206 0312324346",
    "123243453616050312", "0208 0312324345361605", "4248 4332120305163645", "0206 031232",
    "43321203143445361605", "10152636 0232", "0205163645 4246", "022642", "0216233642", "0246 4206",
    "0226 4218", "02420646",
    // { | } ~
    "30212213242536", "2027", "10212233242516", "03123443"};

std::string_view glyph(char c) { return c >= ' ' && c <= '~' ? kGlyphs[c - ' '] : kGlyphs['?' - ' ']; }

/// Leftmost and rightmost x of a letter; a blank counts as narrow.
std::pair<int, int> extent(std::string_view glyph) {
  int left = 4, right = 0;
  for (std::size_t i = 0; i < glyph.size(); ++i) {
    if (glyph[i] == ' ') continue;
    left = std::min(left, glyph[i] - '0');
    right = std::max(right, glyph[i] - '0');
    ++i;  // over y
  }
  return glyph.empty() ? std::pair(0, 1) : std::pair(left, right);
}

bool continues_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }  // UTF-8

constexpr double kGap = 1.7;  // between letters

}  // namespace

double text_width(const std::string& text, double size) {
  double width = 0;
  for (const char c : text) {
    if (continues_letter(c)) continue;
    const auto [left, right] = extent(glyph(c));
    width += right - left + kGap;
  }
  return std::max(0.0, width - kGap) * size / 6;
}

std::vector<Mark> strokes(const Label& label) {
  std::vector<Mark> marks;
  const double unit = label.size / 6;
  double pen = label.left;
  for (const char c : label.text) {
    if (continues_letter(c)) continue;
    const std::string_view shape = glyph(c);
    const auto [left, right] = extent(shape);
    const auto point = [&, from = left](std::size_t i) {
      return Eigen::Vector2d(pen + unit * (shape[i] - '0' - from),
                             label.base + unit * (shape[i + 1] - '0' - 6));
    };
    for (std::size_t i = 0; i + 3 < shape.size(); i += 2) {
      if (shape[i + 2] == ' ') {
        ++i;  // the next polyline
        continue;
      }
      marks.push_back({point(i), point(i + 2), 0.85 * unit, label.color});
    }
    pen += unit * (right - left + kGap);
  }
  return marks;
}

}  // namespace limpet::drawing
