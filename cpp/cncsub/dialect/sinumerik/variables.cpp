// Assignments to parameters, variables and elements of arrays.
#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr std::size_t kMostElements = 10'000;  // of one list of SET

/// Return the target of an assignment to a variable that is no array.
Statement::Target target_of(const Definition& of) {
  using Target = Statement::Target;
  if (of.reference >= 0) return of.is_array() ? Target::ReferencedElement : Target::Referenced;
  if (of.is_array())
    return of.global ? Statement::Target::CommonElement : Statement::Target::Element;
  return of.global ? Statement::Target::Common : Statement::Target::Local;
}

Definition real() { return {}; }

/// Make an assignment one to the next element.
void pass_element(Statement& of) {
  if (of.target == Statement::Target::ReferencedElement) {
    ++of.number;  // the place after the one that is named
    return;
  }
  ++of.index;
  --of.number;
}

}  // namespace

void ExpressionReader::push_converted(const Definition& of) {
  open_.constant.reset();
  open_.to.expressions().emit(reading(of));
  convert(open_, of.type, of, open_.line.offset());
}

bool ExpressionReader::variable_alone(Statement& variable, Type& type,
                                      std::vector<std::int32_t>& extents) {
  const Line before = open_.line;
  variable = Statement();
  variable.at = variable.variable_at = open_.line.offset();
  const std::string name = capitals(open_.line.name());
  const Definition* const of = open_.definitions.find(name);
  bool read = false;
  type = of != nullptr ? of->type : Type::Real;
  if (of != nullptr) {
    const bool whole =
        of->is_array() && open_.line.ahead(open_.line.past_blanks(name.size())) != '[';
    read = left_side(*of, variable);
    if (whole) extents = of->shape();
  } else if (name.starts_with('R')) {
    read = parameter_side(variable);
  }
  const char next = open_.line.peek();
  read = read && (next == ',' || next == ')');
  if (!read) {
    variable.target = Statement::Target::None;
    extents.clear();
    open_.line = before;
  }
  fault.reset();
  return read;
}

// ---- one value ----

/// Read R1 or R[R2].
bool ExpressionReader::parameter_side(Statement& statement) {
  Line& line = open_.line;
  const std::uint32_t at = statement.variable_at = line.offset();
  std::int32_t number = -1;
  line.pass(1);  // R
  if (line.ahead(0) == '[') {
    open_.to.expressions().begin();
    if (!read_bracket(open_, '[', ']', 0)) return false;
    statement.target = Statement::Target::Indirect;
    statement.variable = open_.to.expressions().end(at, line.width_from(at));
  } else {
    VariablePlace place;
    if (!parameter_number(open_, line.take_digits(), at, place, number)) return false;
    statement.target = Statement::Target::Common;
    statement.index = place.index;
    statement.number = number;
  }
  statement.variable_width = line.width_from(at);
  return true;
}

/// Read the left side, then the value. Only then does the variable count as assigned: R1=R1+1.
bool ExpressionReader::assignment(Statement& statement) {
  const std::uint32_t at = open_.line.offset();
  if (!parameter_side(statement)) return false;
  if (!open_.line.take('='))
    return open_.wrong(Cause::MissingEquals, "R1 alone has no effect: write R1=5, or X=R1", at);
  if (!assigned_value(real(), statement)) return false;
  statement.at = at;
  statement.width = open_.line.width_from(at);
  if (statement.target == Statement::Target::Common)
    open_.assigned.insert(statement.number);
  else
    open_.assigned_any = true;
  return true;
}

/// Read the name of a variable, with the indices of an element, up to the equals sign.
bool ExpressionReader::left_side(const Definition& to, Statement& statement) {
  Line& line = open_.line;
  const std::string name = capitals(line.name());
  const std::uint32_t at = statement.variable_at = line.offset();
  line.pass(name.size());
  if (to.constant)
    return open_.wrong(Cause::StatementFormat, name + " is a number, and takes none", at);
  statement.target = target_of(to);
  statement.index = to.reference >= 0 ? to.reference : to.local;
  if (to.reference >= 0 && !to.is_array()) statement.number = to.local;
  if (to.is_array()) {
    open_.to.expressions().begin();
    if (line.peek() == '[') {
      if (!read_indices(open_, to, 0)) return false;
    } else {
      open_.emit(Ins::Constant, 0);  // all of it
    }
    statement.variable = open_.to.expressions().end(at, line.width_from(at));
    if (to.reference < 0) statement.number = to.size();
  }
  statement.variable_width = line.width_from(at);
  return true;
}

