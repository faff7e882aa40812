#include "cncsub/dialect/grblhal/use_of_words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/grblhal/codes.hpp"

namespace cncsub::grblhal {

namespace {

constexpr std::string_view kUnused = "Unused value words found in block.";

// G codes are in tenths. A, B, C, U, V and W are words of axes that a mill of three axes has not.
const WordUse kUses[] = {
    {'A', {}, {}, kUnused},
    {'B', {}, {}, kUnused},
    {'C', {}, {}, kUnused},
    {'D', {}, {}, kUnused},
    {'E', {}, {}, kUnused},
    {'H', {}, {}, kUnused},
    {'I', {20, 30, 50, 51, 510}, {}, kUnused},
    {'J', {20, 30, 50, 51, 510}, {}, kUnused},
    {'K', {20, 30, 510}, {}, kUnused},
    {'L', {100, 730, 810, 820, 830, 850, 860, 890}, {98}, kUnused},
    {'P',
     {20, 30, 40, 50, 100, 382, 383, 384, 385, 510, 820, 860, 890},
     {48, 49, 50, 51, 53, 98},
     kUnused},
    {'Q', {50, 730, 830}, {61}, kUnused},
    {'R', {20, 30, 730, 810, 820, 830, 850, 860, 890}, {}, kUnused},
    {'U', {}, {}, kUnused},
    {'V', {}, {}, kUnused},
    {'W', {}, {}, kUnused},
};

bool any_of(const std::vector<int>& there, std::initializer_list<int> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](int code) {
    return std::find(there.begin(), there.end(), code) != there.end();
  });
}

bool is_whole(double value) { return std::fabs(value - std::trunc(value)) < 0.001; }

WrongWord missing(char code, const char* detail, Kind kind = {}) {
  return {code, Cause::MotionWordMissing, detail, kind};
}

WrongWord below_zero(char letter) {
  return {letter, Cause::IllegalMinusSign, "the value is below zero"};
}

/// Return a wrong word of G10.
std::optional<WrongWord> against_data(const LineWords& line) {
  const double l = line.number('l', 0);
  if (line.has('l') && !line.values['l' - 'a']) return std::nullopt;
  if (l > 0 && !line.has_axes() && (l == 20 || !line.has('r')))
    return WrongWord{'g', Cause::G10Axis, "G10 sets nothing without an axis"};
  if (l > 0 && line.number('p', 0) < 0) return below_zero('p');
  if (l != 2 && l != 20)
    return WrongWord{line.has('l') ? 'l' : 'g', Cause::G10L, "the control has G10 L2 and L20"};
  if (l == 2 && line.has('r'))
    return WrongWord{'r', Cause::G10L, "the control does not turn work systems"};
  if (std::trunc(line.number('p', 0)) > 9)
    return WrongWord{'p', Cause::G10P, "the work systems are P1 to P9; P0 is the one in force"};
  return std::nullopt;
}

/// Return a wrong word of an arc that the line writes.
std::optional<WrongWord> against_arc(const LineWords& line) {
  const bool centre = line.has('i') || line.has('j') || line.has('k');
  if (!line.has('r') && !line.has_axes() && !centre)
    return WrongWord{'g', Cause::NoRadius, "an arc has a radius or a centre"};
  if (line.has('r') && !line.has_axes())
    return WrongWord{'g', Cause::NoArcTravel, "an arc by its radius has an end point", kNoAxis};
  if (const double turns = line.number('p', 1); !is_whole(turns))
    return WrongWord{'p', Cause::WholeNumberExpected, "P counts turns"};
  else if (std::trunc(turns) == 0)
    return WrongWord{'p', Cause::ValueOutOfRange, "P counts turns, from 1 on"};
  return std::nullopt;
}

std::optional<WrongWord> against_code(const LineWords& line) {
  if (line.has_m({61}) && !line.has('q')) return missing('m', "M61 has Q, the tool");
  if (line.has_m({48, 49, 50, 51, 53}) && line.number('p', 0) < 0) return below_zero('p');
  if (line.has_g({40}) && !line.has('p')) return missing('g', "G4 has P, the seconds");
  if (line.has_g({40}) && line.number('p', 0) < 0) return below_zero('p');
  if (line.has_g({431}) && !line.has_axes())
    return WrongWord{'g', Cause::LengthAxis, "G43.1 has the lengths of axes"};
  if (line.has_g({100}))
    if (auto found = against_data(line)) return found;
  if (line.has_g({920}) && !line.has_axes())
    return missing('g', "G92 has the coordinates of axes", kNoAxis);
  if (line.has_g({800}) && line.has_axes() && !line.has_g({100, 280, 300, 920}))
    return WrongWord{'g', Cause::NoMotionCode, "axes beside G80"};
  if (line.has_g({382, 383, 384, 385}) && !line.has_axes())
    return missing('g', "G38 has the end of its move", kNoAxis);
  return line.has_g({20, 30}) ? against_arc(line) : std::nullopt;
}

/// Return a word of a centre without an axis and without a code of an arc: nothing uses it.
std::optional<WrongWord> lone_centre(const LineWords& line) {
  if (line.has_axes() || line.has_g({20, 30, 50, 51, 510})) return std::nullopt;
  for (const char letter : {'i', 'j', 'k'})
    if (line.has(letter)) return WrongWord{letter, Cause::AddressNotUsable, std::string(kUnused)};
  return std::nullopt;
}

}  // namespace

bool LineWords::has_g(std::initializer_list<int> codes) const { return any_of(g, codes); }
bool LineWords::has_m(std::initializer_list<int> codes) const { return any_of(m, codes); }

std::optional<WrongWord> wrong_word(const LineWords& line) {
  for (const char letter : {'t', 'h'}) {
    if (!is_whole(line.number(letter, 0)))
      return WrongWord{letter, Cause::WholeNumberExpected, "the value is not whole"};
    if (line.number(letter, 0) < 0) return below_zero(letter);
  }
  for (const char letter : {'f', 's'})
    if (line.number(letter, 0) < 0) return below_zero(letter);
  if (line.computed) return std::nullopt;
  if (auto found = against_code(line)) return found;
  return lone_centre(line);
}

}  // namespace cncsub::grblhal

namespace cncsub {

const std::span<const WordUse> grblhal_word_uses = grblhal::kUses;

}  // namespace cncsub
