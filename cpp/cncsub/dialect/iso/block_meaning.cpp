#include "cncsub/dialect/iso/block_meaning.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

std::string spell(double value) {
  return system::shortest(value + 0.0);  // zero has no sign
}

/// Return whether an M code of this role shares its block with no other, on controls that demand
/// it.
bool must_be_alone(Role role) {
  switch (role) {
    case Role::Stop:
    case Role::OptionalStop:
    case Role::End:
    case Role::Call:
    case Role::ExternalCall:
    case Role::Return:
      return true;
    default:
      return false;
  }
}

/// The call that a role makes; `letter` is that of the codes which call so.
struct CallOfRole {
  char letter;
  Role role;
  CallKind kind;
  CodeCallKind code_kind;
};
constexpr CallOfRole kCalls[] = {
    {'M', Role::Call, CallKind::Subprogram, CodeCallKind::Subprogram},
    {'M', Role::LocalCall, CallKind::Local, CodeCallKind::Subprogram},
    {'M', Role::ExternalCall, CallKind::External, CodeCallKind::Subprogram},
    {'G', Role::MacroCall, CallKind::Macro, CodeCallKind::Macro},
    {'G', Role::ModalCall, CallKind::Modal, CodeCallKind::Modal},
    {'G', Role::ModalCallEveryBlock, CallKind::ModalEveryBlock, CodeCallKind::ModalEveryBlock},
};

}  // namespace

std::optional<Fault> MeaningReader::read() {
  for (const Token& token : tokens_) {
    if (is_odd(token)) return bad_word(control_, token);
    if (token.trailing_n) continue;
    if (auto fault = sort(token)) return fault;
  }
  if (auto fault = check_count()) return fault;
  for (const Token& token : tokens_)
    if (token.bad_number && is_bad_in_block(token)) return bad_word(control_, token);
  return check_together();
}

// ---- the words ----

/// Sort a word by its meaning. After G65 and its family every letter but G L N O P is an argument.
std::optional<Fault> MeaningReader::sort(const Token& token) {
  if (token.letter == 'G') return sort_g(token);
  if (token.letter == 'O')
    return fault_of(token, Cause::AddressNotUsable,
                    "a program number is allowed only at the head of a program");
  if (meaning_.calls_macro()) return std::nullopt;
  if (token.letter == 'M') return sort_m(token);
  sort_letter(token);
  return std::nullopt;
}

std::optional<Fault> MeaningReader::sort_g(const Token& token) {
  const auto executed = [&]() -> std::optional<Fault> {
    if (meaning_.g.add(token)) return std::nullopt;
    return fault_of(token, Cause::TooManyWords, "too many G codes in one block");
  };
  if (token.operand.kind == Operand::Kind::Expression) return executed();
  const double code = token.operand.value;
  if (may_call_ && !meaning_.calls())
    if (const RegisteredCall* found = rules_.calling.find('G', code)) {
      if (found->refused)
        return fault_of(token, Cause::CodeMayNotCall, "G" + spell(code) + " cannot call a program");
      call(token, CallKind::GCode, found->kind, found);
      return std::nullopt;
    }
  const std::size_t code10 = code_index(token.operand);
  const Role role = control_.calls.roles.value.of_g(static_cast<int>(code10));
  if (call_by_role(token, role)) return std::nullopt;
  if (role == Role::CancelModal) {
    meaning_.cancel = &token;
    return std::nullopt;
  }
  if (code < 0 || code >= 1000 || !rules_.code.g_codes.test(code10))
    return fault_of(token, Cause::GCodeNotAvailable, "this control has no G" + spell(code));
  if (meaning_.calls_macro()) return std::nullopt;  // reported as an argument
  return executed();
}

