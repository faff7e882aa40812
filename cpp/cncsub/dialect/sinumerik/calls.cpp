// Calls of programs: by name, by a text, by a path; parts of programs; alarms that a program
// raises.
#include <algorithm>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/sinumerik/iso_mode.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

CallRecord call_of(const OpenBlock& open, std::string_view name, std::uint32_t at) {
  CallRecord call;
  call.kind = CallKind::Named;
  call.at = at;
  call.width = open.line.width_from(at);
  CallExtras& named = call.extras.make();
  named.name_at = at;
  named.name_width = call.width;
  named.name = std::string(open.to.code().spelling->bare_name(name));
  named.count = 'P';
  return call;
}

namespace {

// The numbers of alarms that a user's program may raise. [general knowledge]
constexpr std::int32_t kFirstUserAlarm = 60000, kLastUserAlarm = 69999;

/// Read P3 or P=R1, where it stands here.
bool pass_count(OpenBlock& open, Block& block, Operand& count) {
  if (open.line.peek() != 'P') return true;
  const std::uint32_t at = open.line.offset();
  open.line.pass(1);
  Value value;
  if (open.line.take('=') ? !open.expression.value(value) : !open.expression.number(value))
    return open.refuse(block);
  value.at = at;
  value.width = open.line.width_from(at);
  count = operand_of(value);
  return true;
}

/// Read one value of a call, which may be a variable or an array.
bool given_value(OpenBlock& open, ActualParameter& one) {
  const Line before = open.line;
  Type type = Type::Real;
  Value value;
  value.at = one.operand.at;
  if (!open.expression.variable_alone(one.variable, type, one.extents) || one.extents.empty()) {
    open.line = before;
    if (!open.expression.value_of_any(value, type)) return false;
  }
  value.width = open.line.width_from(value.at);
  one.type = shown_type(type);
  one.operand = operand_of(value);
  return true;
}

/// Read the values of a call up to the closing bracket. A value may be left out between its commas.
bool given_values(OpenBlock& open, Block& block, std::vector<ActualParameter>& given) {
  while (!open.line.take(')')) {
    ActualParameter& one = given.emplace_back();
    one.operand.at = open.line.offset();
    if (open.line.peek() != ',' && !given_value(open, one)) return open.refuse(block);
    if (open.line.peek() != ')' && !open.line.take(','))
      return open.refuse(block, Cause::BracketNotClosed, ") is missing", open.line.offset());
  }
  return true;
}

/// Refuse a call of a program in another mode than the others call it in: it is read in one.
bool called_in_one_mode(OpenBlock& open, Block& block, std::string_view name, std::uint32_t at) {
  return !is_called_in_iso_mode(open.called_in_iso_mode, name) ||
         open.not_computed(block,
                           std::string(name) +
                               " in the control's own language: other calls are of it in ISO mode",
                           at);
}

/// Write the call of a program by its path, of which the last name counts.
bool named_call(OpenBlock& open, Block& block, std::string_view path, std::uint32_t at,
                std::vector<ActualParameter> given) {
  const std::string_view last = last_of_path(path, kPathSigns), name = trimmed(last);
  if (name.empty())
    return open.refuse(block, Cause::IllegalProgramName, "the name of the program is missing", at);
  CallRecord call = call_of(open, name, at);
  if (!called_in_one_mode(open, block, call.name(), at)) return false;
  call.extras.make().path = path.substr(0, path.size() - last.size());
  call.extras.make().given = std::move(given);
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, Op::Call, std::move(call));
  return true;
}

/// Write the call of the program that a text names.
bool call_named_by(OpenBlock& open, Block& block, const Value& path, std::uint32_t at) {
  if (!path.computed)
    return named_call(open, block, open.to.code().texts.at(to_whole<std::size_t>(path.number)), at,
                      std::vector<ActualParameter>());
  CallRecord call = call_of(open, "", at);
  call.extras.make().name_text = operand_of(path);
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, Op::Call, std::move(call));
  return true;
}

/// Write a block that executes a part of the program as a call.
bool part(OpenBlock& open, Block& block, Link& link, CallKind kind, std::uint32_t at,
          const Operand& count) {
  if (!open.end_of_statement(block)) return false;
  CallRecord call;
  call.kind = kind;
  call.at = at;
  call.width = open.line.width_from(at);
  call.l = count;
  call.target.program = static_cast<std::int32_t>(open.to.code().programs.size()) - 1;
  CallExtras& named = call.extras.make();
  named.name = link.target.label.empty() ? "N" : link.target.label;
  named.name_at = link.target.at;
  named.name_width = link.target.width;
  if (link.last.at != 0) {
    named.last_at = link.last.at;
    named.last_width = link.last.width;
  }
  named.count = 'P';
  link.kind = Link::Kind::Part;
  open.to.become(block, Op::RepeatPart, std::move(call));
  return true;
}

