#include "cncsub/dialect/iso/macro_arguments.hpp"

#include <string>

namespace cncsub {

namespace {

constexpr int kMostSets = 10;  // of I, J and K
constexpr int kVariableOfP = 16;

/// Return the variable number of an argument letter (specification I); 0 if the letter is none.
int argument_variable(char letter) {
  static constexpr int kVariables[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kVariables[letter - 'A'];
}

/// Return the variable of a numbered axis such as X1: #27 to #32.
int numbered_variable(const Token& token) { return 24 + 3 * token.axis + (token.letter - 'X'); }

}  // namespace

std::optional<Fault> MacroArguments::add(const Token& token, int& variable) {
  const char letter = token.letter;
  if (letter == 'P' && meaning_.registered != nullptr && rules_.variant.p_is_argument) {
    variable = kVariableOfP;
    return std::nullopt;
  }
  if (letter == 'P' && meaning_.registered != nullptr)
    return fault_of(token, Cause::IllegalArgument, "P cannot be an argument");
  if (letter == 'P' || letter == 'L' || letter == '<') return std::nullopt;
  if (token.trailing_n)
    return Fault{Cause::SequenceNumberNotFirst, token.operand.at, 1,
                 "N must be at the start of the block of a macro call"};
  if (auto fault = refused_code(token)) return fault;
  if (letter == 'G' || letter == 'O' || letter == 'N' || token.comma)
    return fault_of(token, Cause::IllegalArgument,
                    std::string(token.comma ? "," : "") + letter + " cannot be an argument");
  if (token.axis != 0) {
    variable = numbered_variable(token);
    return std::nullopt;
  }
  if (letter >= 'I' && letter <= 'K') {
    const int set = set_of(letter);
    if (set > kMostSets)
      return fault_of(token, Cause::TooManyArgumentSets, "more than ten sets of I, J, K");
    variable = 3 * set + 1 + (letter - 'I');
    return std::nullopt;
  }
  const std::uint32_t mark = bit(letter);
  if ((seen_ & mark) != 0 && control_.macros.repeated_argument.value == RepeatedAddress::Alarm)
    return fault_of(token, Cause::AddressGivenTwice, "the argument is in the call twice");
  seen_ |= mark;
  variable = argument_variable(letter);
  return std::nullopt;
}

/// Return the fault of a code that the control does not let stand with the call.
std::optional<Fault> MacroArguments::refused_code(const Token& token) const {
  if (token.letter != 'G' && token.letter != 'M') return std::nullopt;
  const auto code = static_cast<int>(code_index(token.operand));
  const MacroRules& rules = rules_.control.macros;
  const bool g = token.letter == 'G', once = meaning_.kind == CallKind::Macro;
  const auto refused = [&](Cause cause) {
    return fault_of(token, cause, "this code cannot share a block with a macro call");
  };
  if (g && once && rules.codes_not_with_macro_call.value.has(code))
    return refused(Cause::CodeWithMacroCall);
  if (g && meaning_.kind == CallKind::Modal && rules.codes_not_with_modal_call.value.has(code))
    return refused(Cause::CodeWithModalCall);
  if (!g && once && rules.m_codes_not_with_macro_call.value.has(code))
    return refused(Cause::MCodeWithMacroCall);
  return std::nullopt;
}

/// Return the set of an I, J or K, counted from 1.
int MacroArguments::set_of(char letter) {
  switch (control_.macros.argument_sets.value) {
    case ArgumentSets::ByOrder:
      if (last_ != 0 && letter <= last_) ++set_;
      break;
    case ArgumentSets::PerLetter:
      set_ = ++of_letter_[static_cast<std::size_t>(letter - 'I')];
      break;
    case ArgumentSets::First:
      set_ = 1;
      break;
  }
  last_ = letter;
  return set_;
}

}  // namespace cncsub