std::optional<Fault> MeaningReader::sort_m(const Token& token) {
  ++meaning_.m_words;
  const bool written = token.operand.kind == Operand::Kind::Constant;
  const Role role = written ? role_of_m(token.operand) : Role::None;
  if (must_be_alone(role)) meaning_.alone_word = &token;
  const RegisteredCall* const found =
      written && may_call_ ? rules_.calling.find('M', token.operand.value) : nullptr;
  if (found != nullptr) {
    if (found->refused)
      return fault_of(token, Cause::CodeMayNotCall,
                      "M" + spell(token.operand.value) + " cannot call a program");
    meaning_.alone_word = &token;
    call(token, CallKind::MCode, found->kind, found);
    return std::nullopt;
  }
  if (call_by_role(token, role)) return std::nullopt;
  switch (role) {
    case Role::Return:
      meaning_.back = &token;
      return std::nullopt;
    case Role::Jump:
    case Role::JumpUnlessInput:
      meaning_.jump = &token;
      meaning_.jump_reads_input = role == Role::JumpUnlessInput;
      return std::nullopt;
    case Role::End:
      meaning_.end = &token;
      return std::nullopt;
    default:
      break;
  }
  if (meaning_.m.add(token)) return std::nullopt;
  return fault_of(token, Cause::TooManyWords, "too many M codes in one block");
}

/// Sort a letter whose codes may call: T, S, B, or one of a parameter.
void MeaningReader::sort_letter(const Token& token) {
  if (!may_call_ || token.comma || !is_letter(token.letter) || token.letter == 'P' ||
      token.letter == 'L' || token.operand.kind != Operand::Kind::Constant)
    return;
  const RegisteredCall* const found = rules_.calling.find(token.letter, token.operand.value);
  if (found == nullptr) return;
  if (meaning_.calls()) meaning_.second_call = &token;
  meaning_.call = &token;
  meaning_.registered = found;
  meaning_.code_kind = found->kind;
  meaning_.kind = found->ascii          ? CallKind::Ascii
                  : token.letter == 'T' ? CallKind::TCode
                  : token.letter == 'S' ? CallKind::SCode
                  : token.letter == 'B' ? CallKind::BCode
                                        : CallKind::Ascii;
}

bool MeaningReader::call_by_role(const Token& token, Role role) {
  if (role == Role::None) return false;
  for (const CallOfRole& entry : kCalls)
    if (entry.role == role && entry.letter == token.letter) {
      const bool after = rules_.variant.after_blocks && entry.kind == CallKind::ModalEveryBlock;
      call(token, entry.kind, after ? CodeCallKind::Modal : entry.code_kind, nullptr);
      return true;
    }
  return false;
}

void MeaningReader::call(const Token& token, CallKind kind, CodeCallKind code_kind,
                         const RegisteredCall* registered) {
  if (meaning_.calls()) {  // of more than two, the first G code or the last M code is reported
    if (meaning_.second_call == nullptr || token.letter == 'M') meaning_.second_call = &token;
    return;
  }
  meaning_.call = &token;
  meaning_.kind = kind;
  meaning_.code_kind = code_kind;
  meaning_.registered = registered;
}

Role MeaningReader::role_of_m(const Operand& operand) const {
  const double code = operand.value;
  return code == std::floor(code) ? control_.calls.roles.value.of_m(to_whole<int>(code))
                                  : Role::None;
}

// ---- signs, points and digits ----

/// Return whether the sign, point or digits are not allowed, as far as the words up to this one
/// tell.
bool MeaningReader::is_odd(const Token& token) const {
  if (meaning_.calls_macro() && token.letter != 'P' && token.letter != 'L')  // an argument
    return std::fabs(token.operand.value) >= kPowersOfTen[kMostDigits];
  if (!token.bad_number) return false;
  const bool long_p = token.letter == 'P' && token.wrong == Cause::TooManyDigits;
  const bool all_decide = long_p || may_take_point(token) || may_be_increment(token);
  return !all_decide && !is_length_here(token);
}