/// Return the text that names a block of a part, which may be computed.
Operand text_of_target(OpenBlock& open, const JumpTarget& target) {
  Operand text;
  text.kind = target.computed ? Operand::Kind::Expression : Operand::Kind::Constant;
  text.expression = target.text;
  text.at = target.at;
  text.width = target.width;
  if (target.computed) return text;
  const std::string named =
      target.label.empty() ? "N" + std::to_string(target.number) : target.label;
  text.value = static_cast<double>(open.to.names().constant_text(named));
  return text;
}

/// Write the call of a part whose blocks are found when it is made: it is one of another program,
/// or texts name its blocks.
bool searched_part(OpenBlock& open, Block& block, const Link& link, CallRecord call,
                   std::uint32_t at) {
  if (!open.end_of_statement(block)) return false;
  call.kind = CallKind::CallBlock;
  call.at = at;
  call.width = open.line.width_from(at);
  CallExtras& part = call.extras.make();
  part.first_text = text_of_target(open, link.target);
  part.last_text = text_of_target(open, link.last);
  open.to.become(block, Op::RepeatPart, std::move(call));
  return true;
}

/// Read BLOCK FIRST TO LAST.
bool part_of_program(OpenBlock& open, Block& block, Link& link) {
  open.line.pass(open.line.name().size());
  link.part_end = Link::PartEnd::Called;
  if (!jump_target(open, block, "CALL", link.target)) return false;
  const std::uint32_t to = open.line.offset();
  if (capitals(open.line.name()) != "TO")
    return open.refuse(block, Cause::StatementFormat, "TO is missing: CALL BLOCK FIRST TO LAST",
                       to);
  open.line.pass(2);
  return jump_target(open, block, "CALL", link.last);
}

/// Read CALL BLOCK FIRST TO LAST.
bool call_block(OpenBlock& open, Block& block, Link& link, std::uint32_t at) {
  if (!part_of_program(open, block, link)) return false;
  if (!link.target.computed && !link.last.computed)
    return part(open, block, link, CallKind::CallBlock, at, Operand());
  CallRecord call;
  call.target.program = static_cast<std::int32_t>(open.to.code().programs.size()) - 1;
  call.extras.make().name = "BLOCK";  // the running program
  return searched_part(open, block, link, std::move(call), at);
}

/// Read the text that names a program: a number is none, and CALL 5 calls nothing.
bool program_text(OpenBlock& open, Block& block, Value& path) {
  const std::uint32_t at = open.line.offset();
  Type type = Type::Real;
  if (!open.expression.value_of_any(path, type)) return open.refuse(block);
  path.at = at;
  path.width = open.line.width_from(at);
  return type == Type::String ||
         open.refuse(block, Cause::TypeMismatch, "a program is named by a text: CALL \"PART\"", at);
}

/// Read CALL "/_N_SPF_DIR/_N_SUB_SPF", or a part of that program: CALL "L10" BLOCK FIRST TO LAST.
bool call_by_text(OpenBlock& open, Block& block, Link& link, std::uint32_t at) {
  Value path;
  if (!program_text(open, block, path)) return false;
  link.kind = Link::Kind::None;
  if (capitals(open.line.name()) != "BLOCK") return call_named_by(open, block, path, at);
  if (!part_of_program(open, block, link)) return false;
  CallRecord call;
  call.locals = CallRecord::Locals::Own;
  CallExtras& named = call.extras.make();
  named.name_at = path.at;
  named.name_width = path.width;
  if (path.computed) {
    named.name_text = operand_of(path);
  } else {
    const std::string& written = open.to.code().texts.at(to_whole<std::size_t>(path.number));
    const std::string_view name = last_of_path(written, kPathSigns);
    named.path = written.substr(0, written.size() - name.size());
    named.name = open.to.code().spelling->bare_name(trimmed(name));
    if (named.name.empty())
      return open.refuse(block, Cause::IllegalProgramName, "the name of the program is missing",
                         path.at);
  }
  return searched_part(open, block, link, std::move(call), at);
}

/// Read PCALL /_N_WKS_DIR/_N_SHAFT_WPD/SUB(1, R2).
bool call_by_path(OpenBlock& open, Block& block, std::uint32_t at) {
  open.line.offset();  // past blanks
  const std::string_view rest = open.line.rest();
  const std::size_t end = std::min(rest.find_first_of("( \t\r"), rest.size());
  const std::string_view path = rest.substr(0, end);
  open.line.pass(end);
  std::vector<ActualParameter> given;
  if (open.line.take('(') && !given_values(open, block, given)) return false;
  return named_call(open, block, path, at, std::move(given));
}

