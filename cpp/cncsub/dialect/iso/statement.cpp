// Macro statements of the ISO family: assignments, IF, loops, jumps, output.
#include "cncsub/dialect/iso/statement.hpp"

#include <algorithm>
#include <string>

namespace cncsub {

// No control takes an IF after THEN. Such an IF is read only to report what is wrong with it.
constexpr int kDeepestThen = 10;

namespace {

/// Return the target of an assignment whose value stands in cell `value`.
Assigned assigned_by(const ExpressionRules& rules, const ExpressionReader::Variable& variable,
                     std::uint32_t value) {
  using enum Statement::Target;
  if (variable.number < 0) return {Indirect, value - variable.expression};
  const auto number = static_cast<std::uint32_t>(variable.number);
  if (const auto* const near = rules.code.direct_variables.find(number);
      near != nullptr && near->writable)
    return {near->raw == Ins::LocalRaw ? Local : Common, near->base + number - near->first};
  const VariablePlace place = rules.code.place(variable.number);
  const auto index = static_cast<std::uint32_t>(place.index);
  if (place.is_local()) return {Local, index};
  if (place.is_common() && place.range->access == Access::ReadWrite) return {Common, index};
  constexpr std::int64_t kLargestNumber = 2000000000;
  return {Variable, static_cast<std::uint32_t>(std::min(variable.number, kLargestNumber))};
}

/// Return the first comment in a text: after a value it is data of #3000 and #3006.
std::string_view comment_in(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos) return {};
  return text.substr(open + 1, std::min(text.find(')', open), text.size()) - open - 1);
}

/// Return whether `#2=` stands here, and not a stray variable.
bool starts_assignment(Scanner s) {
  if (!s.take('#')) return false;
  while (is_digit(s.peek())) ++s.at;
  return s.peek() == '=';
}

}  // namespace

// ENDIF and ENDW stand before END, with which both begin.
const StatementReader::Keyword StatementReader::kKeywords[] = {
    {"ENDIF", &StatementReader::bare, Op::EndIf, {}},
    {"ELSE", &StatementReader::bare, Op::Else, {}},
    {"ENDW", &StatementReader::bare, Op::EndDo, {}},
    {"IF", &StatementReader::if_statement, Op::If, StatementKind::If},
    {"WHILE", &StatementReader::while_statement, Op::While, StatementKind::While},
    {"GOTO", &StatementReader::jump, Op::Goto, {}},
    {"DO", &StatementReader::loop, Op::Do, StatementKind::Do},
    {"END", &StatementReader::loop, Op::EndDo, StatementKind::Do},
    {"DPRNT", &StatementReader::print, Op::Print, StatementKind::Dprnt},
    {"BPRNT", &StatementReader::print, Op::Print, StatementKind::Bprnt},
    {"POPEN", &StatementReader::device, Op::OpenOutput, StatementKind::Popen},
    {"PCLOS", &StatementReader::device, Op::CloseOutput, StatementKind::Pclos},
    {"SETVN", &StatementReader::name_variables, Op::NameVariables, {}}};

/// Return whether the control has a keyword. ELSE, ENDIF and ENDW depend on its forms of IF and
/// loops.
bool StatementReader::has(const Keyword& keyword) const {
  const MacroRules& rules = code_.control->macros;
  if (keyword.op == Op::EndIf || keyword.op == Op::Else)
    return rules.if_form.value == IfForm::Blocks || rules.if_form.value == IfForm::ThenBlocks;
  if (keyword.op == Op::EndDo && !keyword.kind) return rules.loop_form.value == LoopForm::WhileEndw;
  return true;
}

void StatementReader::refuse(Fault fault) { to_.refuse(block_, std::move(fault)); }

void StatementReader::refuse(Cause cause, std::uint32_t at, std::uint32_t width,
                             std::string detail) {
  refuse({cause, at, width, std::move(detail)});
}

/// Take a keyword that stands here: whole, or its first two letters if no letter follows them.
bool StatementReader::keyword(std::string_view word) {
  Scanner ahead = s_;
  if (ahead.take_word(word)) {
    s_ = ahead;
    return true;
  }
  if (!code_.control->macros.short_functions.value || word.size() < 4) return false;
  ahead = s_;
  if (!ahead.take_word(word.substr(0, 2))) return false;
  const char next = ahead.peek();
  if (is_letter(next)) return false;
  s_ = ahead;
  return true;
}

/// Refuse a statement that the control does not have, or of which no source says whether it has it.
bool StatementReader::refuses(StatementKind kind, std::uint32_t at, std::string_view name) {
  auto wrong = code_.lacks(kind, at);
  if (wrong && !name.empty())
    wrong->detail.replace(wrong->detail.size() - name_of(kind).size(), std::string::npos, name);
  if (wrong) refuse(*wrong);
  return wrong.has_value();
}

