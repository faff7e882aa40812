#include "cncsub/flat/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cncsub/control/code_calls.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/motion/state/facts.hpp"
#include "cncsub/motion/state/values.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub {

namespace {

constexpr std::string_view kLengths = "ABCHIJKQRUVWXYZ";  // whole numbers may be increments
constexpr std::string_view kAlwaysLengths = "BUVWXYZ";
constexpr std::string_view kWithoutPoint = "DGHLMNOPST";  // numbers of something, where whole
constexpr std::size_t kLeastDecimals = 3;                 // that every number counts as having

bool is_in(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}
/// Return the letter whose rules hold for an address. A radius and an angle are written as X and Y.
char letter_of(int place) {
  if (place >= kRadius) return place == kRadius ? 'X' : 'Y';
  return place >= kCommaC ? kCommaLetters[static_cast<std::size_t>(place - kCommaC)]
                          : static_cast<char>('A' + place);
}

/// Return whether = stands between an address and its value.
bool needs_equals(std::string_view address) { return address.size() > 1 && address.front() != ','; }

using NumberReader = decltype(Spelling::read_number);

/// Return the text with the fewest digits that a language reads as a number, of those that lie
/// nearest to it; empty where it reads none of them so.
std::string text_as_read(double value, NumberReader read) {
  constexpr int kMostDigits = 9, kNear = 64;
  const double size = std::fabs(value);
  if (size == 0) return "0";
  const int whole = static_cast<int>(std::floor(std::log10(size))) + 1;
  for (int decimals = 0; decimals + whole <= kMostDigits; ++decimals) {
    const double scale = std::pow(10.0, decimals), nearest = std::round(size * scale);
    const int most = decimals + whole == kMostDigits ? kNear : 0;  // its own rounding is less exact
    for (int away = 0; away <= 2 * most; ++away) {
      const double tried = nearest + (away % 2 == 0 ? away / 2 : -(away + 1) / 2);
      std::string text = system::shortest_fixed(tried / scale);
      if (read(text) == size) return (value < 0 ? "-" : "") + text;
    }
  }
  return "";
}

std::string text_in(double value, const Spelling& language) {
  const NumberReader read = language.read_number;
  std::string text;
  if (read != nullptr && std::isfinite(value)) text = text_as_read(value + 0.0, read);
  return text.empty() ? system::shortest_fixed(value + 0.0) : text;
}

}  // namespace

NumberText::NumberText(double value) : NumberText(value, system::shortest_fixed(value + 0.0)) {}
NumberText::NumberText(double value, const Spelling& language)
    : NumberText(value, text_in(value, language)) {}
NumberText::NumberText(double value, std::string text) : text_(std::move(text)) {
  end_of_whole_ = std::min(text_.find('.'), text_.size());
  whole_ = end_of_whole_ - (value < 0 ? 1 : 0);
  if (std::fabs(value) < 1) whole_ = 0;
}

std::string expression_text(double value, int most_digits) {
  const NumberText number(value);
  const std::string_view text = number.text();
  const std::size_t point = std::min(text.find('.'), text.size());
  const bool negative = text[0] == '-';
  std::string sum;
  int digits = 0;  // of the last number of the sum
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool counts = text[i] >= (digits == 0 ? '1' : '0') && text[i] <= '9';
    if (counts && ++digits > most_digits && i > point) {
      sum += negative ? "-0." : "+0.";
      sum.append(i - point - 1, '0');
      digits = text[i] == '0' ? 0 : 1;
    }
    sum += text[i];
  }
  return sum;
}

std::string expression_text(double value, const Code& code) {
  return code.spelling->long_numbers
             ? std::string(NumberText(value, *code.spelling).text())
             : expression_text(value, code.control->macros.max_constant_digits.value);
}

std::string value_text(double value, const Code& code) {
  return is_vacant(value) ? "#0" : expression_text(value, code);
}

WordWriter::WordWriter(const Machine& machine, const Machine& to)
    : machine_(machine),
      code_(to.code()),
      control_(*code_.control),
      lathe_(machine.motion().view().facts.lathe()),
      rounds_(rounds_computed(*machine.code().control) || rounds_computed(control_)),
      increments_(control_.reading.whole_numbers.value == WholeNumbers::Increments),
      mills_axes_(!lathe_ && !control_.motion.angles_on_mills.value) {
  for (const auto& entry : control_.calls.registered_codes.value)
    calling_.emplace_back(entry.letter, entry.code == 0 ? -1 : entry.code * 10);
  each_code_call(control_, [this](const CodeCall& list, std::int32_t number, std::int32_t /*of*/) {
    if (list.form == CodeCall::Form::Switch)
      calling_.emplace_back(list.address, -1);
    else if (list.address == '@')  // the parameter holds a letter
      calling_.emplace_back(static_cast<char>(number > 0 && number < 128 ? number : 0), -1);
    else if (number != 0)
      calling_.emplace_back(list.address, list.tenths_of(std::abs(number)));
  });
  std::sort(calling_.begin(), calling_.end());
}

void WordWriter::begin(const BlockCodes& codes) {
  const MotionState& state = machine_.motion().state();
  const Meaning once = codes.meaning(Group::OneShot);
  const Meaning motion = state.modal[at(Group::Motion)].meaning;
  const bool one_shot = codes.has(Group::OneShot) && once != Meaning::None;
  dwell_ = once == Meaning::Dwell;
  plain_ = !dwell_ && state.modal[at(Group::Polar)].meaning != Meaning::PolarOn;
  arc_ = !one_shot && !in_cycle(state) && (motion == Meaning::Cw || motion == Meaning::Ccw) &&
         !codes.has(Group::Scaling) && !codes.has(Group::Rotation);
  cycle_ = !one_shot && !lathe_ && in_cycle(state);
}

