// The call, the return or the jump of a block.
#include <algorithm>
#include <string>
#include <string_view>

#include "cncsub/control/code_calls.hpp"
#include "cncsub/dialect/iso/block_writer.hpp"
#include "cncsub/dialect/iso/macro_arguments.hpp"

namespace cncsub {

namespace {

Op op_of(CodeCallKind kind) {
  switch (kind) {
    case CodeCallKind::Subprogram:
      return Op::Call;
    case CodeCallKind::Macro:
      return Op::MacroCall;
    case CodeCallKind::Modal:
    case CodeCallKind::ModalEveryBlock:
      return Op::ModalCall;
  }
  return Op::Call;
}

}  // namespace

void BlockWriter::call() {
  CallRecord call;
  call.kind = meaning_.kind;
  call.code_kind = meaning_.code_kind;
  call.macro = macro_;
  call.at = meaning_.call->operand.at;
  call.width = meaning_.call->operand.width;
  if (meaning_.registered != nullptr) program_by_code(call);
  for (const Token& token : tokens_)
    if (&token != meaning_.call)
      if (auto fault = operand(call, token)) return refuse(std::move(*fault));
  if (control_.macros.h_codes.value && meaning_.kind == CallKind::Macro) {
    if (is_h_code()) return h_code();
    if (!call.p.present() && call.name().empty())
      return refuse({Cause::HCodeMissing, call.at, call.width, "G65 has neither P nor H"});
  }
  if (auto fault = arguments(call)) return refuse(std::move(*fault));
  drop_unheard();
  words();
  if (macro_ && (block_.mask != 0 || block_.has_codes()) &&
      control_.macros.words_before_macro_call.value == WordsBeforeMacroCall::Alarm)
    return refuse(fault_of(tokens_.front(), Cause::MacroCallNotFirst,
                           "there is a word before the macro call"));
  to_.become(block_, op_of(meaning_.code_kind), std::move(call));
}

/// Let the call lead to the program of its code. All codes of a letter, T1 and T2, have one.
void BlockWriter::program_by_code(CallRecord& call) const {
  const Token& token = *meaning_.call;
  call.program_number = meaning_.registered->by_name ? -1 : meaning_.registered->program;
  call.variable = meaning_.registered->variable;
  call.code = to_whole<std::int32_t>(token.operand.value);
  if (!meaning_.registered->by_name) return;
  const std::string_view text = rules_.code.files.back().text.view();
  CallExtras& named = call.extras.make();
  named.name = name_of_called(token.letter, rules_.calling.whole_letter(token.letter)
                                                ? std::string_view()
                                                : text.substr(call.at, call.width));
  named.name_at = call.at;
  named.name_width = call.width;
}

/// Take a word that says which program is called, from where and how often. A code that calls names
/// the program itself.
std::optional<Fault> BlockWriter::operand(CallRecord& call, const Token& token) const {
  const bool says_program = meaning_.registered == nullptr;
  const bool says_start = says_program && !macro_;
  const StartWord start = control_.calls.start_word.value;
  if (token.comma) {
    if (token.letter != 'D') return std::nullopt;
    if (!control_.calls.device_word.value)
      return fault_of(token, Cause::AddressNotUsable, "the control has no ,D");
    if (says_program) call.extras.make().device = token.operand;
    return std::nullopt;
  }
  if (token.letter == '<' && says_program) {
    CallExtras& named = call.extras.make();
    named.name = std::string(token.name);
    named.name_at = token.operand.at;
    named.name_width = token.operand.width;
  }
  if (token.letter == 'P' && says_program) return given(call.p, token);
  if (token.letter == 'L' && (says_program || macro_)) return given(call.l, token);
  if (says_start && ((token.letter == 'Q' && start == StartWord::Q) ||
                     (token.letter == 'H' && start == StartWord::H)))
    call.extras.make().start = token.operand;
  return std::nullopt;
}

/// Return whether a word has no meaning here, although it has one in some call, return or jump.
bool BlockWriter::is_unheard(const Token& token) const {
  const CallRules& rules = control_.calls;
  if (token.comma) return false;
  if (meaning_.back != nullptr)
    return token.letter == 'L' && rules.return_with_l.value == ReturnWithL::Ignored;
  if (meaning_.jump != nullptr) return token.letter == 'L';
  if (!meaning_.calls_subprogram() || meaning_.registered != nullptr ||
      control_.macros.call_passes_words.value)
    return false;
  if (token.letter == 'Q') return rules.start_word.value != StartWord::Q;
  if (token.letter == 'H')  // beside a G code it belongs to that code
    return rules.start_word.value != StartWord::H && meaning_.g.size() == 0;
  const auto is_name = [](const Token& of) { return of.letter == '<'; };
  return token.letter == 'L' && rules.program_word.value == ProgramWord::CountAndNumber &&
         rules.count_and_l.value == CountAndL::NoL &&
         std::none_of(tokens_.begin(), tokens_.end(), is_name);
}

void BlockWriter::drop_unheard() {
  for (const Token& token : tokens_)
    if (is_unheard(token)) to_.drop(token.operand.at, token.operand.width);
}

/// Drop the P of an M code that calls or jumps on other controls and is only an M code here.
void BlockWriter::drop_plain_p() {
  const Roles& roles = control_.calls.roles.value;
  const auto elsewhere = [&](const Token* token) {
    return token->operand.kind == Operand::Kind::Constant &&
           calls_elsewhere(roles, to_whole<int>(token->operand.value));
  };
  if (meaning_.g.size() != 0 || std::none_of(meaning_.m.begin(), meaning_.m.end(), elsewhere))
    return;
  for (const Token& token : tokens_)
    if (token.letter == 'P' && !token.comma) to_.drop(token.operand.at, token.operand.width);
}

std::optional<Fault> BlockWriter::given(Operand& place, const Token& token) const {
  if (macro_ && place.present() &&
      control_.macros.repeated_argument.value == RepeatedAddress::Alarm)
    return fault_of(token, Cause::AddressGivenTwice,
                    std::string(1, token.letter) + " is in the call twice");
  place = token.operand;
  return std::nullopt;
}

std::optional<Fault> BlockWriter::arguments(CallRecord& call) {
  if (!macro_ && !control_.macros.call_passes_words.value) return std::nullopt;
  call.first_argument = to_.next_argument();
  const auto pass = [&](int variable, const Token& token) {
    to_.keep(Argument{static_cast<std::int16_t>(variable), token.letter, token.operand});
  };
  MacroArguments macro(rules_, meaning_);
  bool behind = false;
  for (const Token& token : tokens_) {
    if (&token == meaning_.call) {
      behind = true;
    } else if (!macro_) {  // M98 that passes its words: A is #0 ... Z is #25
      if (token.letter >= 'A' && !token.comma) pass(token.letter - 'A', token);
    } else if (behind) {
      int variable = -1;
      if (auto fault = macro.add(token, variable)) return fault;
      if (variable >= 0) pass(variable, token);
    }
  }
  call.arguments = to_.next_argument() - call.first_argument;
  return std::nullopt;
}

void BlockWriter::back() {
  CallRecord back;
  back.at = meaning_.back->operand.at;
  back.width = meaning_.back->operand.width;
  for (const Token& token : tokens_) {
    if (token.comma) continue;
    if (token.letter == 'P') back.p = token.operand;
    if (token.letter == 'L') back.l = token.operand;
    if (token.letter == 'Q' && control_.calls.return_to_line.value)
      back.extras.make().after = token.operand;
  }
  if (back.p.present() && control_.calls.return_with_p.value == ReturnWithP::Refused)
    return refuse({Cause::IllegalWordWithReturn, back.p.at, back.p.width,
                   "M99 cannot have P on this control"});
  drop_unheard();
  words();
  to_.become(block_, Op::Return, std::move(back));
}

/// Read the input that Q names: the jump is made while the input is 0.
std::optional<Fault> BlockWriter::input_of_jump(JumpRecord& jump) {
  Operand q;
  for (const Token& token : tokens_)
    if (token.letter == 'Q' && !token.comma) q = token.operand;
  if (!q.present())
    return Fault{Cause::StatementFormat, jump.at, jump.width, "Q must name the input, as in Q8"};
  if (q.kind == Operand::Kind::Expression)
    return Fault{Cause::CodeNotComputed, q.at, q.width,
                 "cncsub does not read an input whose number is computed"};
  const VariableRange* inputs = nullptr;
  for (const PlacedRange& placed : rules_.code.variables)
    if (placed.range.kind == VariableKind::Input && inputs == nullptr) inputs = &placed.range;
  if (inputs == nullptr || inputs->first + q.value > inputs->last)
    return Fault{Cause::IllegalVariable, q.at, q.width, "the control has no such input"};
  const Instruction input{Ins::Variable, 0, q.at, inputs->first + q.value};
  jump.reads_input = true;
  jump.input = to_.expressions().one(input, q.at, q.width);
  return std::nullopt;
}

void BlockWriter::jump() {
  JumpRecord jump;
  jump.at = meaning_.jump->operand.at;
  jump.width = meaning_.jump->operand.width;
  for (const Token& token : tokens_)
    if (token.letter == 'P' && !token.comma) jump.p = token.operand;
  if (!jump.p.present())
    return refuse({Cause::ProgramNumberMissing, jump.at, jump.width,
                   "the jump has no P to say where it goes"});
  if (meaning_.jump_reads_input)
    if (auto fault = input_of_jump(jump)) return refuse(std::move(*fault));
  drop_unheard();
  words();
  to_.become(block_, Op::Jump, jump);
}

/// Return whether H makes G65 a statement. It does not beside words that only a macro call has.
bool BlockWriter::is_h_code() const {
  const auto is_h = [](const Token& token) { return token.letter == 'H'; };
  const auto of_h_code = [](const Token& token) {
    return std::string_view("GHPQR").find(token.letter) != std::string_view::npos;
  };
  return std::any_of(tokens_.begin(), tokens_.end(), is_h) &&
         std::all_of(tokens_.begin(), tokens_.end(), of_h_code);
}

void BlockWriter::h_code() {
  HCode h;
  h.at = meaning_.call->operand.at;
  h.width = meaning_.call->operand.width;
  for (const Token& token : tokens_) {
    if (token.letter == 'P') h.p = token.operand;
    if (token.letter == 'Q') h.q = token.operand;
    if (token.letter == 'R') h.r = token.operand;
    if (token.letter != 'H') continue;
    const bool known = token.operand.kind == Operand::Kind::Constant && token.operand.value < 1000;
    h.number = known ? to_whole<std::int32_t>(token.operand.value) : -1;
    h.variable_at = token.operand.at;
    h.variable_width = token.operand.width;
  }
  const std::string_view text = rules_.code.files.back().text.view();
  const std::size_t open = text.find('(', h.at);
  const std::size_t line_end = std::min(text.find('\n', h.at), text.size());
  if (open < line_end) {
    h.text = static_cast<std::uint32_t>(open) + 1;
    h.text_length = static_cast<std::uint32_t>(std::min(text.find(')', open), line_end) - open - 1);
  }
  to_.become(block_, Op::HCode, h);
}

}  // namespace cncsub
