// Calls of programs: by name, by a text, by a path; parts of programs; alarms that a program
// raises.
#include <algorithm>
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"

namespace cncsub::sinumerik {

namespace {

// The numbers of alarms that a user's program may raise. [general knowledge]
constexpr std::int32_t kFirstUserAlarm = 65000, kLastUserAlarm = 65999;

Operand operand_of(const Value& value) {
  Operand operand;
  operand.kind = value.computed ? Operand::Kind::Expression : Operand::Kind::Constant;
  operand.value = value.number;
  operand.expression = value.expression;
  operand.at = value.at;
  operand.width = value.width;
  return operand;
}

/// Return a program's name without what the control puts around it: _N_SUB_SPF is SUB. [828D p.490]
std::string_view bare(std::string_view name) {
  const std::string capital = capitals(name);
  const std::size_t before = capital.starts_with("_N_") ? 3 : 0;
  const std::string_view last =
      std::string_view(capital).substr(capital.size() - std::min<std::size_t>(capital.size(), 4));
  const bool ending = last == "_SPF" || last == "_MPF" || last == ".SPF" || last == ".MPF";
  const std::size_t around = before + (ending ? 4 : 0);
  return name.size() > around ? name.substr(before, name.size() - around) : name;
}

}  // namespace

/// Read L100, SUB or SUB(), and a P with the count.
bool BlockReader::call(Block& block, Words& words, std::string_view name) {
  const std::uint32_t at = line_.offset();
  line_.pass(name.size());
  CallRecord call;
  call.kind = CallKind::Named;
  call.at = at;
  call.width = line_.width_from(at);
  CallExtras& named = call.extras.make();
  named.name_at = call.at;
  named.name_width = call.width;
  named.name = std::string(bare(name));
  named.count = 'P';
  if (words.call) return refuse(block, Cause::CallGivenTwice, "a second call", at);
  if (name.size() == 1) return refuse(block, Cause::AddressWithoutValue, "L without a number", at);
  if (line_.take('(') && !given_values(block, named.given)) return false;
  if (line_.peek() == 'P' && line_.name().size() > 1 && !is_digit(line_.name()[1])) {
    words.call = std::move(call);
    return true;  // another name, which is read next
  }
  if (!pass_count(block, call.l)) return false;
  words.call = std::move(call);
  return true;
}

/// Read P3 or P=R1, where it stands here.
bool BlockReader::pass_count(Block& block, Operand& count) {
  if (line_.peek() != 'P') return true;
  const std::uint32_t at = line_.offset();
  line_.pass(1);
  Value value;
  if (line_.take('=') ? !expression_.value(value) : !expression_.number(value))
    return refuse(block);
  value.at = at;
  value.width = line_.width_from(at);
  count = operand_of(value);
  return true;
}

/// Read the values of a call up to the closing bracket. A value may be left out between its commas.
bool BlockReader::given_values(Block& block, std::vector<ActualParameter>& given) {
  while (!line_.take(')')) {
    ActualParameter& one = given.emplace_back();
    one.operand.at = line_.offset();
    if (line_.peek() != ',') {
      one.variable = expression_.variable_alone();
      Value value;
      if (!expression_.value_or_text(value, one.is_text)) return refuse(block);
      one.operand = operand_of(value);
    }
    if (line_.peek() != ')' && !line_.take(','))
      return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  }
  return true;
}

/// Write a call, which has a block of its own.
bool BlockReader::write_call(Block& block, const Words& words, CallRecord call) {
  const bool alone = !words.any && words.statements.empty() && !words.print && !words.back;
  if (!alone)
    return refuse(block, Cause::IllegalWordWithCall, "a call must be alone in its block", call.at);
  to_.become(block, Op::Call, std::move(call));
  return true;
}

// ---- calls that begin with a word ----

bool BlockReader::other_call(Block& block, Link& link, const std::string& word, std::uint32_t at) {
  if (word == "CALL") {
    if (capitals(line_.name()) == "BLOCK") return call_block(block, link, at);
    return call_by_text(block, link, at);
  }
  if (word == "PCALL") return call_by_path(block, at);
  if (word == "EXTCALL") return external_call(block, at);
  if (word == "SETAL") return user_alarm(block, at);
  return not_computed(block, "a program in ISO mode", at);  // ISOCALL
}

/// Read a text between quotes that is the whole of a value.
bool BlockReader::text_here(Block& block, std::string& text) {
  const std::uint32_t at = line_.offset();
  if (line_.peek() != '"') {
    line_.pass(std::max<std::size_t>(line_.name().size(), 1));
    return not_computed(block, "a text that is computed here", at);
  }
  line_.take('"');
  if (!line_.take_up_to('"', text))
    return refuse(block, Cause::StatementFormat, "the quote is not closed", at);
  if (line_.peek() != '<') return true;
  return not_computed(block, "a text that is computed here", at);
}

/// Write the call of a program by its path, of which the last name counts.
bool BlockReader::named_call(Block& block, std::string_view path, std::uint32_t at,
                             std::vector<ActualParameter> given) {
  const std::size_t slash = path.find_last_of("/\\:");
  const std::string_view name = path.substr(slash == std::string_view::npos ? 0 : slash + 1);
  if (name.empty())
    return refuse(block, Cause::IllegalProgramName, "the name of the program is missing", at);
  CallRecord call;
  call.kind = CallKind::Named;
  call.at = at;
  call.width = line_.width_from(at);
  CallExtras& named = call.extras.make();
  named.name_at = at;
  named.name_width = call.width;
  named.name = std::string(bare(name));
  named.count = 'P';
  named.given = std::move(given);
  if (!end_of_statement(block)) return false;
  to_.become(block, Op::Call, std::move(call));
  return true;
}

/// Read CALL "/_N_SPF_DIR/_N_SUB_SPF".
bool BlockReader::call_by_text(Block& block, Link& link, std::uint32_t at) {
  std::string path;
  if (!text_here(block, path)) return false;
  if (capitals(line_.name()) != "BLOCK")
    return named_call(block, path, at, std::vector<ActualParameter>());
  link.kind = Link::Kind::None;
  return not_computed(block, "the call of a part of another program", at);
}

/// Read CALL BLOCK FIRST TO LAST.
bool BlockReader::call_block(Block& block, Link& link, std::uint32_t at) {
  line_.pass(line_.name().size());
  link.part_end = Link::PartEnd::Called;
  if (!jump_target(block, "CALL", link.target)) return false;
  const std::uint32_t to = line_.offset();
  if (capitals(line_.name()) != "TO")
    return refuse(block, Cause::StatementFormat, "TO is missing: CALL BLOCK FIRST TO LAST", to);
  line_.pass(2);
  return jump_target(block, "CALL", link.last) &&
         part(block, link, CallKind::CallBlock, at, Operand());
}

/// Read PCALL /_N_WKS_DIR/_N_SHAFT_WPD/SUB(1, R2).
bool BlockReader::call_by_path(Block& block, std::uint32_t at) {
  line_.offset();  // past blanks
  const std::string_view rest = line_.rest();
  const std::size_t end = std::min(rest.find_first_of("( \t\r"), rest.size());
  const std::string_view path = rest.substr(0, end);
  line_.pass(end);
  std::vector<ActualParameter> given;
  if (line_.take('(') && !given_values(block, given)) return false;
  return named_call(block, path, at, std::move(given));
}

/// Read EXTCALL("SUB.SPF"), with its brackets or without.
bool BlockReader::external_call(Block& block, std::uint32_t at) {
  const bool bracket = line_.take('(');
  std::string path;
  if (!text_here(block, path)) return false;
  if (bracket && !line_.take(')'))
    return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  return named_call(block, path, at, std::vector<ActualParameter>());
}

/// Read SETAL(65000), or SETAL(65000, "TEXT").
bool BlockReader::user_alarm(Block& block, std::uint32_t at) {
  if (!line_.take('(')) return refuse(block, Cause::BracketNotOpened, "( is missing", at);
  Value number;
  if (!expression_.value(number)) return refuse(block);
  Print alarm;
  alarm.alarms = true;
  alarm.at = at;
  alarm.number = to_.expressions().expression_of(number);
  alarm.first_number = kFirstUserAlarm;
  alarm.last_number = kLastUserAlarm;
  std::string text;
  if (line_.take(',') && !text_here(block, text)) return false;
  alarm.fields.push_back({.text = std::move(text)});
  for (const RaisedAlarm& of : to_.control().raised_alarms) {  // by the control's own programs
    if (number.computed || number.number != of.number) continue;
    alarm.first_number = alarm.last_number = of.number;
    if (alarm.fields[0].text.empty()) alarm.fields[0].text = of.text;
  }
  if (!line_.take(')'))
    return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  if (!end_of_statement(block)) return false;
  to_.become(block, Op::Print, std::move(alarm));
  return true;
}

/// Read RET("N10", 1, 2): the block to return to, whether the one after it is meant, and how many
/// levels. A fourth value counts in ISO mode alone. [general knowledge]
bool BlockReader::return_by_values(Block& block, std::uint32_t at) {
  line_.take('(');
  CallRecord back;
  CallExtras& to = back.extras.make();
  to.by_values = true;
  to.name_at = line_.offset();
  if (line_.peek() == '"') {
    std::string text;
    if (!text_here(block, text)) return false;
    to.name = capitals(trimmed(text));
  } else if (line_.peek() != ',' && line_.peek() != ')') {
    return not_computed(block, "a block to return to that is no text", to.name_at);
  }
  to.name_width = line_.width_from(to.name_at);
  Operand fourth;
  for (Operand* const operand : {&to.after, &to.levels, &fourth})
    if (line_.take(',') && !return_value(block, *operand)) return false;
  if (!line_.take(')'))
    return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  if (!end_of_statement(block)) return false;
  if (fourth.present()) to_.drop(fourth.at, fourth.width);
  to_.words(block, {});
  back.at = at;
  back.width = line_.width_from(at);
  to_.become(block, Op::Return, std::move(back));
  return true;
}

/// Read a value that may be left out between its commas.
bool BlockReader::return_value(Block& block, Operand& operand) {
  if (line_.peek() == ',' || line_.peek() == ')') return true;
  Value value;
  if (!expression_.value(value)) return refuse(block);
  operand = operand_of(value);
  return true;
}

// ---- parts of the program ----

/// Read REPEAT FIRST, REPEAT FIRST LAST or REPEATB FIRST, and a P with the count; or the REPEAT of
/// a loop, alone in its block.
bool BlockReader::repeat(Block& block, Link& link, std::uint32_t at) {
  link.kind = Link::Kind::None;
  if (line_.at_end() && link.part_end == Link::PartEnd::Here) {
    link.kind = Link::Kind::Repeat;
    return true;
  }
  if (!jump_target(block, "REPEAT", link.target)) return false;
  const auto has_count = [this] {
    return line_.peek() == 'P' && (line_.name().size() == 1 || is_digit(line_.name()[1]));
  };
  if (link.part_end == Link::PartEnd::Here && !line_.at_end() && !has_count()) {
    link.part_end = Link::PartEnd::Label;
    if (!jump_target(block, "REPEAT", link.last)) return false;
  }
  Operand count;
  if (has_count() && !pass_count(block, count)) return false;
  return part(block, link, CallKind::Repeat, at, count);
}

/// Write a block that executes a part of the program as a call.
bool BlockReader::part(Block& block, Link& link, CallKind kind, std::uint32_t at,
                       const Operand& count) {
  if (!end_of_statement(block)) return false;
  CallRecord call;
  call.kind = kind;
  call.at = at;
  call.width = line_.width_from(at);
  call.l = count;
  call.target.program = static_cast<std::int32_t>(to_.code().programs.size()) - 1;
  CallExtras& named = call.extras.make();
  named.name = link.target.label.empty() ? "N" : link.target.label;
  named.name_at = link.target.at;
  named.name_width = link.target.width;
  named.count = 'P';
  link.kind = Link::Kind::Part;
  to_.become(block, Op::RepeatPart, std::move(call));
  return true;
}

}  // namespace cncsub::sinumerik
