// The code of a block: its words in cells, its call with operands and arguments.
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "cncsub/block.hpp"

namespace cncsub {

namespace {

/// #i of an argument letter by specification I, 0 for the letters that are none.
int argument_variable(char letter) {
  static constexpr int kVariables[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kVariables[letter - 'A'];
}

}  // namespace

bool BlockReader::cut(const Operand& operand) const {
  return operand.fine && control_.cuts_fine_digits.value;
}

/// A length with more digits than the least increment has, which depends on the unit in force.
std::uint32_t BlockReader::cut_word(const Operand& operand, char address) {
  Expression expression;
  expression.first = static_cast<std::uint32_t>(code_.instructions.size());
  expression.at = operand.at;
  expression.width = operand.width;
  code_.instructions.push_back({Ins::Constant, 0, operand.at, operand.value});
  code_.instructions.push_back({Ins::CutWord, static_cast<std::uint8_t>(address), operand.at, 0});
  code_.instructions.push_back({Ins::End, 0, operand.at, 0});
  code_.expressions.push_back(expression);
  return static_cast<std::uint32_t>(code_.expressions.size() - 1);
}

/// The block's own words: G and M codes, and the values of its addresses; of an address given twice
/// the last.
void BlockReader::write_words(Block& block, const Tokens& tokens, const Meaning& meaning) {
  const bool call = meaning.call != nullptr;
  const bool macro = meaning.calls_macro();
  const bool sub = call && !macro;
  std::array<const Token*, kAddresses> values{};
  std::uint32_t mask = 0, expressions = 0, whole = 0;
  const std::size_t first_drop = code_.drops.size();
  const auto drop = [&](const Token& token) {
    code_.drops.push_back({0, token.operand.at, token.operand.width});
  };
  const auto owned = [&](const Token& token) {  // by the call or the return, not by the block
    if (token.late || token.letter == 'G' || token.letter == 'M' || token.letter == '<' ||
        token.letter == '/')
      return true;
    if (token.comma) return sub && token.letter == 'D' && control_.device_word.value;
    if (&token == meaning.call) return true;
    if ((meaning.back != nullptr || meaning.jump != nullptr) &&
        (token.letter == 'P' || token.letter == 'L'))
      return true;
    if (meaning.kind != CallKind::M98 && meaning.kind != CallKind::M198 &&
        meaning.kind != CallKind::M97)
      return false;
    if (!sub) return false;
    if (token.letter == 'P' || token.letter == 'L' || token.letter == 'Q') return true;
    return token.letter == 'H' && control_.start_word.value == StartWord::H;
  };
  const bool dwell =
      (control_.dwell_x_increments.value || control_.dwell_point.value != DwellPoint::Refused) &&
      std::any_of(meaning.g.begin(), meaning.g.begin() + meaning.g_count,
                  [](const Token* g) { return g->operand.value == 4; });
  for (const Token& token : tokens) {
    if (macro && token.operand.at >= meaning.call->operand.at) break;  // from here on: arguments
    if (owned(token)) continue;
    int place = token.letter - 'A';
    if (token.comma)
      place = token.letter == 'C'   ? kCommaC
              : token.letter == 'R' ? kCommaR
              : token.letter == 'A' ? kCommaA
                                    : kCommaD;
    const Token*& value = values[static_cast<std::size_t>(place)];
    if (value != nullptr) drop(*value);
    value = &token;
    const std::uint32_t mark = 1u << place;
    mask |= mark;
    const bool computed = token.operand.kind == Operand::Kind::Expression || cut(token.operand);
    expressions = computed ? expressions | mark : expressions & ~mark;
    const bool counts =
        dwell || (letters_[static_cast<unsigned char>(token.letter)] & kLength) != 0;
    whole = token.operand.whole && counts ? whole | mark : whole & ~mark;
    if (may_be_increment(token)) whole |= 1u << kPointedH;
  }
  block.data = static_cast<std::uint32_t>(code_.cells.size());
  block.mask = mask;
  block.flags = 0;
  if ((expressions | whole) != 0) {
    Cell cell{};
    cell.extra = {expressions, whole};
    code_.cells.push_back(cell);
    block.flags |= Block::kHasExtra;
  }
  const auto code_cell = [&](const Token& token, double factor) {
    Cell cell{};
    if (token.operand.kind == Operand::Kind::Expression) {
      block.flags |= Block::kCodeExpression;
      cell.value = -1.0 - token.operand.expression;
    } else {
      // A code below 0 would read as an expression, and one too large is refused when it runs.
      const double code = std::floor(token.operand.value * factor + 0.5);
      cell.value = code >= 0 && code <= kLargestCode ? code : kLargestCode + 1;
    }
    code_.cells.push_back(cell);
  };
  int g_count = 0;
  for (int i = 0; i < meaning.g_count; ++i) {
    const Token& token = *meaning.g[static_cast<std::size_t>(i)];
    if (macro && token.operand.at > meaning.call->operand.at) continue;
    code_cell(token, 10);
    ++g_count;
  }
  const int most = std::min(control_.m_codes_per_block.value, 6);
  const int first_m = std::max(0, meaning.m_count - most);
  for (int i = 0; i < first_m; ++i) drop(*meaning.m[static_cast<std::size_t>(i)]);
  if (code_.drops.size() > first_drop) block.flags |= Block::kDrops;
  for (std::size_t i = first_drop; i < code_.drops.size(); ++i) code_.drops[i].data = block.data;
  for (int i = first_m; i < meaning.m_count; ++i)
    code_cell(*meaning.m[static_cast<std::size_t>(i)], 1);
  block.g_count = static_cast<std::uint8_t>(g_count);
  block.m_count = static_cast<std::uint8_t>(meaning.m_count - first_m);
  for (std::uint32_t left = mask; left != 0; left &= left - 1) {
    const Operand& operand = values[static_cast<std::size_t>(__builtin_ctz(left))]->operand;
    Cell cell{};
    if (cut(operand))
      cell.expression = cut_word(operand, static_cast<char>('A' + std::countr_zero(left)));
    else if (operand.kind == Operand::Kind::Expression)
      cell.expression = operand.expression;
    else
      cell.value = operand.value;
    code_.cells.push_back(cell);
  }
  block.op = Op::Words;
  if (block.flags != 0 || block.m_count != 0 || block.g_count > 1) return;
  const double g = block.g_count == 0 ? -10 : code_.cells[block.data].value;
  if (g <= 30 && std::fmod(g, 10) == 0) mark_move(block, to_whole<int>(g / 10));
}

void BlockReader::build_call(Block& block, const Tokens& tokens, const Meaning& meaning) {
  const Token& word = *meaning.call;
  const bool macro = meaning.calls_macro();
  CallRecord call;
  call.kind = meaning.kind;
  call.code_kind = meaning.code_kind;
  call.macro = macro;
  call.at = word.operand.at;
  call.width = word.operand.width;
  if (meaning.registered != nullptr) {
    call.program_number = meaning.registered->program;
    call.variable = meaning.registered->variable;
    call.code = to_whole<std::int32_t>(word.operand.value);
  }
  const bool by_number = meaning.registered == nullptr;
  const Token* seen_p = nullptr;
  const Token* seen_l = nullptr;
  for (const Token& token : tokens) {
    if (&token == &word) continue;
    if (token.comma) {
      if (token.letter == 'D' && control_.device_word.value && by_number)
        call.device = token.operand;
      if (token.letter == 'D' && !control_.device_word.value)
        return refuse(block, {Cause::AddressNotUsable, token.operand.at, token.operand.width,
                              "the control has no ,D"});
      continue;
    }
    if (by_number && token.letter == '<') {
      call.name = std::string(token.name);
      call.name_at = token.operand.at;
      call.name_width = token.operand.width;
    }
    const bool first_p = seen_p == nullptr, first_l = seen_l == nullptr;
    if (token.letter == 'P' && by_number) {
      call.p = token.operand;
      seen_p = &token;
      if (macro && !first_p && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return refuse(block, {Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                              "P stands twice in the call"});
    }
    if (token.letter == 'L' && (by_number || macro)) {
      call.l = token.operand;
      seen_l = &token;
      if (macro && !first_l && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return refuse(block, {Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                              "L stands twice in the call"});
    }
    if (by_number && !macro) {
      if (token.letter == 'Q' && control_.start_word.value == StartWord::Q)
        call.start = token.operand;
      if (token.letter == 'H' && control_.start_word.value == StartWord::H)
        call.start = token.operand;
    }
  }
  if (control_.h_codes.value && meaning.kind == CallKind::G65) {
    // H makes it a statement, unless words stand there that only a macro call has.
    bool h = false, others = false;
    for (const Token& token : tokens) {
      h = h || token.letter == 'H';
      others = others || std::string_view("GHPQR").find(token.letter) == std::string_view::npos;
    }
    if (h && !others) return build_h_code(block, tokens, meaning);
    if (!call.p.present() && call.name.empty())
      return refuse(block, {Cause::HCodeMissing, call.at, call.width, "G65 has neither P nor H"});
  }
  if (macro || control_.call_passes_words.value) {
    if (auto fault = arguments(call, tokens, meaning)) return refuse(block, *fault);
  }
  write_words(block, tokens, meaning);
  if (macro && (block.mask != 0 || block.g_count != 0 || block.m_count != 0) &&
      control_.words_before_macro_call.value == WordsBeforeMacroCall::Alarm) {
    const Token& first = tokens.front();
    return refuse(block, {Cause::MacroCallNotFirst, first.operand.at, first.operand.width,
                          "a word stands before the macro call"});
  }
  switch (meaning.code_kind) {
    case CodeCallKind::Subprogram:
      block.op = Op::Call;
      break;
    case CodeCallKind::Macro:
      block.op = Op::MacroCall;
      break;
    case CodeCallKind::Modal:
    case CodeCallKind::ModalEveryBlock:
      block.op = Op::ModalCall;
      break;
  }
  block.aux = static_cast<std::uint32_t>(code_.calls.size());
  code_.calls.push_back(std::move(call));
}

/// The arguments of a macro call, as the locals they set, in the order written: the later one wins.
std::optional<Fault> BlockReader::arguments(CallRecord& call, const Tokens& tokens,
                                            const Meaning& meaning) {
  call.first_argument = static_cast<std::uint32_t>(code_.arguments.size());
  const auto add = [&](int variable, const Token& token) {
    code_.arguments.push_back({static_cast<std::int16_t>(variable), token.letter, token.operand});
  };
  if (!call.macro) {  // M98 that passes its words: A is #0 ... Z is #25
    for (const Token& token : tokens)
      if (&token != meaning.call && is_letter(token.letter) && !token.comma)
        add(token.letter - 'A', token);
    call.arguments = static_cast<std::uint32_t>(code_.arguments.size()) - call.first_argument;
    return std::nullopt;
  }
  std::uint32_t seen = 0;
  int set = 1;
  char last = 0;
  std::array<int, 3> of_letter{};
  bool behind = false;
  for (const Token& token : tokens) {
    if (&token == meaning.call) {
      behind = true;
      continue;
    }
    if (!behind || token.letter == 'P' || token.letter == 'L' || token.letter == '<') {
      if (token.letter == 'P' && meaning.registered != nullptr && behind)
        return Fault{Cause::IllegalArgument, token.operand.at, token.operand.width,
                     "P cannot be an argument"};
      continue;
    }
    if (token.late)
      return Fault{Cause::SequenceNumberNotFirst, token.operand.at, 1,
                   "N stands at the head of a macro call"};
    const std::size_t code = code_index(token.operand);
    const auto refused = [&](Cause cause) {
      return Fault{cause, token.operand.at, token.operand.width,
                   "this code may not stand with a macro call"};
    };
    if (token.letter == 'G' && meaning.kind == CallKind::G65 && not_with_macro_.test(code))
      return refused(Cause::CodeWithMacroCall);
    if (token.letter == 'G' && meaning.kind == CallKind::G66 && not_with_modal_.test(code))
      return refused(Cause::CodeWithModalCall);
    if (token.letter == 'M' && meaning.kind == CallKind::G65 && m_not_with_macro_.test(code))
      return refused(Cause::MCodeWithMacroCall);
    if (token.letter == 'G' || token.letter == 'O' || token.letter == 'N' || token.comma)
      return Fault{Cause::IllegalArgument, token.operand.at, token.operand.width,
                   std::string(token.comma ? "," : "") + token.letter + " cannot be an argument"};
    if (token.axis != 0) {
      static constexpr int kNumbered[2][3] = {{27, 28, 29}, {30, 31, 32}};
      add(kNumbered[token.axis - 1][token.letter - 'X'], token);
      continue;
    }
    if (token.letter < 'I' || token.letter > 'K') {
      const std::uint32_t mark = bit(token.letter);
      if ((seen & mark) != 0 && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return Fault{Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                     "the argument stands twice in the call"};
      seen |= mark;
      add(argument_variable(token.letter), token);
      continue;
    }
    const int place = token.letter - 'I';
    switch (control_.argument_sets.value) {
      case ArgumentSets::ByOrder:
        if (last != 0 && token.letter <= last) ++set;
        break;
      case ArgumentSets::PerLetter:
        set = ++of_letter[static_cast<std::size_t>(place)];
        break;
      case ArgumentSets::First:
        set = 1;
        break;
    }
    last = token.letter;
    if (set > 10)
      return Fault{Cause::TooManyArgumentSets, token.operand.at, token.operand.width,
                   "there are ten sets of I, J, K"};
    add(3 * set + 1 + place, token);
  }
  call.arguments = static_cast<std::uint32_t>(code_.arguments.size()) - call.first_argument;
  return std::nullopt;
}

void BlockReader::build_return(Block& block, const Tokens& tokens, const Meaning& meaning) {
  CallRecord back;
  back.at = meaning.back->operand.at;
  back.width = meaning.back->operand.width;
  for (const Token& token : tokens) {
    if (token.comma) continue;
    if (token.letter == 'P') back.p = token.operand;
    if (token.letter == 'L') back.l = token.operand;
  }
  if (back.p.present() && control_.return_with_p.value == ReturnWithP::Refused)
    return refuse(block, {Cause::IllegalWordWithReturn, back.p.at, back.p.width,
                          "M99 takes no P on this control"});
  write_words(block, tokens, meaning);
  block.op = Op::Return;
  block.aux = static_cast<std::uint32_t>(code_.calls.size());
  code_.calls.push_back(std::move(back));
}

void BlockReader::build_jump(Block& block, const Tokens& tokens, const Meaning& meaning) {
  Statement jump;
  jump.at = meaning.jump->operand.at;
  jump.width = meaning.jump->operand.width;
  for (const Token& token : tokens)
    if (token.letter == 'P' && !token.comma) jump.p = token.operand;
  if (!jump.p.present())
    return refuse(block, {Cause::ProgramNumberMissing, jump.at, jump.width,
                          "M97 does not say where to jump"});
  write_words(block, tokens, meaning);
  block.op = Op::Jump;
  block.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(jump);
}

void BlockReader::build_h_code(Block& block, const Tokens& tokens, const Meaning& meaning) {
  Statement h;
  h.at = meaning.call->operand.at;
  h.width = meaning.call->operand.width;
  for (const Token& token : tokens) {
    switch (token.letter) {
      case 'H':
        h.number = token.operand.kind == Operand::Kind::Constant && token.operand.value < 1000
                       ? to_whole<std::int32_t>(token.operand.value)
                       : -1;
        h.variable_at = token.operand.at;
        h.variable_width = token.operand.width;
        break;
      case 'P':
        h.p = token.operand;
        break;
      case 'Q':
        h.q = token.operand;
        break;
      case 'R':
        h.r = token.operand;
        break;
      case 'G':
        break;
      default:
        break;
    }
  }
  const std::string_view whole(code_.files.back().text);
  const std::size_t open = whole.find('(', h.at);
  const std::size_t line_end = std::min(whole.find('\n', h.at), whole.size());
  if (open < line_end) {
    h.text = static_cast<std::uint32_t>(open) + 1;
    h.text_length =
        static_cast<std::uint32_t>(std::min(whole.find(')', open), line_end) - open - 1);
  }
  block.op = Op::HCode;
  block.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(h);
}

}  // namespace cncsub
