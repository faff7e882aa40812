// Calls, jumps, and alarms that a program raises.
#include <algorithm>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/okuma/block.hpp"

namespace cncsub::okuma {

namespace {

constexpr std::size_t kLongestText = 16;  // of an alarm [OKA 2208]
constexpr std::string_view kAlarmText = "VUACM[1]";

}  // namespace

bool BlockReader::statement(Block& block, Jump& jump, const std::string& word) {
  const std::uint32_t at = line_.offset();
  line_.pass(word.size());
  if (word == "CALL" || word == "MODIN") return call(block, word, at);
  if (word == "GOTO") return jump_to(block, jump, at);
  if (word == "IF") return jump_if(block, jump, at);
  if (!end_of_statement(block)) return false;
  to_.words(block, {});
  if (word == "MODOUT") {
    block.op = Op::CancelModal;
    return true;
  }
  CallRecord back;  // RTS
  back.at = at;
  back.width = line_.width_from(at);
  to_.become(block, Op::Return, std::move(back));
  return true;
}

/// Read CALL O100 Q2 PX=1, or the same with MODIN.
bool BlockReader::call(Block& block, const std::string& word, std::uint32_t at) {
  CallRecord call;
  call.kind = CallKind::Named;
  call.locals = CallRecord::Locals::Own;
  call.at = at;
  call.width = line_.width_from(at);
  if (!called_name(block, call)) return false;
  if (!count(block, call) || !arguments(block, call)) return false;
  to_.words(block, {});
  const bool modal = word == "MODIN";
  if (modal) call.code_kind = CodeCallKind::Modal;
  to_.become(block, modal ? Op::ModalCall : Op::Call, std::move(call));
  return true;
}

bool BlockReader::called_name(Block& block, CallRecord& call) {
  const std::uint32_t at = line_.offset();
  const std::string name = capitals(line_.name());
  if (!name.starts_with('O'))
    return refuse(block, Cause::ProgramNumberMissing,
                  "the name of a program must follow: CALL O100", call.at);
  line_.pass(name.size());
  if (name.size() == 1)
    return refuse(block, Cause::IllegalProgramName, "letters or digits must follow O", at);
  if (name.size() > 1 + kLongestProgram)
    return refuse(block, Cause::IllegalProgramName, "at most 4 characters follow O", at, kTooLong);
  CallExtras& named = call.extras.make();
  named.name = name;
  named.name_at = at;
  named.name_width = line_.width_from(at);
  named.count = 'Q';
  return true;
}

bool BlockReader::count(Block& block, CallRecord& call) {
  if (line_.peek() != 'Q' || line_.begins_word()) return true;
  const std::uint32_t at = line_.offset();
  line_.pass(1);
  Value value;
  if (!value_of_word(block, value)) return false;
  value.at = at;
  value.width = line_.width_from(at);
  call.l = operand_of(value);
  return true;
}

/// Read PX=1 PY=V5, which the locals of the called program have.
bool BlockReader::arguments(Block& block, CallRecord& call) {
  std::vector<Argument> arguments;
  while (!line_.at_end()) {
    const std::uint32_t at = line_.offset();
    if (!line_.begins_word()) {
      line_.pass(std::max<std::size_t>(line_.name().size(), 1));
      return not_computed(block, "a word beside a call that gives no local a value", at);
    }
    const std::string name = capitals(line_.name());
    Statement local;
    if (!expression_.left_side(local)) return refuse(block);
    if (local.target != Statement::Target::Local)
      return not_computed(block, "a call that sets " + name, at);
    if (!line_.take('='))
      return refuse(block, Cause::MissingEquals, "= must follow the variable", line_.offset());
    Value value;
    if (!expression_.value(value)) return refuse(block);
    arguments.push_back({local.index, 0, operand_of(value)});
  }
  call.first_argument = to_.next_argument();
  call.arguments = static_cast<std::uint32_t>(arguments.size());
  for (const Argument& argument : arguments) to_.keep(argument);
  return true;
}

bool BlockReader::target(Block& block, Jump& jump, std::uint32_t at) {
  jump.target.at = line_.offset();
  const std::string name = capitals(line_.name());
  if (!name.starts_with('N') || name.size() < 2)
    return refuse(block, Cause::StatementFormat, "the name of a block must follow: N100", at,
                  kNoTarget);
  line_.pass(name.size());
  if (line_.peek() == '[') return not_computed(block, "a name with an index", jump.target.at);
  jump.target.name = name;
  jump.target.width = line_.width_from(jump.target.at);
  if (!end_of_statement(block)) return false;
  jump.is = true;
  return true;
}

bool BlockReader::jump_to(Block& block, Jump& jump, std::uint32_t at) {
  if (!target(block, jump, at)) return false;
  Statement statement;
  statement.at = at;
  statement.width = line_.width_from(at);
  statement.variable_at = jump.target.at;
  statement.variable_width = jump.target.width;
  to_.become(block, Op::Goto, statement);
  return true;
}

bool BlockReader::jump_if(Block& block, Jump& jump, std::uint32_t at) {
  Statement statement;
  statement.at = at;
  if (!expression_.condition(statement.expression)) return refuse(block);
  const std::string word = capitals(line_.name());
  if (word == "GOTO") line_.pass(word.size());
  if (word == "THEN") return not_computed(block, "THEN", line_.offset());
  if (!target(block, jump, at)) return false;
  statement.width = line_.width_from(at);
  statement.variable_at = jump.target.at;
  statement.variable_width = jump.target.width;
  jump.conditional = true;
  to_.become(block, Op::IfGoto, statement);
  return true;
}

/// Return the common that holds the text of the alarm that a program raises.
std::int32_t BlockReader::text_of_alarm() {
  const std::string name(kAlarmText);
  const bool is_new = !to_.code().named_places.contains(name + '\n');
  const std::uint32_t place = to_.names().variable(name, true);
  const std::int32_t index = to_.code().named_variables[place].index;
  if (is_new) {
    DefinedVariable text;
    text.type = DefinedVariable::Type::Text;
    text.common = true;
    text.index = index;
    text.name = name;
    to_.names().defined(std::move(text), true);
  }
  return index;
}

/// Read VUACM[1]='TEXT', whose name with its index is passed.
bool BlockReader::alarm_text(Block& block, std::uint32_t at) {
  if (!line_.take('=')) return refuse(block, Cause::MissingEquals, "= is missing", line_.offset());
  if (!line_.take('\'')) return not_computed(block, "a text that is no text between quotes", at);
  std::string_view text;
  if (!line_.take_up_to('\'', text))
    return refuse(block, Cause::StatementFormat, "the text is not closed", at, {'T', '3'});
  if (text.empty())
    return refuse(block, Cause::StatementFormat, "the text is empty", at, {'T', '1'});
  if (text.size() > kLongestText)
    return refuse(block, Cause::StatementFormat, "the text has more than 16 characters", at,
                  {'T', '2'});
  if (!end_of_statement(block)) return false;
  Statement statement;
  statement.at = at;
  statement.width = line_.width_from(at);
  statement.variable_at = at;
  statement.variable_width = static_cast<std::uint32_t>(kAlarmText.size());
  statement.target = Statement::Target::Common;
  statement.index = text_of_alarm();
  const auto number = to_.names().constant_text(std::string(text));
  statement.expression =
      to_.expressions().one({Ins::Constant, 0, at, static_cast<double>(number)}, at, 1);
  assign(to_, block, statement);
  return true;
}

/// Read VDOUT[992]=1001, whose name with its index is passed: an alarm of the program's own.
bool BlockReader::user_alarm(Block& block, std::uint32_t at) {
  if (!line_.take('=')) return refuse(block, Cause::MissingEquals, "= is missing", line_.offset());
  Value number;
  if (!expression_.value(number)) return refuse(block);
  if (!end_of_statement(block)) return false;
  constexpr std::int32_t kLast = 9999;  // general knowledge
  Print alarm;
  alarm.alarms = true;
  alarm.at = at;
  alarm.number = to_.expressions().expression_of(number);
  alarm.first_number = 1;
  alarm.last_number = kLast;
  PrintField text;
  text.is_variable = text.is_text = true;
  text.expression = to_.expressions().one(
      {Ins::Common, 0, static_cast<std::uint32_t>(text_of_alarm()), 0}, at, 1);
  alarm.fields.push_back(std::move(text));
  to_.become(block, Op::Print, std::move(alarm));
  return true;
}

}  // namespace cncsub::okuma
