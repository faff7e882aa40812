#include "cncsub/statement.hpp"

#include <algorithm>
#include <string>

namespace cncsub {

namespace {

// No control takes an IF behind THEN; what stands there is still read, to tell what is wrong with
// it.
constexpr int kDeepestThen = 10;

}  // namespace

void StatementReader::refuse(Fault fault) {
  block_.op = Op::Fault;
  block_.aux = static_cast<std::uint32_t>(code_.faults.size());
  code_.faults.push_back(std::move(fault));
}

void StatementReader::refuse(Cause cause, std::uint32_t at, std::uint32_t width,
                             std::string detail) {
  refuse({cause, at, width, std::move(detail)});
}

/// A keyword stands here: whole, or its first two letters with something behind them that is no
/// letter of a longer word.
bool StatementReader::keyword(std::string_view word) {
  Scanner ahead = s_;
  if (ahead.take_word(word)) {
    s_ = ahead;
    return true;
  }
  if (!code_.control->short_functions.value || word.size() < 4) return false;
  ahead = s_;
  if (!ahead.take_word(word.substr(0, 2))) return false;
  const char next = ahead.peek();
  if (is_letter(next)) return false;
  s_ = ahead;
  return true;
}

/// Refuses a statement that the control does not have, or of which nobody says whether it has it.
bool StatementReader::lacks(StatementKind kind, std::uint32_t at, std::string_view name) {
  auto wrong = code_.lacks(kind, at);
  if (wrong && !name.empty())
    wrong->detail.replace(wrong->detail.size() - statement_name(kind).size(), std::string::npos,
                          name);
  if (wrong) refuse(*wrong);
  return wrong.has_value();
}

/// `#2=` rather than a stray variable.
bool StatementReader::starts_assignment() const {
  Scanner ahead = s_;
  if (!ahead.take('#')) return false;
  while (is_digit(ahead.peek())) ++ahead.at;
  return ahead.peek() == '=';
}

/// Nothing may stand behind a statement.
bool StatementReader::at_end(Cause otherwise) {
  s_.blanks();
  if (code_.control->open_comment.value == OpenComment::RestOfBlock) s_.rest_of_comment();
  const char c = s_.peek();
  if (c == '\0') return true;
  if (c == ']')
    refuse(Cause::BracketNotOpened, s_.offset(), 1, "this bracket was never opened");
  else if (is_letter(c) || starts_assignment())
    refuse(otherwise, s_.offset(), 1, "behind the statement stands another word");
  else
    refuse(block_.op == Op::Assign ? Cause::ExpressionFormat : Cause::StatementFormat, s_.offset(),
           1, "the statement ends before this");
  return false;
}

void StatementReader::finish(Op op, Statement statement) {
  block_.op = op;
  block_.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(statement);
}

bool StatementReader::read() {
  const Control& control = *code_.control;
  const char c = s_.peek();
  if (c == '#') {
    if (!lacks(StatementKind::Variables, s_.offset())) assignment(false);
    return true;
  }
  if (c == '[' && control.variable_names.value) {  // [#NAME] = 5
    Scanner ahead = s_;
    ahead.take('[');
    if (ahead.take('#') && (is_letter(ahead.peek()) || ahead.peek() == '_')) {
      s_.take('[');
      assignment(true);
      return true;
    }
  }
  if (!is_letter(c)) return false;
  Statement statement;
  statement.at = s_.offset();
  statement.width = 2;
  const bool blocks = control.if_form.value == IfForm::Blocks;
  const bool then_blocks = control.if_form.value == IfForm::ThenBlocks;
  if (blocks || then_blocks) {
    if (keyword("ENDIF")) {
      if (at_end(Cause::NcAndMacroInBlock)) finish(Op::EndIf, statement);
      return true;
    }
    if (keyword("ELSE")) {
      if (at_end(Cause::NcAndMacroInBlock)) finish(Op::Else, statement);
      return true;
    }
  }
  if (control.loop_form.value == LoopForm::WhileEndw && keyword("ENDW")) {
    if (at_end(Cause::NcAndMacroInBlock)) finish(Op::EndDo, statement);
    return true;
  }
  if (s_.take_word("IF")) {
    if (!lacks(StatementKind::If, statement.at)) if_statement();
  } else if (keyword("WHILE")) {
    if (!lacks(StatementKind::While, statement.at)) while_statement();
  } else if (keyword("GOTO")) {
    jump(Op::Goto, statement);
  } else if (s_.take_word("DO")) {
    if (!lacks(StatementKind::Do, statement.at)) loop(Op::Do, statement);
  } else if (keyword("END")) {
    if (!lacks(StatementKind::Do, statement.at, "END")) loop(Op::EndDo, statement);
  } else if (keyword("DPRNT")) {
    if (!lacks(StatementKind::Dprnt, statement.at)) print(false);
  } else if (keyword("BPRNT")) {
    if (!lacks(StatementKind::Bprnt, statement.at)) print(true);
  } else if (keyword("POPEN")) {
    if (!lacks(StatementKind::Popen, statement.at) && at_end(Cause::NcAndMacroInBlock))
      block_.op = Op::OpenOutput;
  } else if (keyword("PCLOS")) {
    if (!lacks(StatementKind::Pclos, statement.at) && at_end(Cause::NcAndMacroInBlock))
      block_.op = Op::CloseOutput;
  } else if (keyword("SETVN")) {
    name_variables(statement);
  } else {
    return false;
  }
  return true;
}

void StatementReader::assignment(bool bracketed) {
  Statement statement;
  statement.at = s_.offset();
  statement.variable_at = s_.offset();
  s_.take('#');
  ExpressionReader reader(code_, s_);
  if (is_letter(s_.peek()) || s_.peek() == '_') {
    if (!code_.control->variable_names.value)
      return refuse(Cause::ExpressionFormat, s_.offset(), 1,
                    "behind # stands a number, or an expression in brackets");
    code_.names.push_back(s_.take_name());
    statement.target = Statement::Target::Indirect;
    statement.variable = static_cast<std::uint32_t>(code_.expressions.size());
    code_.expressions.push_back(
        {.first = static_cast<std::uint32_t>(code_.instructions.size()), .at = statement.at});
    code_.instructions.push_back(
        {Ins::Named, 0, statement.at, static_cast<double>(code_.names.size() - 1)});
    code_.instructions.push_back({Ins::End, 0, statement.at, 0});
  } else {
    const auto variable = reader.variable();
    if (!variable) return refuse(reader.fault());
    if (variable->number < 0) {
      statement.target = Statement::Target::Indirect;
      statement.variable = variable->expression;
    } else {
      std::int64_t number = variable->number;
      const VariablePlace place = code_.place(number);
      const bool indirect = code_.control->indirect_9nnn.value && number >= 9000 && number <= 9999;
      if (indirect) {
        statement.target = Statement::Target::Indirect;
        statement.variable = static_cast<std::uint32_t>(code_.expressions.size());
        code_.expressions.push_back(
            {.first = static_cast<std::uint32_t>(code_.instructions.size()), .at = statement.at});
        const VariablePlace inner = code_.place(number - 9000);
        const bool common = inner.kind == VariableKind::Common || inner.kind == VariableKind::Kept;
        const bool local = inner.kind == VariableKind::Local;
        const bool plain = inner.range != nullptr && (common || local);
        code_.instructions.push_back(
            {!plain   ? Ins::Variable
             : common ? Ins::Common
                      : Ins::Local,
             0, plain ? static_cast<std::uint32_t>(inner.index) : statement.at,
             static_cast<double>(number - 9000)});
        code_.instructions.push_back({Ins::End, 0, statement.at, 0});
      } else if (place.range != nullptr && place.kind == VariableKind::Local) {
        statement.target = Statement::Target::Local;
        statement.index = place.index;
      } else if (place.range != nullptr &&
                 (place.kind == VariableKind::Common || place.kind == VariableKind::Kept) &&
                 place.range->access == Access::ReadWrite) {
        statement.target = Statement::Target::Common;
        statement.index = place.index;
      } else {
        statement.target = Statement::Target::Variable;
        statement.index = static_cast<std::int32_t>(std::min<std::int64_t>(number, 2000000000));
      }
    }
  }
  if (bracketed && !s_.take(']'))
    return refuse(Cause::BracketNotClosed, s_.offset(), 1, "the name's bracket is not closed");
  statement.variable_width = std::max<std::uint32_t>(1, s_.offset() - statement.variable_at);
  if (!s_.take('='))
    return refuse(Cause::MissingEquals, s_.offset(), 1, "behind the variable stands no =");
  const auto value = reader.number();
  if (!value) return refuse(reader.fault());
  statement.expression = *value;
  statement.width = std::max<std::uint32_t>(1, s_.offset() - statement.at);
  // The comment behind the value is data of #3000 and #3006.
  const std::string_view rest(
      s_.file + code_.expressions[*value].at,
      static_cast<std::size_t>(s_.end - s_.file) - code_.expressions[*value].at);
  const std::size_t open = rest.find('(');
  if (open != std::string_view::npos) {
    const std::size_t close = std::min(rest.find(')', open), rest.size());
    statement.text = code_.expressions[*value].at + static_cast<std::uint32_t>(open) + 1;
    statement.text_length = static_cast<std::uint32_t>(close - open - 1);
  }
  block_.op = Op::Assign;
  if (at_end(Cause::NcAndMacroInBlock)) finish(Op::Assign, statement);
}

void StatementReader::if_statement() {
  Statement statement;
  statement.at = s_.offset() - 2;
  statement.width = 2;
  ExpressionReader reader(code_, s_);
  const auto condition = reader.condition();
  if (!condition) {
    Fault fault = reader.fault();
    if (fault.cause == Cause::ExpressionFormat) fault.cause = Cause::IfFormat;
    return refuse(fault);
  }
  statement.expression = *condition;
  if (code_.control->if_form.value == IfForm::Blocks) {
    if (at_end(Cause::NcAndMacroInBlock)) finish(Op::If, statement);
    return;
  }
  if (keyword("GOTO")) return jump(Op::IfGoto, statement);
  if (code_.control->if_form.value == IfForm::GotoOnly)
    return refuse(Cause::IfFormat, s_.offset(), 1, "behind the condition stands GOTO");
  if (!keyword("THEN"))
    return refuse(Cause::IfFormat, s_.offset(), 1, "behind the condition stands GOTO or THEN");
  if (s_.peek() == '\0' && code_.control->if_form.value == IfForm::ThenBlocks)
    return finish(Op::If, statement);
  then_statement(statement);
}

/// THEN takes one macro statement, kept as a block of its own.
void StatementReader::then_statement(Statement& statement) {
  Block then = block_;
  const std::uint32_t at = s_.offset();
  StatementReader inner(code_, s_, then, thens_ + 1);
  if (thens_ > kDeepestThen || !inner.read())
    return refuse(Cause::IfFormat, at, 1, "THEN takes one macro statement");
  if (then.op == Op::Fault) {
    block_.op = Op::Fault;
    block_.aux = then.aux;
    Fault& fault = code_.faults[then.aux];
    if (fault.cause == Cause::NcAndMacroInBlock || fault.cause == Cause::StatementFormat)
      fault.cause = Cause::IfFormat;
    return;
  }
  const bool simple = then.op == Op::Assign || then.op == Op::Goto || then.op == Op::Print ||
                      then.op == Op::OpenOutput || then.op == Op::CloseOutput;
  if (!simple)
    return refuse(Cause::IfFormat, at, 1, "THEN takes an assignment, a jump or an output");
  statement.then = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(then);
  finish(Op::IfThen, statement);
}

void StatementReader::while_statement() {
  Statement statement;
  statement.at = s_.offset() - 2;
  statement.width = 2;
  ExpressionReader reader(code_, s_);
  const auto condition = reader.condition();
  if (!condition) {
    Fault fault = reader.fault();
    if (fault.cause == Cause::ExpressionFormat) fault.cause = Cause::WhileFormat;
    return refuse(fault);
  }
  statement.expression = *condition;
  if (code_.control->loop_form.value == LoopForm::WhileEndw) {
    if (at_end(Cause::NcAndMacroInBlock)) finish(Op::While, statement);
    return;
  }
  if (!s_.take_word("DO"))
    return refuse(Cause::WhileFormat, s_.offset(), 1, "behind the condition stands DO");
  loop(Op::While, statement);
}

void StatementReader::loop(Op op, Statement statement) {
  const std::uint32_t at = s_.offset();
  if (!is_digit(s_.peek())) {
    refuse(op == Op::While ? Cause::WhileFormat : Cause::IllegalLoopNumber, s_.offset(), 1,
           "the loop has no number");
    return;
  }
  const Number number = scan_number(s_);
  const int most = code_.control->max_loop_number.value;
  if (number.points != 0 || number.value < 1 || number.value > most)
    return refuse(Cause::IllegalLoopNumber, at, std::max(1u, s_.offset() - at),
                  "a loop number is 1 to " + std::to_string(most));
  statement.number = to_whole<std::int32_t>(number.value);
  if (at_end(Cause::NcAndMacroInBlock)) finish(op, statement);
}

void StatementReader::jump(Op op, Statement statement) {
  const Cause format = op == Op::IfGoto ? Cause::IfFormat : Cause::StatementFormat;
  if (!code_.control->jumps.value)
    return refuse(Cause::StatementNotAvailable, statement.at, 4, "this control has no GOTO");
  s_.blanks();
  const std::uint32_t at = s_.offset();
  statement.variable_at = at;
  statement.number = -1;
  const char c = s_.peek();
  if (c == '#' || c == '[') {
    ExpressionReader reader(code_, s_);
    const auto value = reader.word_value('\0');
    if (!value) return refuse(reader.fault());
    statement.variable = *value;
  } else if (is_digit(c) || c == '-' || c == '.' || c == '+') {
    const Number number = scan_number(s_);
    const int most = code_.control->max_jump_number.value;
    if (number.points != 0)
      return refuse(Cause::IllegalDecimalPoint, at, 1, "a sequence number has no point");
    if (!number.any) return refuse(format, at, 1, "GOTO without a sequence number");
    if (number.value < 1 || number.value > most)
      return refuse(Cause::IllegalJumpNumber, at, std::max(1u, s_.offset() - at),
                    "GOTO takes 1 to " + std::to_string(most));
    statement.number = to_whole<std::int32_t>(number.value);
  } else {
    return refuse(format, at, 1, "GOTO without a sequence number");
  }
  statement.variable_width = std::max(1u, s_.offset() - at);
  if (at_end(Cause::NcAndMacroInBlock)) finish(op, statement);
}

void StatementReader::print(bool binary) {
  Print print;
  print.binary = binary;
  print.at = s_.offset();
  if (!s_.take('['))
    return refuse(Cause::OutputFormat, s_.offset(), 1, "the output stands in brackets");
  while (s_.peek() != ']') {
    if (s_.peek() == '\0')
      return refuse(Cause::OutputFormat, s_.offset(), 1, "the output's bracket is not closed");
    if (s_.peek() == '#') {
      if (!print_field(print)) return;
      continue;
    }
    if (print.fields.empty() || print.fields.back().is_variable) print.fields.push_back({});
    print.fields.back().text += *s_.at == '*' ? ' ' : *s_.at;
    ++s_.at;
  }
  s_.take(']');
  if (!at_end(Cause::NcAndMacroInBlock)) return;
  block_.op = Op::Print;
  block_.aux = static_cast<std::uint32_t>(code_.prints.size());
  code_.prints.push_back(std::move(print));
}

/// `#100[53]`: five digits before the point, three behind it.
bool StatementReader::print_field(Print& print) {
  PrintField field;
  field.is_variable = true;
  ExpressionReader reader(code_, s_);
  const auto value = reader.word_value('\0');
  if (!value) {
    refuse(reader.fault());
    return false;
  }
  field.expression = *value;
  const std::uint32_t at = s_.offset();
  if (!s_.take('[')) {
    refuse(Cause::OutputFormat, at, 1, "behind the variable stands the number of digits, as [53]");
    return false;
  }
  const Number format = scan_number(s_);
  const bool good =
      format.written == (print.binary ? 1 : 2) && !format.negative && format.points == 0;
  if (!good || !s_.take(']')) {
    refuse(Cause::OutputFormat, at, 1, "the number of digits is two digits in brackets, as [53]");
    return false;
  }
  const int digits = to_whole<int>(format.value);
  field.whole_digits = print.binary ? 0 : digits / 10;
  field.decimals = digits % 10;
  print.fields.push_back(field);
  return true;
}

/// SETVN 510[TOOLNO, WORKNO].
void StatementReader::name_variables(Statement statement) {
  if (!code_.control->variable_names.value)
    return refuse(Cause::StatementNotAvailable, statement.at, 5, "this control has no SETVN");
  const Number first = scan_number(s_);
  if (!first.any || first.points != 0 || first.negative || first.value > 1e9 || !s_.take('['))
    return refuse(Cause::SetvnFormat, s_.offset(), 1, "write SETVN n[NAME, NAME]");
  statement.number = to_whole<std::int32_t>(first.value);
  statement.index = static_cast<std::int32_t>(code_.names.size());
  for (;;) {
    const std::uint32_t at = s_.offset();
    const std::string name = s_.take_name();
    if (name.size() > 8)
      return refuse(Cause::VariableNameTooLong, at, 1, "a variable name has at most 8 characters");
    const char behind = s_.peek();
    const bool ends = behind == ']' || behind == ',' || behind == '\0';
    if (!ends || name.empty() || is_digit(name[0]))
      return refuse(Cause::IllegalVariableName, ends ? at : s_.offset(), 1,
                    "a variable name is a letter, then letters, digits and _");
    code_.names.push_back(name);
    if (s_.take(']')) break;
    if (!s_.take(','))
      return refuse(Cause::SetvnFormat, s_.offset(), 1, "the list of names is not closed");
  }
  statement.variable_width =
      static_cast<std::uint32_t>(code_.names.size()) - static_cast<std::uint32_t>(statement.index);
  if (at_end(Cause::NcAndMacroInBlock)) finish(Op::NameVariables, statement);
}

}  // namespace cncsub
