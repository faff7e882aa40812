// O-words, and M98 and M99.
#include <algorithm>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/linuxcnc/block.hpp"

namespace cncsub::linuxcnc {

namespace {

struct Word {
  std::string_view name;
  OWordKind kind;
};
constexpr Word kWords[] = {{"sub", OWordKind::Sub},
                           {"endsub", OWordKind::EndSub},
                           {"call", OWordKind::Call},
                           {"do", OWordKind::Do},
                           {"while", OWordKind::While},
                           {"repeat", OWordKind::Repeat},
                           {"if", OWordKind::If},
                           {"elseif", OWordKind::ElseIf},
                           {"else", OWordKind::Else},
                           {"endif", OWordKind::EndIf},
                           {"break", OWordKind::Break},
                           {"continue", OWordKind::Continue},
                           {"endwhile", OWordKind::EndWhile},
                           {"endrepeat", OWordKind::EndRepeat},
                           {"return", OWordKind::Return}};

/// Return the message for a label that was met with another statement, or for a subprogram of
/// another kind. [rs274 2.9]
const char* refusal(OWordKind kind) {
  using enum OWordKind;
  switch (kind) {
    case Sub:
      return "'O.... sub' subroutine must be called with 'O.... call'";
    case Head:
      return "Fanuc 'O....' subroutine must be called with 'M98'";
    case EndSub:
    case Return:
      return "Fanuc 'O....' subroutine definition must end with 'M99'";
    case If:
      return "{line}: duplicate O-word label - already defined in line {other}: '{block}'";
    case While:
    case Repeat:
      return "{line}: duplicate O-word label: '{block}' - defined in line {other}";
    case ElseIf:
    case Else:
      return "{line}: no matching 'if' label: '{block}' (found '{kind}' in line {other})";
    case EndIf:
      return "{line}: no matching label: '{name}' (found '{kind}' in line {other}): '{block}'";
    case EndWhile:
    case EndRepeat:
      return "{line}: no matching label: '{block}' (found '{kind}' in line {other})";
    case Break:
    case Continue:
      return "{line}: no matching while/do label: '{block}' (found '{kind}' in line {other})";
    case Call:
    case Call98:
      return "Failed to find sub 'O{name}' before EOF";
    case Back:
    case FileEnd:
    case Do:
      break;
  }
  return "";
}

/// Take the letter, and as many characters as the number has digits. [rs274 2.9: M098 leaves its 8]
void take_m(Line& line, int number) {
  for (std::size_t left = 1 + std::to_string(number).size(); left > 0; --left) line.take();
}

/// Keep the refusal of an endsub that the main program reaches after a call has returned, or of a
/// sub that was called before and that the program runs into. [rs274 2.9]
void keep_refusal(Builder& to, OWord& own, Cause cause, const char* text) {
  Fault fault{cause, own.at, own.width, ""};
  fault.text = text;
  own.refused = to.keep(std::move(fault));
}

}  // namespace

// ---- M98, M99 ----

/// Read the words after M98. Words other than P and L have no effect.
bool BlockReader::words_of_98(Block& block, CallRecord& call, Words& words) {
  while (!line_.at_end()) {
    const char letter = line_.peek();
    if (letter != 'p' && letter != 'l') {
      if (!item(block, words)) return false;
      continue;
    }
    line_.take();
    if (!words.line.add(letter))
      return refuse(block, Cause::AddressGivenTwice,
                    std::string("Multiple ") + letter + " words on one line", call.at);
    Value value;
    if (!expression_.whole(value)) return refuse(block);
    if (letter == 'l' && !value.computed && value.number < 0)
      return refuse(block, Cause::IllegalRepeatCount, "Negative l word used", value.at);
    (letter == 'p' ? call.p : call.l) = operand_of(value);
  }
  words.line.m.push_back(98);
  const auto wrong = below_zero(words.line);
  return !wrong || refuse(block, wrong->cause, wrong->text,
                          words.line.at[static_cast<std::size_t>(wrong->letter - 'a')]);
}

/// Read an M98 that stands first in its line, and the words after it.
bool BlockReader::call_98(Block& block, int m, Label& label) {
  const std::uint32_t at = line_.offset();
  take_m(line_, m);
  CallRecord call;
  call.kind = CallKind::Subprogram;
  call.locals = CallRecord::Locals::OwnByName;
  call.at = at;
  call.width = line_.width_from(at);
  Words words;
  if (!words_of_98(block, call, words)) return false;
  if (refuse_wrong(block, words.line)) return true;  // refused unless it is passed over
  if (!call.p.present())
    return refuse(block, Cause::ProgramNumberMissing,
                  "Found 'm" + std::to_string(m) + "' code with no P-word", at);
  OWord own;
  if (is_in_mode(words.line) && !words.line.computed) {
    own.beside = unused_letters(words.line);
    const std::string_view axes = words.line.has_g({431}) ? "" : "XYZABC";  // G43.1 takes lengths
    for (const char axis : axes) own.beside |= words.list.mask & bit(axis);
  }
  own.kind = OWordKind::Call98;
  own.label = OWord::kNone;
  if (call.p.kind == Operand::Kind::Constant)
    own.label = to_.names().label(std::to_string(
        to_whole<std::int64_t>(std::clamp(call.p.value, -2147483648.0, 2147483647.0))));
  own.at = at;
  own.width = call.width;
  own.of_another_kind = refusal(own.kind);
  using enum Operand::Kind;
  label.computed = call.p.kind == Expression || call.l.kind == Expression;
  own.call = to_.keep(std::move(call));
  to_.become(block, Op::OWord, own);
  label.kind = own.kind;
  return true;
}

void BlockReader::back_99(Block& block, int m, Label& label) {
  OWord own;
  own.kind = OWordKind::Back;
  own.at = line_.offset();
  take_m(line_, m);
  own.width = line_.width_from(own.at);
  own.of_another_kind =
      "'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition";
  while (line_.peek() == '(') {
    std::string text;
    line_.take_up_to(')', text);
  }
  if (!line_.at_end() && line_.peek() != ';') {
    Fault fault{Cause::StatementFormat, line_.offset(), 1,
                "M99 in a subprogram must be alone in its block"};
    fault.text = "Unexpected character after O-word";
    own.refused = to_.keep(std::move(fault));
  }
  CallRecord back;
  back.at = own.at;
  back.width = own.width;
  own.call = to_.keep(std::move(back));
  to_.become(block, Op::OWord, own);
  label.kind = own.kind;
}

// ---- O-words ----

bool BlockReader::o_label(Block& block, OWord& own) {
  const std::uint32_t at = line_.offset();
  line_.take();
  if (line_.take('<')) {
    std::string name;
    if (!line_.take_up_to('>', name))
      return refuse(block, Cause::IllegalProgramName, "Named parameter not terminated", at);
    own.label = to_.names().label(name);
    return true;
  }
  Value value;
  if (!expression_.whole(value)) return refuse(block);
  if (value.computed) {
    own.label = OWord::kNone;
    own.value = value.expression;
    return true;
  }
  own.label = to_.names().label(std::to_string(
      to_whole<std::int64_t>(std::clamp(value.number, -2147483648.0, 2147483647.0))));
  return true;
}

bool BlockReader::o_word(Block& block, Label& label) {
  OWord own;
  own.at = line_.offset();
  label.unreadable = !o_label(block, own);
  if (label.unreadable) return false;
  std::string_view name;
  for (const Word& word : kWords) {
    if (!line_.take(word.name)) continue;
    name = word.name;
    label.kind = word.kind;
    break;
  }
  const char c = line_.peek();
  if (!label.kind && (c == '(' || c == ';' || c == '\0')) label.kind = OWordKind::Head;
  if (!label.kind) {
    label.unknown = true;
    return refuse(block, Cause::StatementNotAvailable, "Unknown control command in o word", own.at);
  }
  own.kind = *label.kind;
  own.width = line_.width_from(own.at);
  label.label = own.label;
  if (own.label == OWord::kNone && own.kind != OWordKind::Call)
    return refuse(block, Cause::CodeNotComputed, "only the label of a call can be an expression",
                  own.at);
  return statement(block, own, name);
}

bool BlockReader::statement(Block& block, OWord& own, std::string_view word) {
  switch (own.kind) {
    case OWordKind::If:
    case OWordKind::ElseIf:
    case OWordKind::While:
    case OWordKind::Repeat:
      if (!condition(block, own, word)) return false;
      break;
    case OWordKind::EndSub:
    case OWordKind::Return:
      if (line_.peek() == '[' && !condition(block, own, "return")) return false;
      if (own.kind == OWordKind::EndSub)
        keep_refusal(to_, own, Cause::ReturnInMainProgram, "Not in subroutine definition");
      break;
    case OWordKind::Call:
      if (!o_call(block, own)) return false;
      break;
    case OWordKind::Sub:
      keep_refusal(to_, own, Cause::SubprogramGivenTwice,
                   "File:{file} line:{line} sub: o|{name}| found in illegal location");
      break;
    default:
      break;
  }
  if (!end_of_o_word(block)) return false;
  own.of_another_kind = refusal(own.kind);
  to_.become(block, Op::OWord, own);
  return true;
}

bool BlockReader::o_call(Block& block, OWord& own) {
  CallRecord call;
  call.kind = CallKind::OWord;
  call.locals = CallRecord::Locals::Own;
  call.at = own.at;
  call.width = own.width;
  if (own.label == OWord::kNone) {
    call.p.kind = Operand::Kind::Expression;
    call.p.expression = own.value;
    call.p.at = own.at;
    call.p.width = own.width;
    own.value = OWord::kNone;
  }
  if (!arguments(block, call)) return false;
  own.call = to_.keep(std::move(call));
  return true;
}

bool BlockReader::condition(Block& block, OWord& own, std::string_view word) {
  if (line_.peek() != '[')
    return refuse(block, Cause::StatementFormat,
                  "Left bracket missing after '" + std::string(word) + "'", own.at);
  Value value;
  if (!expression_.bracketed(value)) return refuse(block);
  own.value = to_.expressions().expression_of(value);
  return true;
}

bool BlockReader::arguments(Block& block, CallRecord& call) {
  constexpr std::uint32_t kMost = 30;
  std::vector<Argument> arguments;
  while (line_.peek() == '[' || line_.peek() == '(') {
    if (line_.peek() == '(') {
      std::string text;
      line_.take_up_to(')', text);
      continue;
    }
    if (arguments.size() == kMost)
      return refuse(block, Cause::TooManyArguments, "Too many subroutine parameters", call.at);
    Value value;
    if (!expression_.bracketed(value)) return refuse(block);
    arguments.push_back({static_cast<std::int16_t>(arguments.size() + 1), 0, operand_of(value)});
  }
  call.first_argument = to_.next_argument();
  call.arguments = static_cast<std::uint32_t>(arguments.size());
  for (const Argument& argument : arguments) to_.keep(argument);
  return true;
}

bool BlockReader::end_of_o_word(Block& block) {
  std::string text;
  while (line_.peek() == '(') line_.take_up_to(')', text);
  if (line_.at_end() || line_.peek() == ';') return true;
  return refuse(block, Cause::StatementFormat, "Unexpected character after O-word", line_.offset());
}

}  // namespace cncsub::linuxcnc
