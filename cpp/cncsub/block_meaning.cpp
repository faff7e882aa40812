// What the words of a block say together: a call, a return, an end, or words only.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "cncsub/block.hpp"
#include "cncsub/scan.hpp"

namespace cncsub {

namespace {

std::string spell(double value) {
  std::array<char, 32> text{};
  // Nought has no sign.
  const auto done = std::to_chars(text.data(), text.data() + text.size(), value + 0.0);
  return {text.data(), done.ptr};
}

}  // namespace

std::size_t BlockReader::code_index(const Operand& operand) {
  const bool known =
      operand.kind == Operand::Kind::Constant && operand.value >= 0 && operand.value < 1000;
  return known ? to_whole<std::size_t>(operand.value * 10 + 0.5) : std::size_t{10000};
}

void BlockReader::build(Block& block, const Tokens& tokens, bool calls) {
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (tokens[i].letter == '/') return build_slash(block, tokens, i, calls);
  Meaning meaning;
  auto fault = sort(tokens, calls, meaning);
  const auto most = static_cast<std::size_t>(std::max(0, control_.max_words.value));
  if (!fault && most > 0 && !meaning.calls_macro() && tokens.size() > most)
    fault = {Cause::TooManyWords, tokens[most].operand.at, tokens[most].operand.width,
             "a block has at most " + std::to_string(control_.max_words.value) + " words"};
  for (const Token& token : tokens) {
    if (fault) break;
    const bool start = may_be_increment(token) && meaning.call != nullptr && !meaning.calls_macro();
    if (start) fault = odd_word(token);
    if (token.letter != 'P' || !token.odd) continue;
    const bool name = token.wrong == Cause::TooManyDigits && names_by_p(meaning);
    if (!name && !is_length_here(token, meaning) && !is_dwell_time(token, meaning))
      fault = odd_word(token);
  }
  if (!fault) fault = check_together(tokens, meaning);
  if (fault) return refuse(block, *fault);
  if (meaning.registered != nullptr &&
      calls) {  // inside a program that a code called, codes may not call
    Variant variant;
    variant.address = meaning.call->letter;
    Block first = block;
    Block second = block;
    build_call(first, tokens, meaning);
    build(second, tokens, false);
    variant.first = static_cast<std::uint32_t>(code_.variants.size());
    code_.variants.push_back(first);
    variant.second = static_cast<std::uint32_t>(code_.variants.size());
    code_.variants.push_back(second);
    block.op = Op::Choose;
    block.aux = static_cast<std::uint32_t>(code_.choices.size());
    code_.choices.push_back(variant);
    return;
  }
  if (meaning.call != nullptr) return build_call(block, tokens, meaning);
  if (meaning.back != nullptr) return build_return(block, tokens, meaning);
  if (meaning.jump != nullptr) return build_jump(block, tokens, meaning);
  write_words(block, tokens, meaning);
  if (meaning.cancel != nullptr) block.op = Op::CancelModal;
  if (meaning.end != nullptr) block.op = Op::EndProgram;
}

/// A slash that is not at the head: the words behind it do not count while its switch is on.
void BlockReader::build_slash(Block& block, const Tokens& tokens, std::size_t slash, bool calls) {
  Tokens without(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(slash));
  Tokens with = without;
  with.insert(with.end(), tokens.begin() + static_cast<std::ptrdiff_t>(slash) + 1, tokens.end());
  Variant variant;
  variant.skip = tokens[slash].skip;
  Block first = block;
  Block second = block;
  build(first, with, calls);
  build(second, without, calls);
  variant.first = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(first);
  variant.second = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(second);
  block.op = Op::Choose;
  block.aux = static_cast<std::uint32_t>(code_.choices.size());
  code_.choices.push_back(variant);
}

/// P of a call, a return or a jump has digits of its own: those of a program or a block, and a
/// count.
bool BlockReader::names_by_p(const Meaning& meaning) {
  const bool by_code = meaning.registered != nullptr && !meaning.calls_macro();
  return (meaning.call != nullptr && !by_code) || meaning.back != nullptr ||
         meaning.jump != nullptr;
}

bool BlockReader::takes_point_in_dwell(const Token& token) const {
  return token.letter == 'P' && token.wrong == Cause::IllegalDecimalPoint &&
         control_.dwell_point.value != DwellPoint::Refused;
}

/// P of G04 takes a point on some controls.
bool BlockReader::is_dwell_time(const Token& token, const Meaning& meaning) const {
  return takes_point_in_dwell(token) &&
         std::any_of(meaning.g.begin(), meaning.g.begin() + meaning.g_count,
                     [](const Token* g) { return g->operand.value == 4; });
}

/// H may be an increment of C, which takes a point: the machine that runs the block decides.
bool BlockReader::may_be_increment(const Token& token) {
  return token.letter == 'H' && !token.comma && token.wrong == Cause::IllegalDecimalPoint;
}

/// P of G74 to G76 is a length on some lathes and takes a point there, and D of G37.1 the zone of a
/// Mitsubishi. [TA 12, 13, 21; M7 p.555]
bool BlockReader::is_length_here(const Token& token, const Meaning& meaning) const {
  if (token.wrong != Cause::IllegalDecimalPoint) return false;
  const bool step = token.letter == 'P' && control_.cycle_point.value;
  const bool zone = token.letter == 'D' && control_.measuring.value == Measuring::Words;
  if (!step && !zone) return false;
  return std::any_of(meaning.g.begin(), meaning.g.begin() + meaning.g_count, [&](const Token* g) {
    const double code = g->operand.value;
    return step ? code >= 74 && code <= 76 : code == 37.1;
  });
}

std::optional<Fault> BlockReader::sort(const Tokens& tokens, bool calls, Meaning& meaning) const {
  for (const Token& token : tokens) {
    std::optional<Fault> fault;
    const bool argument = meaning.calls_macro() && token.letter != 'P' && token.letter != 'L';
    const bool long_p = token.letter == 'P' && token.wrong == Cause::TooManyDigits;
    const bool late = long_p || takes_point_in_dwell(token) ||
                      may_be_increment(token);  // all words of the block decide
    if (token.odd && !argument && !late && !is_length_here(token, meaning)) return odd_word(token);
    if (argument && std::fabs(token.operand.value) >= kPowersOfTen[kMostDigits])
      return odd_word(token);
    if (token.late) continue;
    if (token.letter == 'G') {
      fault = sort_g(token, calls, meaning);
    } else if (token.letter == 'M') {
      // Behind G65 and its family every letter but G L N O P is an argument.
      if (meaning.calls_macro()) continue;
      fault = sort_m(token, calls, meaning);
    } else if (token.letter == 'O') {
      fault = Fault{Cause::AddressNotUsable, token.operand.at, token.operand.width,
                    "a program number stands at the head of a program only"};
    } else if (calls && !token.comma && token.letter != '<' && token.letter != 'P' &&
               token.letter != 'L' && !meaning.calls_macro() &&
               token.operand.kind == Operand::Kind::Constant) {
      if (const RegisteredCall* found = registered(token.letter, token.operand.value)) {
        if (meaning.call != nullptr) meaning.second_call = &token;
        meaning.call = &token;
        meaning.registered = found;
        meaning.code_kind = found->kind;
        meaning.kind = found->ascii          ? CallKind::Ascii
                       : token.letter == 'T' ? CallKind::TCode
                       : token.letter == 'S' ? CallKind::SCode
                       : token.letter == 'B' ? CallKind::BCode
                                             : CallKind::Ascii;
      }
    }
    if (fault) return fault;
  }
  return std::nullopt;
}

std::optional<Fault> BlockReader::sort_g(const Token& token, bool calls, Meaning& meaning) const {
  const Operand& operand = token.operand;
  const auto full = [&] {
    return Fault{Cause::TooManyWords, operand.at, operand.width, "too many G codes in one block"};
  };
  if (operand.kind == Operand::Kind::Expression) {
    if (static_cast<std::size_t>(meaning.g_count) == meaning.g.size()) return full();
    meaning.g[static_cast<std::size_t>(meaning.g_count++)] = &token;
    return std::nullopt;
  }
  const double code = operand.value;
  const auto code10 = static_cast<int>(code_index(operand));
  const auto call = [&](CallKind kind, CodeCallKind code_kind, const RegisteredCall* found) {
    if (meaning.call != nullptr) {
      if (!meaning.second_call) meaning.second_call = &token;
      return;
    }
    meaning.call = &token;
    meaning.kind = kind;
    meaning.code_kind = code_kind;
    meaning.registered = found;
  };
  if (calls && meaning.call == nullptr) {
    if (const RegisteredCall* found = registered('G', code)) {
      call(CallKind::GCode, found->kind, found);
      return std::nullopt;
    }
  }
  if (control_.macro_calls.value) {
    if (code10 == 650) return call(CallKind::G65, CodeCallKind::Macro, nullptr), std::nullopt;
    if (code10 == 660 && control_.modal_calls.value)
      return call(CallKind::G66, CodeCallKind::Modal, nullptr), std::nullopt;
    if (code10 == 661 && control_.modal_every_block.value)
      return call(CallKind::G661, CodeCallKind::ModalEveryBlock, nullptr), std::nullopt;
    if (code10 == 670 && control_.modal_calls.value) {
      meaning.cancel = &token;
      return std::nullopt;
    }
  }
  const bool known =
      code >= 0 && code < 1000 && code_.g_codes.test(static_cast<std::size_t>(code10));
  if (!known)
    return Fault{Cause::GCodeNotAvailable, operand.at, operand.width,
                 "G" + spell(code) + " is no code of this control"};
  if (meaning.calls_macro()) return std::nullopt;  // told as an argument
  if (static_cast<std::size_t>(meaning.g_count) == meaning.g.size()) return full();
  meaning.g[static_cast<std::size_t>(meaning.g_count++)] = &token;
  return std::nullopt;
}

std::optional<Fault> BlockReader::sort_m(const Token& token, bool calls, Meaning& meaning) const {
  const Operand& operand = token.operand;
  ++meaning.m_words;
  if (operand.kind == Operand::Kind::Constant) {
    const double code = operand.value;
    if (code == 0 || code == 1 || code == 2 || code == 30 || code == 98 || code == 99 ||
        code == external_m_)
      meaning.lonely = &token;
    const auto call = [&](CallKind kind, CodeCallKind code_kind, const RegisteredCall* found) {
      if (meaning.call != nullptr) {
        meaning.second_call = &token;
        return;
      }
      meaning.call = &token;
      meaning.kind = kind;
      meaning.code_kind = code_kind;
      meaning.registered = found;
    };
    if (calls) {
      if (const RegisteredCall* found = registered('M', code)) {
        if (found->refused)
          return Fault{Cause::CodeMayNotCall, operand.at, operand.width,
                       "M" + spell(code) + " may not call a program"};
        meaning.lonely = &token;
        call(CallKind::MCode, found->kind, found);
        return std::nullopt;
      }
    }
    if (code == 98) return call(CallKind::M98, CodeCallKind::Subprogram, nullptr), std::nullopt;
    if (control_.local_call_m_code.value > 0 && code == control_.local_call_m_code.value)
      return call(CallKind::M97, CodeCallKind::Subprogram, nullptr), std::nullopt;
    if (code == external_m_ && control_.external_calls.value)
      return call(CallKind::M198, CodeCallKind::Subprogram, nullptr), std::nullopt;
    if (code == 99) {
      meaning.back = &token;
      return std::nullopt;
    }
    if (code == 97 && control_.jump_m97.value) {
      meaning.jump = &token;
      return std::nullopt;
    }
    if (code == 2 || code == 30) {
      meaning.end = &token;
      return std::nullopt;
    }
  }
  if (static_cast<std::size_t>(meaning.m_count) == meaning.m.size())
    return Fault{Cause::TooManyWords, operand.at, operand.width, "too many M codes in one block"};
  meaning.m[static_cast<std::size_t>(meaning.m_count++)] = &token;
  return std::nullopt;
}

/// The chamfer or corner word that the control refuses beside M98. An L is one only beside an axis
/// word: else it is the count of the call.
const BlockReader::Token* BlockReader::corner_with_call(const Tokens& tokens,
                                                        const Meaning& meaning) const {
  if (corners_not_with_call_.empty() || meaning.call == nullptr || meaning.kind != CallKind::M98)
    return nullptr;
  const auto is_axis = [](const Token& token) {
    return !token.comma && std::string_view("XYZABC").find(token.letter) != std::string_view::npos;
  };
  const bool moves = std::any_of(tokens.begin(), tokens.end(), is_axis);
  for (const Token& token : tokens) {
    const std::string word = std::string(token.comma ? " ," : " ") + token.letter + ' ';
    if ((moves || token.letter != 'L') && corners_not_with_call_.find(word) != std::string::npos)
      return &token;
  }
  return nullptr;
}

std::optional<Fault> BlockReader::check_together(const Tokens& tokens,
                                                 const Meaning& meaning) const {
  const auto at = [](Cause cause, const Token& token, std::string detail) {
    return Fault{cause, token.operand.at, token.operand.width, std::move(detail)};
  };
  if (meaning.second_call != nullptr) {
    const bool macros = meaning.calls_macro() && meaning.second_call->letter == 'G';
    return at(macros ? Cause::MacroCallGivenTwice : Cause::CallGivenTwice, *meaning.second_call,
              "a block calls once");
  }
  if (meaning.call != nullptr && meaning.back != nullptr)
    return at(Cause::CallGivenTwice, *meaning.back, "a block calls or returns");
  if (control_.m_codes_alone.value && meaning.lonely != nullptr && meaning.m_words > 1)
    return at(Cause::IllegalMCombination, *meaning.lonely,
              "this M code shares no block with another M code");
  if (const int most = control_.m_codes_per_block.value;
      control_.m_codes_alarm.value && meaning.m_count > most && most >= 0)
    return at(Cause::IllegalMCombination, *meaning.m[static_cast<std::size_t>(most)],
              "the control takes " + std::to_string(most) + " M codes in one block");
  for (int i = 0; i < meaning.g_count; ++i) {
    const Token& token = *meaning.g[static_cast<std::size_t>(i)];
    if (token.operand.kind != Operand::Kind::Constant) continue;
    const std::size_t code10 = code_index(token.operand);
    if (meaning.call != nullptr && meaning.kind == CallKind::M98 && not_with_call_.test(code10))
      return at(Cause::IllegalWordWithCall, token, "this code may not stand with M98");
    if (meaning.back != nullptr && not_with_return_.test(code10))
      return at(Cause::IllegalWordWithReturn, token, "this code may not stand with M99");
  }
  if (const Token* corner = corner_with_call(tokens, meaning))
    return at(Cause::CornerWithCall, *corner, "a chamfer or corner round may not stand with M98");
  if (control_.repeated_address.value == RepeatedAddress::Alarm && !meaning.calls_macro()) {
    std::uint64_t seen = 0;
    for (const Token& token : tokens) {
      if (token.letter == 'G' || token.letter == 'M' || token.letter == '<') continue;
      const std::uint64_t mark = 1ULL << (token.letter - 'A' + (token.comma ? 32 : 0));
      if ((seen & mark) != 0)
        return at(Cause::AddressGivenTwice, token, "the address stands twice in the block");
      seen |= mark;
    }
  }
  return std::nullopt;
}

}  // namespace cncsub