/// Return whether the block ends after the statement; refuse any text that follows.
bool StatementReader::ends(Cause otherwise) {
  s_.blanks();
  if (code_.control->reading.open_comment.value == OpenComment::RestOfBlock) s_.rest_of_comment();
  const char c = s_.peek();
  if (c == '\0') return true;
  if (c == ']')
    refuse(Cause::BracketNotOpened, s_.offset(), 1, "this bracket was never opened");
  else if (is_letter(c) || starts_assignment(s_))
    refuse(otherwise, s_.offset(), 1, "nothing else can follow the statement in its block");
  else
    refuse(block_.op == Op::Assign ? Cause::ExpressionFormat : Cause::StatementFormat, s_.offset(),
           1, "the statement ends before this");
  return false;
}

bool StatementReader::read() {
  const char c = s_.peek();
  if (c == '#') {
    assign();
    return true;
  }
  if (c == '[') return named_assignment();
  if (!is_letter(c)) return false;
  Statement statement;
  statement.at = s_.offset();
  statement.width = 2;
  for (const Keyword& of : kKeywords) {
    if (of.word[0] != c || !has(of) || !keyword(of.word)) continue;
    const bool wrong = of.kind && lacks(*of.kind, statement.at, of.word);
    if (!wrong) (this->*of.read)(of, statement);
    return true;
  }
  return false;
}

/// Read `[#NAME] = 5`.
bool StatementReader::named_assignment() {
  if (!code_.control->macros.variable_forms.value.has(VariableForm::Names)) return false;
  Scanner ahead = s_;
  ahead.take('[');
  if (!ahead.take('#') || (!is_letter(ahead.peek()) && ahead.peek() != '_')) return false;
  s_.take('[');
  assignment(true);
  return true;
}

void StatementReader::assignment(bool bracketed) {
  const std::uint32_t at = s_.offset();
  ++s_.at;
  const auto variable = expressions_.variable(s_, at);
  if (!variable) return refuse(expressions_.fault());
  if (bracketed && !s_.take(']'))
    return refuse(Cause::BracketNotClosed, s_.offset(), 1, "the bracket of the name is not closed");
  const std::uint32_t width = std::max<std::uint32_t>(1, s_.offset() - at);
  if (!s_.take('='))
    return refuse(Cause::MissingEquals, s_.offset(), 1, "there is no = after the variable");
  const auto value = expressions_.number(s_);
  if (!value) return refuse(expressions_.fault());
  const std::uint32_t end = s_.offset();
  block_.op = Op::Assign;
  const bool words_follow = takes_words();
  if (!words_follow && !at_end(Cause::NcAndMacroInBlock)) return;
  Assigned assigned = assigned_by(expressions_.rules(), *variable, *value);
  assigned.at = at - block_.text;
  assigned.width = width;
  const bool kept = assigned.target <= Statement::Target::Common || !expressions_.comments();
  const char* const behind = s_.file + code_.expression(*value).at();
  const std::string_view comment =
      kept ? std::string_view() : comment_in({behind, static_cast<std::size_t>(s_.end - behind)});
  if (!words_follow && comment.empty() && assigned.fits() && !code_.general_only)
    return set(block_, assigned, *value);
  Statement statement = assigned.statement(*value, block_.text);
  statement.width = std::max<std::uint32_t>(1, end - at);
  if (!comment.empty()) statement.text = static_cast<std::uint32_t>(comment.data() - s_.file);
  statement.text_length = static_cast<std::uint32_t>(comment.size());
  if (words_follow)
    assigned_ = statement;
  else
    to_.become(block_, Op::Assign, statement);
}

/// Return whether words may follow an assignment, and do: after a condition, where the control
/// takes words there.
bool StatementReader::takes_words() {
  s_.blanks();
  return thens_ == 1 && code_.control->macros.if_form.value == IfForm::Words &&
         is_letter(s_.peek());
}

/// Read a statement that consists of its keyword only.
void StatementReader::bare(const Keyword& keyword, Statement& statement) {
  if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, keyword.op, statement);
}

void StatementReader::device(const Keyword& keyword, Statement& /*statement*/) {
  if (at_end(Cause::NcAndMacroInBlock)) block_.op = keyword.op;
}

/// Read the condition after IF or WHILE; its faults become faults of the statement's format.
bool StatementReader::condition(Statement& statement, Cause format) {
  statement.at = s_.offset() - 2;
  if (const auto condition = expressions_.condition(s_)) {
    statement.expression = *condition;
    return true;
  }
  Fault fault = expressions_.fault();
  if (fault.cause == Cause::ExpressionFormat) fault.cause = format;
  refuse(fault);
  return false;
}

