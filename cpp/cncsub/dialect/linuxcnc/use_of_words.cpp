// The check for words that no code of the line uses: the interpreter refuses them. [rs274 2.9:
// check_other_codes, enhance_block]
#include "cncsub/dialect/linuxcnc/use_of_words.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "cncsub/dialect/dialect.hpp"

namespace cncsub::linuxcnc {

namespace {

bool any_of(const std::vector<int>& there, std::initializer_list<int> wanted) {
  return std::any_of(there.begin(), there.end(), [&](int code) {
    return std::find(wanted.begin(), wanted.end(), code) != wanted.end();
  });
}

// The words of G81 to G89 are written out; G codes are in tenths.
const WordUse kUses[] = {
    {'D',
     {410, 420, 411, 421, 700, 710, 711, 712, 720, 721, 722, 960},
     {},
     "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 or G96 to use it"},
    {'E', {760, 330, 331, 700}, {66, 67, 68}, "E word with no G70, G76, M66, M67 or M68 to use it"},
    {'H', {430, 432, 760}, {}, "H word with no G43 or G76 to use it"},
    {'I',
     {20, 30, 50, 51, 710, 711, 712, 720, 721, 722, 760, 870, 331, 100},
     {},
     "I word with no G2, G3, G5, G5.1, G10, G33.1, G76, or G87 to use it"},
    {'J',
     {20, 30, 50, 51, 760, 870, 100},
     {},
     "J word with no G2, G3, G5, G5.1, G10, G76 or G87 to use it"},
    {'K',
     {20, 30, 330, 331, 760, 870},
     {},
     "K word with no G2, G3, G33, G33.1, G76, or G87 to use it"},
    {'L',
     {810, 820, 830, 840, 850, 860, 870, 880, 890, 760, 52, 730, 100, 410, 411, 420, 421},
     {66, 98},
     "L word with no G10, cutter compensation, canned cycle, digital/analog input, M98 or NURBS "
     "code"},
    {'P',
     {100, 40, 640, 760, 820, 860, 880, 890, 50, 52, 700, 20, 30, 740, 840},
     {50, 51, 52, 53, 62, 63, 64, 65, 66, 19, 98},
     "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89 or M50 M51 M52 M53 M62 M63 M64 "
     "M65 M66 M98 or user M code to use it"},
    {'Q',
     {830, 730, 50, 760, 100, 640, 700, 710, 711, 712, 720, 721, 722},
     {66, 67, 68, 61, 19},
     "Q word with no G5, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it",
     -1},
    {'R',
     {20,  30,  760, 710, 711, 712, 720, 721, 722, 810, 820, 830,
      840, 850, 860, 870, 880, 890, 730, 740, 411, 421, 100},
     {19},
     "R word with no g code that uses it"},
};

constexpr std::string_view kAxes = "xyzabcuvw@^";
constexpr std::string_view kArcWords = "rijk";

/// Return whether a code belongs to the motion group, G80 left out.
bool is_motion(int code10) {
  const bool low = code10 <= 30 || (code10 >= 50 && code10 <= 53);
  const bool cycle = code10 >= 700 && code10 <= 890 && code10 != 800;
  return low || cycle || code10 == 330 || code10 == 331 || (code10 >= 382 && code10 <= 385);
}

bool has_axes(const LineWords& line) {
  return std::any_of(kAxes.begin(), kAxes.end(), [&](char axis) { return line.has(axis); });
}

/// Return whether the line has a motion code that needs an axis.
bool needs_axes(const LineWords& line) {
  return std::any_of(line.g.begin(), line.g.end(), [](int code10) {
    const bool without = code10 <= 30 || code10 == 52 || (code10 >= 700 && code10 <= 722);
    return is_motion(code10) && !without;
  });
}

/// Return a word that is missing, or that stands beside a code which takes none.
std::optional<WrongWord> against_code(const LineWords& line) {
  if (line.has_g({800}) && has_axes(line) && !line.has_g({100, 280, 300, 520, 920})) {
    const char axis =
        *std::find_if(kAxes.begin(), kAxes.end(), [&](char c) { return line.has(c); });
    return WrongWord{axis, Cause::AddressNotUsable, "Cannot use axis values with g80"};
  }
  if (const bool none = !has_axes(line); none && (line.has_g({520}) || line.has_g({920})))
    return WrongWord{'g', Cause::MotionWordMissing, "All axes missing with g52 or g92"};
  if (line.has_g({100}) && line.number('l', 0) == 2 && !line.has('p'))
    return WrongWord{'g', Cause::G10P, "P value out of range (0-9) with G10 L2"};
  if (line.has_g({40}) && (!line.has('p') || line.number('p', 0) == -1))
    return WrongWord{'g', Cause::MotionWordMissing, "Dwell time missing with g4"};
  if (line.has_g({40}) && line.has_g({20, 30}))
    return WrongWord{'g', Cause::OneShotWithMotion,
                     "G4 not allowed with G2 or G3 because they both use P"};
  if (line.has_g({330, 331}) && line.has('f'))
    return WrongWord{'f', Cause::AddressNotUsable, "F word used with g33 move"};
  if (needs_axes(line) && !has_axes(line))
    return WrongWord{'g', Cause::MotionWordMissing, "All axes missing with motion code"};
  if (line.has_g({20, 30}) && !has_axes(line) &&
      std::none_of(kArcWords.begin(), kArcWords.end(), [&](char c) { return line.has(c); }))
    return WrongWord{'g', Cause::NoRadius, "R i j k words all missing for arc"};
  const auto motion = std::find_if(line.g.begin(), line.g.end(), is_motion);
  if (motion != line.g.end() && line.has_g({100, 280, 300, 520, 920}))
    return WrongWord{'g', Cause::OneShotWithMotion,
                     "Cannot use two g codes that both use axis values"};
  return std::nullopt;
}

WrongWord wrong(char letter, Cause cause, std::string_view text) {
  return {letter, cause, std::string(text)};
}

/// Return a word whose number M19, which turns the spindle to an angle, does not take.
std::optional<WrongWord> against_orientation(const LineWords& line) {
  const double p = line.number('p', 0), r = line.number('r', 0), q = line.number('q', 1);
  if (std::fabs(std::round(p) - p) > 0.001)
    return wrong('p', Cause::ValueOutOfRange, "P value not an integer with M19 G2 or G3");
  if (std::round(p) < 0 || std::round(p) > 2)
    return wrong('p', Cause::ValueOutOfRange, "P value must be 0,1,or 2 with M19");
  if (r < 0 || r > 360)
    return wrong('r', Cause::ValueOutOfRange, "R value must be within 0..360 with M19");
  if (q <= 0) return wrong('q', Cause::ValueOutOfRange, "Q word with M19 requires a value > 0");
  return std::nullopt;
}

/// Return a word that an M code or the spindle needs and that is missing or wrong.
std::optional<WrongWord> against_m(const LineWords& line) {
  if (line.has_g({960}) && !line.has('s'))
    return wrong('g', Cause::MotionWordMissing, "S word missing with G96");
  if (line.has_g({432}) && !line.has('h') && !has_axes(line))
    return wrong('g', Cause::MotionWordMissing, "G43.2: No axes specified and H word missing");
  if (line.m.empty()) return std::nullopt;
  for (const int m : {62, 63, 64, 65})
    if (line.has_m({m}) && !line.has('p'))
      return wrong('m', Cause::MotionWordMissing, "No valid P word with M" + std::to_string(m));
  for (const int m : {67, 68})
    if (line.has_m({m}) && (!line.has('e') || std::round(line.number('e', 0)) < 0))
      return wrong('m', Cause::MotionWordMissing,
                   "Invalid analog index with M" + std::to_string(m));
  if (line.has_m({61}) && (!line.has('q') || std::round(line.number('q', 0)) < 0))
    return wrong('m', Cause::MotionWordMissing,
                 "Need non-negative Q-word to specify tool number with M61");
  return line.has_m({19}) ? against_orientation(line) : std::nullopt;
}

}  // namespace

std::optional<WrongWord> below_zero(const LineWords& line) {
  static constexpr std::pair<char, std::string_view> kTexts[] = {
      {'f', "Negative f word used"},
      {'l', "Negative l word used"},
      {'s', "Negative spindle speed used"},
      {'t', "Negative tool id (tool not found)"},
  };
  for (const auto& [letter, text] : kTexts)
    if (line.number(letter, 0) < 0)
      return WrongWord{letter, Cause::ValueOutOfRange, std::string(text)};
  return std::nullopt;
}

bool LineWords::has_g(std::initializer_list<int> codes) const { return any_of(g, codes); }
bool LineWords::has_m(std::initializer_list<int> codes) const { return any_of(m, codes); }

bool is_in_mode(const LineWords& line) {
  const bool code = std::any_of(line.g.begin(), line.g.end(), is_motion) || line.has_g({800});
  return !code && !line.has_g({100, 280, 300, 520, 920}) &&
         (has_axes(line) || line.has('i') || line.has('j') || line.has('k'));
}

std::uint32_t unused_letters(const LineWords& line) {
  std::uint32_t letters = 0;
  for (const WordUse& use : kUses) {
    const auto letter = static_cast<char>(use.letter - 'A' + 'a');
    if (line.has(letter) && line.number(letter, 0) != use.none && !line.has_g(use.g) &&
        !line.has_m(use.m))
      letters |= 1u << (use.letter - 'A');
  }
  return letters;
}

std::optional<WrongWord> wrong_word(const LineWords& line) {
  if (auto found = below_zero(line)) return found;
  const bool own = std::any_of(line.m.begin(), line.m.end(), [](int code) { return code >= 100; });
  if (line.computed || own) return std::nullopt;
  if (auto found = against_code(line)) return found;
  if (auto found = against_m(line)) return found;
  if (is_in_mode(line)) return std::nullopt;
  const std::uint32_t unused = unused_letters(line);
  for (const WordUse& use : kUses)
    if ((unused >> (use.letter - 'A') & 1) != 0)
      return wrong(static_cast<char>(use.letter - 'A' + 'a'), Cause::AddressNotUsable, use.text);
  return std::nullopt;
}

}  // namespace cncsub::linuxcnc

namespace cncsub {

const std::span<const WordUse> linuxcnc_word_uses = linuxcnc::kUses;

}  // namespace cncsub