/// Round a computed value as the control does; return false where that is not sure.
bool WordWriter::round(int place, double& value) const {
  const char letter = letter_of(place);
  const MotionView view = machine_.motion().view();
  const bool corner = plain_ && rounds_ && (place == kCommaC || place == kCommaR);
  if (corner || (place < kCommaC && rounds(letter)))
    value = cncsub::rounded(view, corner ? 'X' : letter, value);
  else if (dwell_ && rounds_ && is_in(kAlwaysLengths, letter))
    value = std::round(value * 1000) / 1000;
  else
    return false;
  return true;
}

/// Return whether the control surely rounds a computed value here to its least increment.
bool WordWriter::rounds(char letter) const {
  if (!plain_ || !rounds_) return false;
  if (is_in(kAlwaysLengths, letter)) return true;
  if (letter == 'A' || letter == 'C') return mills_axes_;
  if (letter == 'R') return arc_ || cycle_;
  return (arc_ && is_in("IJK", letter)) || (cycle_ && letter == 'Q');
}

/// Return whether a plain number counts increments where a computed one counts units.
bool WordWriter::counts_increments(char letter, double value) const {
  if (!lathe_ || value != std::floor(value)) return false;
  if (letter == 'H') return increments_;
  return letter != 'P' && !is_in(kAlwaysLengths, letter) &&
         control_.turning.cycle_unit.value == CycleUnit::Increments;
}

bool WordWriter::calls(char letter, double code) const {
  const auto listed = [&](std::int64_t tenths) {
    return std::binary_search(calling_.begin(), calling_.end(), std::pair(letter, tenths));
  };
  return listed(to_whole<std::int64_t>(std::round(code * 10))) || listed(-1);
}

/// Return whether the number is written with a point. Without, it counts increments where lengths
/// do.
bool WordWriter::points(char letter, const NumberText& text) const {
  return text.decimals() > 0 || !is_in(kWithoutPoint, letter);
}

/// Return whether the control takes the plain number, and for this value.
bool WordWriter::takes(char letter, bool comma, double value, const NumberText& text,
                       bool rounded) const {
  if (value < 0 && !control_.reading.minus_addresses.value.has(letter)) return false;
  const bool can_point = control_.reading.point_addresses.value.has(letter);
  const bool point = points(letter, text) && (can_point || text.decimals() > 0);
  if (point && !can_point) return false;
  if (!point && increments_ && is_in(kLengths, letter) && letter != 'H') return false;
  const std::size_t digits = text.whole() + (point ? kLeastDecimals : 0);
  if (digits > static_cast<std::size_t>(most_digits(control_))) return false;
  const bool cut = control_.reading.cuts_fine_digits.value && is_in(kLengths, letter);
  if (cut && !rounded && text.decimals() > kLeastDecimals) return false;
  if (!comma && !rounded && counts_increments(letter, value)) return false;
  return letter != 'P' || text.decimals() == 0;
}

bool WordWriter::computed(std::string& to, int place, double value) const {
  if (place >= kRadius && code_.spelling->address_of(place).empty()) return false;
  const bool comma = place >= kCommaC;
  const char letter = letter_of(place);
  const bool rounded = round(place, value);
  const NumberText text(value, *code_.spelling);
  const std::string address = code_.spelling->address_of(place);
  const bool named = !comma && calls(letter, value);
  if (named || !takes(letter, comma, value, text, rounded)) return bracketed(to, address, value);
  to += address;
  if (needs_equals(address)) to += '=';
  to += text.text();
  if (text.decimals() == 0 && points(letter, text) &&
      control_.reading.point_addresses.value.has(letter))
    to += '.';
  return true;
}

void WordWriter::value(std::string& to, int place, double value) const {
  round(place, value);
  to += expression_text(value, code_);
}

bool WordWriter::constant(std::string& to, int place, double value, bool whole) const {
  const char letter = letter_of(place);
  const NumberText text(value, *code_.spelling);
  const std::string address = code_.spelling->address_of(place);
  if (place < kCommaC && calls(letter, value)) return bracketed(to, address, value);
  to += address;
  if (needs_equals(address)) to += '=';
  to += text.text();
  const bool counts = increments_ && is_in(kLengths, letter);
  if (!whole && counts && text.decimals() == 0) to += '.';
  return true;
}

bool WordWriter::code(std::string& to, char letter, int tenfold) const {
  if (const std::string name = letter == 'G' ? code_name(tenfold) : "";
      !name.empty() && name[0] != 'G') {
    to += name;  // a code that is written as a word
    return true;
  }
  const Roles& roles = control_.calls.roles.value;
  const Role role = letter == 'M' ? roles.of_m(tenfold / 10) : roles.of_g(tenfold);
  const bool plain = role == Role::None || role == Role::Stop || role == Role::OptionalStop ||
                     role >= Role::SpindleForward;
  const double value = tenfold / 10.0;
  if (!plain || calls(letter, value)) return bracketed(to, std::string(1, letter), value);
  to += letter;
  to += NumberText(value, *code_.spelling).text();
  return true;
}

bool WordWriter::bracketed(std::string& to, std::string_view address, double value) const {
  if (code_.lacking.test(static_cast<std::size_t>(StatementKind::Brackets))) return false;
  const Spelling::Around& around = code_.spelling->value;
  to += address;
  to += around.before;
  to += expression_text(value, code_);
  to += around.behind;
  return true;
}

}  // namespace cncsub