bool ExpressionReader::assignment(const Definition& to, Statement& statement) {
  std::vector<Statement> statements;
  const std::uint32_t at = open_.line.offset();
  if (!assignments(to, statements)) return false;
  if (statements.size() != 1 || statements[0].count != 1)
    return open_.wrong(Cause::StatementFormat, "one value is given to a variable here", at);
  statement = statements[0];
  return true;
}

bool ExpressionReader::system_array(const SystemArray& of, Statement& statement) {
  const std::uint32_t at = statement.at;
  open_.to.expressions().begin();
  if (!read_system_array(open_, of, 0)) return false;
  statement.target = Statement::Target::Indirect;
  statement.variable = open_.to.expressions().end(at, open_.line.width_from(at));
  statement.variable_width = open_.line.width_from(at);
  if (!open_.line.take('=')) return open_.wrong(Cause::MissingEquals, "= is missing", at);
  Definition as;
  as.type = of.shape.type;
  if (!assigned_value(as, statement)) return false;
  open_.assigned.insert(kSystemArray);
  return true;
}

void ExpressionReader::note_assigned(const Definition& of) { open_.assigned.insert(mark_of(of)); }

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
bool ExpressionReader::assignments(const Definition& to, std::vector<Statement>& statements) {
  Statement statement;
  const std::uint32_t at = open_.line.offset();
  const std::string_view name = open_.line.name();
  const bool whole = open_.line.ahead(open_.line.past_blanks(name.size())) != '[';
  if (!left_side(to, statement)) return false;
  const bool character = to.type == Type::String && open_.line.peek() == '[';
  if (character) {
    if (!character_side(to, statement)) return false;
  } else if (to.type == Type::Frame && open_.line.peek() == '[') {
    if (!frame_part_side(to, statement)) return false;
  } else {
    if (!open_.line.take('='))
      return open_.wrong(Cause::MissingEquals,
                         "the variable stands alone: write a value after =", at);
    if (to.is_array() && is_list(false)) {
      if (!elements(to, statement, statements)) return false;
      open_.assigned.insert(mark_of(to));
      return true;
    }
    if (to.is_array() && whole)
      return open_.wrong(Cause::StatementFormat,
                         "an index is missing: an array takes SET(...) or REP(...)", at);
    if (!assigned_value(to, statement)) return false;
  }
  statements.push_back(statement);
  open_.assigned.insert(mark_of(to));
  return true;
}

namespace {

/// Write a place in a text, or the one after it. A computed one is read where it stands, at `from`.
void push_place(OpenExpression& open, const Line& from, const Value& index, int length, int after) {
  if (!index.computed) return open.emit(Ins::Constant, index.number + after);
  const Line end = open.line;
  open.line = from;
  read_value(open, 0);
  open.emit(Ins::Index, length);
  if (after != 0) open.emit(Ins::AddConstant, after);
  open.line = end;
}

}  // namespace

/// Read TEXT[2]="A": the text with another character at that place.
bool ExpressionReader::character_side(const Definition& to, Statement& statement) {
  Line& line = open_.line;
  const std::uint32_t at = line.offset();
  if (to.is_array())
    return open_.not_computed("a character of an element of an array of texts", at);
  const Instruction variable = reading(to);
  line.pass(1);
  const Line from = line;
  Value index;
  if (!value(index)) return false;
  const std::uint32_t width = line.width_from(at);
  if (!line.take(']')) return open_.wrong(Cause::BracketNotClosed, "] is missing", at);
  if (!line.take('=')) return open_.wrong(Cause::MissingEquals, "a value is missing", at);
  if (!index.computed && (index.number < 0 || index.number >= to.length))
    return open_.wrong(Cause::ArrayElement, "the index is outside the text", at);
  open_.to.expressions().begin();
  open_.to.expressions().emit(variable);
  push_place(open_, from, index, to.length, 0);
  open_.emit_at(at, Ins::TextUpTo);
  const Read read = read_value(open_, 0);
  Definition of;
  of.type = Type::Char;
  if (!read || !convert(open_, *read, of, at)) return false;
  open_.constant.reset();
  open_.to.expressions().emit(variable);
  push_place(open_, from, index, to.length, 1);
  open_.emit_at(at, Ins::TextFrom);
  // The character 0 ends the text: what stands behind it is gone. [828Dj p.74]
  open_.emit(Ins::JoinTexts, static_cast<int>(WrittenAs::Character) * 16);
  open_.emit(Ins::JoinTexts, 0);
  statement.at = at;
  statement.width = width;
  statement.expression = open_.to.expressions().end(at, line.width_from(at));
  return true;
}

