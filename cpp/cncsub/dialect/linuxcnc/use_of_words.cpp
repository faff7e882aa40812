// The interpreter refuses words that no code of the line uses. [rs274 2.9: check_other_codes,
// enhance_block]
#include "cncsub/dialect/linuxcnc/use_of_words.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace cncsub::linuxcnc {

namespace {

bool any_of(const std::vector<int>& there, std::initializer_list<int> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](int code) {
    return std::find(there.begin(), there.end(), code) != there.end();
  });
}

/// A letter, and the codes that it belongs to.
struct Use {
  char letter;
  std::initializer_list<int> g, m;
  std::string_view text;
};

// What goes with G81 to G89 is written out; G in tenths.
const Use kUses[] = {
    {'d',
     {410, 420, 411, 421, 700, 710, 711, 712, 720, 721, 722, 960},
     {},
     "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 or G96 to use it"},
    {'e', {760, 330, 331, 700}, {66, 67, 68}, "E word with no G70, G76, M66, M67 or M68 to use it"},
    {'h', {430, 432, 760}, {}, "H word with no G43 or G76 to use it"},
    {'i',
     {20, 30, 50, 51, 710, 711, 712, 720, 721, 722, 760, 870, 331, 100},
     {},
     "I word with no G2, G3, G5, G5.1, G10, G33.1, G76, or G87 to use it"},
    {'j',
     {20, 30, 50, 51, 760, 870, 100},
     {},
     "J word with no G2, G3, G5, G5.1, G10, G76 or G87 to use it"},
    {'k',
     {20, 30, 330, 331, 760, 870},
     {},
     "K word with no G2, G3, G33, G33.1, G76, or G87 to use it"},
    {'l',
     {810, 820, 830, 840, 850, 860, 870, 880, 890, 760, 52, 730, 100, 410, 411, 420, 421},
     {66},
     "L word with no G10, cutter compensation, canned cycle, digital/analog input, M98 or NURBS "
     "code"},
    {'p',
     {100, 40, 640, 760, 820, 860, 880, 890, 50, 52, 700, 20, 30, 740, 840},
     {50, 51, 52, 53, 62, 63, 64, 65, 66, 19},
     "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89 or M50 M51 M52 M53 M62 M63 M64 "
     "M65 M66 M98 or user M code to use it"},
    {'q',
     {830, 730, 50, 760, 100, 640, 700, 710, 711, 712, 720, 721, 722},
     {66, 67, 68, 61, 19},
     "Q word with no G5, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it"},
    {'r',
     {20,  30,  760, 710, 711, 712, 720, 721, 722, 810, 820, 830,
      840, 850, 860, 870, 880, 890, 730, 740, 411, 421, 100},
     {19},
     "R word with no g code that uses it"},
};

constexpr std::string_view kAxes = "xyzabcuvw@^";

/// Codes of the motion group, G80 left out.
bool is_motion(int code10) {
  const bool low = code10 <= 30 || (code10 >= 50 && code10 <= 53);
  const bool cycle = code10 >= 700 && code10 <= 890 && code10 != 800;
  return low || cycle || code10 == 330 || code10 == 331 || (code10 >= 382 && code10 <= 385);
}

bool has_axes(const LineWords& line) {
  return std::any_of(kAxes.begin(), kAxes.end(), [&](char axis) { return line.has(axis); });
}

/// Whether a motion code stands in the line that does not do without an axis.
bool needs_axes(const LineWords& line) {
  return std::any_of(line.g.begin(), line.g.end(), [](int code10) {
    const bool without = code10 <= 30 || code10 == 52 || (code10 >= 700 && code10 <= 722);
    return is_motion(code10) && !without;
  });
}

/// Words that are missing, or that stand beside a code which wants none.
std::optional<WrongWord> against_code(const LineWords& line) {
  if (line.has_g({800}) && has_axes(line) && !line.has_g({100, 280, 300, 520, 920})) {
    const char axis =
        *std::find_if(kAxes.begin(), kAxes.end(), [&](char c) { return line.has(c); });
    return WrongWord{axis, Cause::AddressNotUsable, "Cannot use axis values with g80"};
  }
  if (const bool none = !has_axes(line); none && (line.has_g({520}) || line.has_g({920})))
    return WrongWord{'g', Cause::MotionWordMissing, "All axes missing with g52 or g92"};
  if (line.has_g({40}) && !line.has('p'))
    return WrongWord{'g', Cause::MotionWordMissing, "Dwell time missing with g4"};
  if (needs_axes(line) && !has_axes(line))
    return WrongWord{'g', Cause::MotionWordMissing, "All axes missing with motion code"};
  const auto motion = std::find_if(line.g.begin(), line.g.end(), is_motion);
  if (motion != line.g.end() && line.has_g({100, 280, 300, 520, 920}))
    return WrongWord{'g', Cause::OneShotWithMotion,
                     "Cannot use two g codes that both use axis values"};
  return std::nullopt;
}

/// Numbers below zero where there are none.
std::optional<WrongWord> below_zero(const LineWords& line) {
  static constexpr std::pair<char, std::string_view> kTexts[] = {
      {'f', "Negative f word used"},
      {'l', "Negative l word used"},
      {'s', "Negative spindle speed used"},
      {'t', "Negative tool id (tool not found)"},
  };
  for (const auto& [letter, text] : kTexts)
    if (line.negative.contains(letter))
      return WrongWord{letter, Cause::ValueOutOfRange, std::string(text)};
  return std::nullopt;
}

}  // namespace

bool LineWords::has_g(std::initializer_list<int> codes) const { return any_of(g, codes); }
bool LineWords::has_m(std::initializer_list<int> codes) const { return any_of(m, codes); }

std::optional<WrongWord> wrong_word(const LineWords& line) {
  if (auto wrong = below_zero(line)) return wrong;
  const bool own = std::any_of(line.m.begin(), line.m.end(), [](int code) { return code >= 100; });
  if (line.computed || own) return std::nullopt;
  if (auto wrong = against_code(line)) return wrong;
  // A line with axes and without a motion code goes on in the mode, which may use the word.
  const bool code = std::any_of(line.g.begin(), line.g.end(), is_motion) || line.has_g({800});
  const bool mode = !code && (has_axes(line) || line.has('i') || line.has('j') || line.has('k')) &&
                    !line.has_g({100, 280, 300, 520, 920});
  if (mode) return std::nullopt;
  for (const Use& use : kUses)
    if (line.has(use.letter) && !line.has_g(use.g) && !line.has_m(use.m))
      return WrongWord{use.letter, Cause::AddressNotUsable, std::string(use.text)};
  return std::nullopt;
}

}  // namespace cncsub::linuxcnc