/// Return the same for P and H, for which all words of the block decide.
bool MeaningReader::is_bad_in_block(const Token& token) const {
  if (may_be_increment(token)) return meaning_.calls_subprogram();
  if (token.letter != 'P') return false;
  const bool name = token.wrong == Cause::TooManyDigits && names_by_p();
  return !name && !takes_point_here(token) && !is_length_here(token);
}

/// Return whether P names a program or a block, as in a call, a return or a jump. Such a P has
/// digits of its own: those of the number and of a count.
bool MeaningReader::names_by_p() const {
  const bool by_code = meaning_.registered != nullptr && !meaning_.calls_macro();
  return (meaning_.calls() && !by_code) || meaning_.back != nullptr || meaning_.jump != nullptr;
}

/// Return whether P may take a point: P of a dwell and P of G51 take one on some controls.
bool MeaningReader::may_take_point(const Token& token) const {
  return token.letter == 'P' && token.wrong == Cause::IllegalDecimalPoint &&
         (control_.motion.dwell_point.value != DwellPoint::Refused ||
          control_.motion.scale_unit.value == ScaleUnit::AsWritten);
}

bool MeaningReader::takes_point_here(const Token& token) const {
  if (!may_take_point(token) || names_by_p()) return false;
  const DwellPoint dwell = control_.motion.dwell_point.value;
  return (dwell != DwellPoint::Refused && meaning_.has_g(4, 4)) ||
         (dwell == DwellPoint::CyclesToo && may_drill()) ||
         (control_.motion.scale_unit.value == ScaleUnit::AsWritten && meaning_.has_g(51, 51));
}

/// Return whether the block begins a drilling cycle, or has no code that keeps it from drilling the
/// next hole of one.
bool MeaningReader::may_drill() const {
  const auto goes_with_cycle = [](const Token* token) {
    const double code = token->operand.value;
    return (code >= 73 && code <= 91) || code == 98 || code == 99;
  };
  return std::all_of(meaning_.g.begin(), meaning_.g.end(), goes_with_cycle);
}

/// Return whether the word is a length, which takes a point: P of G74 to G76 on some lathes, and D
/// of G37.1, the zone of a Mitsubishi. [TA 12, 13, 21; M7 p.555]
bool MeaningReader::is_length_here(const Token& token) const {
  if (token.wrong != Cause::IllegalDecimalPoint) return false;
  const bool step = token.letter == 'P' && control_.turning.cycle_point.value;
  const bool zone = token.letter == 'D' && control_.motion.measuring.value == Measuring::Words;
  return (step && meaning_.has_g(74, 76)) || (zone && meaning_.has_g(37.1, 37.1));
}

// ---- words that do not go together ----

std::optional<Fault> MeaningReader::check_count() const {
  const int most = control_.reading.max_words.value;
  const auto limit = static_cast<std::size_t>(std::max(0, most));
  if (limit == 0 || tokens_.size() <= limit || meaning_.calls_macro()) return std::nullopt;
  return fault_of(tokens_[limit], Cause::TooManyWords,
                  "a block has at most " + std::to_string(most) + " words");
}

std::optional<Fault> MeaningReader::check_together() const {
  if (auto fault = check_calls()) return fault;
  if (auto fault = check_m_codes()) return fault;
  if (auto fault = check_g_codes()) return fault;
  if (auto fault = check_corner()) return fault;
  if (auto fault = check_call_words()) return fault;
  return check_repeated();
}

std::optional<Fault> MeaningReader::check_calls() const {
  if (meaning_.second_call != nullptr) {
    const bool macros = meaning_.calls_macro() && meaning_.second_call->letter == 'G';
    return fault_of(*meaning_.second_call,
                    macros ? Cause::MacroCallGivenTwice : Cause::CallGivenTwice,
                    "a block can have only one call");
  }
  if (meaning_.calls() && meaning_.back != nullptr)
    return fault_of(*meaning_.back, Cause::CallGivenTwice,
                    "a block can have a call or a return, not both");
  return std::nullopt;
}