void StatementReader::if_statement(const Keyword& /*keyword*/, Statement& statement) {
  if (!condition(statement, Cause::IfFormat)) return;
  const IfForm form = code_.control->macros.if_form.value;
  if (form == IfForm::Blocks) {
    if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, Op::If, statement);
    return;
  }
  if (keyword("GOTO"))
    return jump({"GOTO", &StatementReader::jump, Op::IfGoto, StatementKind::Goto}, statement);
  const std::uint32_t at = s_.offset();
  if (form == IfForm::GotoOnly)
    return refuse(Cause::IfFormat, at, 1, "GOTO must follow the condition");
  const bool then = keyword("THEN");
  if (!then && form != IfForm::Words)
    return refuse(Cause::IfFormat, at, 1, "GOTO or THEN must follow the condition");
  if (s_.peek() == '\0' && form == IfForm::ThenBlocks) return to_.become(block_, Op::If, statement);
  then_statement(statement);
}

/// Read the one macro statement that THEN takes, and keep it as a block of its own.
void StatementReader::then_statement(Statement& statement) {
  Block then = block_;
  const std::uint32_t at = s_.offset();
  StatementReader inner(to_, expressions_, s_, then, thens_ + 1);
  const bool read = thens_ <= kDeepestThen && inner.read();
  if (!read && thens_ == 0 && code_.control->macros.if_form.value == IfForm::Words &&
      is_letter(s_.peek())) {
    before_words_ = statement;
    return;
  }
  if (inner.assigned_) {
    assigned_ = inner.assigned_;
    before_words_ = statement;
    return;
  }
  if (!read) return refuse(Cause::IfFormat, at, 1, "only one macro statement can follow THEN");
  if (then.op == Op::Fault) {
    block_.op = Op::Fault;
    block_.aux = then.aux;
    Fault& fault = to_.record<Fault>(then.aux);
    if (fault.cause == Cause::NcAndMacroInBlock || fault.cause == Cause::StatementFormat)
      fault.cause = Cause::IfFormat;
    return;
  }
  const bool simple = then.op == Op::Set || then.op == Op::Assign || then.op == Op::Goto ||
                      then.op == Op::Print || then.op == Op::OpenOutput ||
                      then.op == Op::CloseOutput;
  if (!simple)
    return refuse(Cause::IfFormat, at, 1,
                  "only an assignment, a jump or an output can follow THEN");
  statement.then = to_.keep(then);
  to_.become(block_, Op::IfThen, statement);
}

void StatementReader::while_statement(const Keyword& keyword, Statement& statement) {
  if (!condition(statement, Cause::WhileFormat)) return;
  if (code_.control->macros.loop_form.value == LoopForm::WhileEndw) {
    if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, Op::While, statement);
    return;
  }
  if (!s_.take_word("DO"))
    return refuse(Cause::WhileFormat, s_.offset(), 1, "DO must follow the condition");
  loop(keyword, statement);
}

void StatementReader::loop(const Keyword& keyword, Statement& statement) {
  const Op op = keyword.op;
  const std::uint32_t at = s_.offset();
  if (!is_digit(s_.peek())) {
    refuse(op == Op::While ? Cause::WhileFormat : Cause::IllegalLoopNumber, s_.offset(), 1,
           "the loop has no number");
    return;
  }
  const Number number = scan_number(s_);
  const int most = code_.control->macros.max_loop_number.value;
  if (number.points != 0 || number.value < 1 || number.value > most)
    return refuse(Cause::IllegalLoopNumber, at, std::max(1u, s_.offset() - at),
                  "a DO number must be 1 to " + std::to_string(most));
  statement.number = to_whole<std::int32_t>(number.value);
  if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, op, statement);
}

void StatementReader::jump(const Keyword& keyword, Statement& statement) {
  const Op op = keyword.op;
  const Cause format = op == Op::IfGoto ? Cause::IfFormat : Cause::StatementFormat;
  if (code_.lacking.test(static_cast<std::size_t>(StatementKind::Goto)))
    return refuse(Cause::StatementNotAvailable, statement.at, 4, "this control has no GOTO");
  s_.blanks();
  const std::uint32_t at = s_.offset();
  statement.variable_at = at;
  statement.number = -1;
  const char c = s_.peek();
  if (c == '#' || c == '[') {
    const auto value = expressions_.word_value(s_, '\0');
    if (!value) return refuse(expressions_.fault());
    statement.variable = *value;
  } else if (is_digit(c) || c == '-' || c == '.' || c == '+') {
    const Number number = scan_number(s_);
    const int most = code_.control->calls.max_jump_number.value;
    if (number.points != 0)
      return refuse(Cause::IllegalDecimalPoint, at, 1, "a sequence number has no point");
    if (!number.any) return refuse(format, at, 1, "GOTO without a sequence number");
    if (number.value < 1 || number.value > most)
      return refuse(Cause::IllegalJumpNumber, at, std::max(1u, s_.offset() - at),
                    "the number of GOTO must be 1 to " + std::to_string(most));
    statement.number = to_whole<std::int32_t>(number.value);
  } else {
    return refuse(format, at, 1, "GOTO without a sequence number");
  }
  statement.variable_width = std::max(1u, s_.offset() - at);
  if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, op, statement);
}

}  // namespace cncsub