/// Read FRAME1[X,TR]=5: the frame with another value there.
bool ExpressionReader::frame_part_side(const Definition& to, Statement& statement) {
  if (to.is_array())
    return open_.not_computed("a part of an element of an array of frames", open_.line.offset());
  if (open_.assigned.contains(mark_of(to))) return late(open_, open_.line.offset());
  const Instruction variable = reading(to);
  Value assigned;
  if (!write_frame_part(open_, variable, assigned)) return false;
  statement.expression = assigned.expression;
  statement.at = assigned.at;
  statement.width = assigned.width;
  return true;
}

bool ExpressionReader::control_frame(std::string_view name, std::uint32_t at,
                                     Statement& statement) {
  return assign_control_frame(open_, name, at, statement);
}

/// Read the value of an assignment.
bool ExpressionReader::assigned_value(const Definition& to, Statement& statement) {
  Value assigned;
  if (!value_of(to, assigned)) return false;
  statement.expression = open_.to.expressions().expression_of(assigned);
  statement.at = assigned.at;
  statement.width = assigned.width;
  return true;
}

// ---- lists ----

bool ExpressionReader::is_list(bool bracket_alone) {
  const std::string name = capitals(open_.line.name());
  return name == "SET" || name == "REP" || (bracket_alone && open_.line.peek() == '(');
}

bool ExpressionReader::elements(const Definition& to, const Statement& first,
                                std::vector<Statement>& statements) {
  const std::uint32_t at = open_.line.offset();
  const std::string name = capitals(open_.line.name());
  open_.line.pass(name.size());
  if (!open_.line.take('(')) return open_.wrong(Cause::BracketNotOpened, "( is missing", at);
  const bool read =
      name == "REP" ? repeated(to, first, statements) : set_list(to, first, statements);
  if (!read) return false;
  return open_.line.take(')') ||
         open_.wrong(Cause::BracketNotClosed, ") is missing", open_.line.offset());
}

/// Read the values of SET. Between commas a value may be left out: its element stays as it is.
bool ExpressionReader::set_list(const Definition& to, const Statement& first,
                                std::vector<Statement>& statements) {
  Statement next = first;
  do {
    if (statements.size() > kMostElements)
      return open_.not_computed("a list of so many values", open_.line.offset());
    if (open_.line.peek() != ',' && open_.line.peek() != ')') {
      if (to.reference < 0 && next.number <= 0)
        return open_.wrong(Cause::ArrayElement, "the array ends before the last value",
                           open_.line.offset());
      if (!assigned_value(to, next)) return false;
      statements.push_back(next);
    }
    pass_element(next);
  } while (open_.line.take(','));
  return true;
}

/// Read the value of REP, and how many elements take it: all that follow, or so many.
bool ExpressionReader::repeated(const Definition& to, const Statement& first,
                                std::vector<Statement>& statements) {
  Statement all = first;
  if (!assigned_value(to, all)) return false;
  all.count = 0;  // to the end of the array
  if (open_.line.take(',')) {
    const std::uint32_t at = open_.line.offset();
    Value count;
    if (!value(count)) return false;
    if (count.computed) return open_.not_computed("REP with a computed number of elements", at);
    if (count.number < 1 || (to.reference < 0 && count.number > to.size()))
      return open_.wrong(Cause::ArrayElement, "the array has fewer elements", at);
    all.count = to_whole<std::int32_t>(count.number);
  }
  statements.push_back(all);
  return true;
}

}  // namespace cncsub::sinumerik