std::optional<Fault> MeaningReader::check_m_codes() const {
  const ExtraMCodes extra = control_.reading.extra_m_codes.value;
  const int most = control_.reading.m_codes_per_block.value;
  if (extra == ExtraMCodes::EndsAlone && meaning_.alone_word != nullptr && meaning_.m_words > 1)
    return fault_of(*meaning_.alone_word, Cause::IllegalMCombination,
                    "this M code cannot share a block with another M code");
  if (extra == ExtraMCodes::Alarm && most >= 0 &&
      meaning_.m.size() > static_cast<std::size_t>(most))
    return fault_of(meaning_.m[static_cast<std::size_t>(most)], Cause::IllegalMCombination,
                    "too many M codes in one block: the control allows " + std::to_string(most));
  return std::nullopt;
}

std::optional<Fault> MeaningReader::check_g_codes() const {
  const CallRules& rules = rules_.control.calls;
  const bool call = meaning_.calls() && meaning_.kind == CallKind::Subprogram;
  const bool back = meaning_.back != nullptr;
  if (!call && !back) return std::nullopt;
  for (const Token* token : meaning_.g) {
    if (token->operand.kind != Operand::Kind::Constant) continue;
    const auto code10 = static_cast<int>(code_index(token->operand));
    if (call && rules.codes_not_with_call.value.has(code10))
      return fault_of(*token, Cause::IllegalWordWithCall,
                      "this code cannot share a block with M98");
    if (back && rules.codes_not_with_return.value.has(code10))
      return fault_of(*token, Cause::IllegalWordWithReturn,
                      "this code cannot share a block with M99");
  }
  return std::nullopt;
}

/// Return the fault of a chamfer or corner word that the control refuses beside M98. L is such a
/// word only beside an axis word: otherwise it is the count of the call.
std::optional<Fault> MeaningReader::check_corner() const {
  const CornerLetters& refused = rules_.corners_not_with_call;
  if (refused.empty() || !meaning_.calls() || meaning_.kind != CallKind::Subprogram)
    return std::nullopt;
  const auto is_axis = [](const Token& token) {
    return !token.comma && std::string_view("XYZABC").find(token.letter) != std::string_view::npos;
  };
  const bool moves = std::any_of(tokens_.begin(), tokens_.end(), is_axis);
  for (const Token& token : tokens_) {
    if ((moves || token.letter != 'L') && refused.has({token.comma, token.letter}))
      return fault_of(token, Cause::CornerWithCall,
                      "a chamfer or corner round cannot share a block with M98");
  }
  return std::nullopt;
}

/// Return the fault of a word beside M98 by which it is something that is not computed.
std::optional<Fault> MeaningReader::check_call_words() const {
  const Letters& words = control_.calls.call_words_not_computed.value;
  if (!meaning_.calls() || meaning_.kind != CallKind::Subprogram) return std::nullopt;
  for (const Token& token : tokens_)
    if (!token.comma && words.has(token.letter))
      return fault_of(token, Cause::CodeNotComputed,
                      std::string("M98 with ") + token.letter + " is not computed");
  return std::nullopt;
}

std::optional<Fault> MeaningReader::check_repeated() const {
  if (control_.reading.repeated_address.value != RepeatedAddress::Alarm || meaning_.calls_macro())
    return std::nullopt;
  std::uint64_t seen = 0;
  for (const Token& token : tokens_) {
    if (token.letter == 'G' || token.letter == 'M' || token.letter == '<') continue;
    const std::uint64_t mark = 1ULL << (token.letter - 'A' + (token.comma ? 32 : 0));
    if ((seen & mark) != 0)
      return fault_of(token, Cause::AddressGivenTwice, "the address is in the block twice");
    seen |= mark;
  }
  return std::nullopt;
}

}  // namespace cncsub