/// Read EXTCALL("SUB.SPF"), with its brackets or without.
bool external_call(OpenBlock& open, Block& block, std::uint32_t at) {
  const bool bracket = open.line.take('(');
  Value path;
  if (!program_text(open, block, path)) return false;
  if (bracket && !open.line.take(')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", open.line.offset());
  return call_named_by(open, block, path, at);
}

/// Read ISOCALL "0122", the call of a program in ISO mode. If machine data switch no ISO mode on,
/// it is a call like any other. [general knowledge]
bool call_in_iso_mode(OpenBlock& open, Block& block, std::uint32_t at) {
  Value path;
  if (!program_text(open, block, path)) return false;
  if (!has_iso_mode(open.to.control())) return call_named_by(open, block, path, at);
  if (path.computed)
    return open.not_computed(block,
                             "the computed name of a program in ISO mode: write the name itself, "
                             "ISOCALL \"0122\"",
                             path.at);
  const std::string& written = open.to.code().texts.at(to_whole<std::size_t>(path.number));
  const std::string name(open.to.code().spelling->bare_name(last_of_path(written, kPathSigns)));
  if (name.empty())
    return open.refuse(block, Cause::IllegalProgramName, "the name of the program is missing", at);
  if (open.to.code().find(name) != kNoProgram &&
      !is_called_in_iso_mode(open.called_in_iso_mode, name))
    return open.not_computed(
        block, "ISOCALL in MDI of a program that no program of the memory calls so", at);
  CallRecord call = iso_call(open, name, at);
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, Op::Call, std::move(call));
  return true;
}

/// Read CALLPATH("/_N_WKS_DIR/_N_PARTS_WPD"), which adds a folder to those that calls search, or
/// CALLPATH(), which takes it away. [SONE p.559, step 5]
bool call_path(OpenBlock& open, Block& block, std::uint32_t at) {
  if (!open.line.take('(')) return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  Value path;
  Type type = Type::String;
  const std::uint32_t text = open.line.offset();
  if (open.line.peek() != ')' && !open.expression.value_of_any(path, type))
    return open.refuse(block);
  if (type != Type::String)
    return open.refuse(block, Cause::TypeMismatch,
                       "a folder is named by a text: CALLPATH(\"/_N_CUS_DIR\")", text);
  if (!open.line.take(')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", open.line.offset());
  if (!open.end_of_statement(block)) return false;
  Statement statement;
  statement.at = statement.variable_at = at;
  statement.width = statement.variable_width = open.line.width_from(at);
  statement.target = Statement::Target::Common;
  statement.index = open.to.code().call_path;
  statement.expression = open.to.expressions().expression_of(path);
  open.to.become(block, Op::Assign, statement);
  return true;
}

/// Read SETAL(65000), or SETAL(65000, "TEXT").
bool user_alarm(OpenBlock& open, Block& block, std::uint32_t at) {
  if (!open.line.take('(')) return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  Value number;
  if (!open.expression.value(number)) return open.refuse(block);
  Print alarm;
  alarm.alarms = true;
  alarm.at = at;
  alarm.number = open.to.expressions().expression_of(number);
  alarm.first_number = kFirstUserAlarm;
  alarm.last_number = kLastUserAlarm;
  PrintField text;
  if (open.line.take(',') && !text_field(open, block, text)) return false;
  alarm.fields.push_back(std::move(text));
  for (const RaisedAlarm& of : open.to.control().raised_alarms) {  // by the control's own programs
    if (number.computed || number.number != of.number) continue;
    alarm.first_number = alarm.last_number = of.number;
    if (alarm.fields[0].text.empty() && !alarm.fields[0].is_text) alarm.fields[0].text = of.text;
  }
  if (!open.line.take(')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", open.line.offset());
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, Op::Print, std::move(alarm));
  return true;
}

/// Read a value that may be left out between its commas.
bool return_value(OpenBlock& open, Block& block, Operand& operand) {
  if (open.line.peek() == ',' || open.line.peek() == ')') return true;
  Value value;
  if (!open.expression.value(value)) return open.refuse(block);
  operand = operand_of(value);
  return true;
}

}  // namespace

/// Read L100, SUB or SUB(), and a P with the count.
bool call(OpenBlock& open, Block& block, Words& words, std::string_view name) {
  const std::uint32_t at = open.line.offset();
  open.line.pass(name.size());
  CallRecord call = call_of(open, name, at);
  if (words.call) return open.refuse(block, Cause::CallGivenTwice, "a second call", at);
  if (!called_in_one_mode(open, block, call.name(), at)) return false;
  if (name.size() == 1)
    return open.refuse(block, Cause::AddressWithoutValue, "L without a number", at);
  if (open.line.take('(') && !given_values(open, block, call.extras.make().given)) return false;
  if (open.line.peek() == 'P' && open.line.name().size() > 1 && !is_digit(open.line.name()[1])) {
    words.call = std::move(call);
    return true;  // another name, which is read next
  }
  if (!pass_count(open, block, call.l)) return false;
  words.call = std::move(call);
  return true;
}

/// Write a call, which has a block of its own.
bool write_call(OpenBlock& open, Block& block, const Words& words, CallRecord call) {
  if (!words.is_call_alone())
    return open.refuse(block, Cause::IllegalWordWithCall, "a call must be alone in its block",
                       call.at);
  open.to.become(block, Op::Call, std::move(call));
  return true;
}

bool other_call(OpenBlock& open, Block& block, Link& link, const std::string& word,
                std::uint32_t at) {
  if (word == "CALL") {
    if (capitals(open.line.name()) == "BLOCK") return call_block(open, block, link, at);
    return call_by_text(open, block, link, at);
  }
  if (word == "PCALL") return call_by_path(open, block, at);
  if (word == "EXTCALL") return external_call(open, block, at);
  if (word == "CALLPATH") return call_path(open, block, at);
  if (word == "SETAL") return user_alarm(open, block, at);
  return call_in_iso_mode(open, block, at);
}

/// Read a text between quotes that is the whole of a value.
bool text_here(OpenBlock& open, Block& block, std::string& text) {
  const std::uint32_t at = open.line.offset();
  if (open.line.peek() != '"') {
    open.line.pass(std::max<std::size_t>(open.line.name().size(), 1));
    return open.not_computed(block, "a text that is computed here", at);
  }
  open.line.take('"');
  if (!open.line.take_up_to('"', text))
    return open.refuse(block, Cause::StatementFormat, "the quote is not closed", at);
  if (open.line.peek() != '<') return true;
  return open.not_computed(block, "a text that is computed here", at);
}

/// Read the text that names the block to return to.
static bool return_text(OpenBlock& open, Block& block, CallExtras& to) {
  Value text;
  Type type = Type::Real;
  if (!open.expression.value_of_any(text, type)) return open.refuse(block);
  text.at = to.name_at;
  text.width = open.line.width_from(text.at);
  if (type != Type::String)
    return open.refuse(block, Cause::TypeMismatch,
                       "a return goes to a block that a text names: RET(\"N10\")", text.at);
  if (text.computed)
    to.name_text = operand_of(text);
  else
    to.name = capitals(trimmed(open.to.code().texts.at(to_whole<std::size_t>(text.number))));
  return true;
}

/// Read RET("N10", 1, 2): the block to return to, whether the one after it is meant, and how many
/// levels. A fourth value counts in ISO mode alone. [general knowledge]
bool return_by_values(OpenBlock& open, Block& block, std::uint32_t at) {
  open.line.take('(');
  CallRecord back;
  CallExtras& to = back.extras.make();
  to.by_values = true;
  to.name_at = open.line.offset();
  if (open.line.peek() != ',' && open.line.peek() != ')' && !return_text(open, block, to))
    return false;
  to.name_width = open.line.width_from(to.name_at);
  Operand fourth;
  for (Operand* const operand : {&to.after, &to.levels, &fourth})
    if (open.line.take(',') && !return_value(open, block, *operand)) return false;
  if (!open.line.take(')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", open.line.offset());
  if (!open.end_of_statement(block)) return false;
  if (fourth.present()) open.to.drop(fourth.at, fourth.width);
  open.to.words(block, {});
  back.at = at;
  back.width = open.line.width_from(at);
  open.to.become(block, Op::Return, std::move(back));
  return true;
}

/// Read REPEAT FIRST, REPEAT FIRST LAST or REPEATB FIRST, and a P with the count; or the REPEAT of
/// a loop, alone in its block.
bool repeat(OpenBlock& open, Block& block, Link& link, std::uint32_t at) {
  link.kind = Link::Kind::None;
  if (open.line.at_end() && link.part_end == Link::PartEnd::Here) {
    link.kind = Link::Kind::Repeat;
    return true;
  }
  if (!jump_target(open, block, "REPEAT", link.target)) return false;
  constexpr const char* kByText =
      "the repetition of a part that a text names: CALL BLOCK takes texts, REPEAT the label itself";
  if (link.target.computed) return open.not_computed(block, kByText, link.target.at);
  const auto has_count = [&open] {
    return open.line.peek() == 'P' &&
           (open.line.name().size() == 1 || is_digit(open.line.name()[1]));
  };
  if (link.part_end == Link::PartEnd::Here && !open.line.at_end() && !has_count()) {
    link.part_end = Link::PartEnd::Label;
    if (!jump_target(open, block, "REPEAT", link.last)) return false;
    if (link.last.computed) return open.not_computed(block, kByText, link.last.at);
  }
  Operand count;
  if (has_count() && !pass_count(open, block, count)) return false;
  return part(open, block, link, CallKind::Repeat, at, count);
}

}  // namespace cncsub::sinumerik
