// Variables that a program defines, in expressions and assignments.
#include <cmath>

#include "cncsub/dialect/sinumerik/expression.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr double kLastCharacter = 255;  // [840Df p.63, types]

/// Return the mark of a variable among what a block has assigned to.
std::int32_t mark_of(const Definition& of) { return -1 - of.local; }

}  // namespace

bool ExpressionReader::value_of(Type type, Value& value) {
  const std::uint32_t at = line_.offset();
  if (type == Type::Char && line_.peek() == '"' && line_.ahead(2) == '"') {
    value = {false, static_cast<double>(static_cast<unsigned char>(line_.rest()[1])), 0, at, 3};
    line_.pass_quoted();
    return true;
  }
  to_.expressions().begin();
  if (!read(0)) return false;
  convert(type);
  const double code = constant_.value_or(0);
  if (type == Type::Char && (code < 0 || code > kLastCharacter))
    return wrong(Cause::ValueOutOfRange, "a CHAR is 0 to 255", at);
  return finish(value, at);
}

/// A fraction of a half and more is rounded up; what is not 0 is TRUE. [840Da p.45, conversions]
void ExpressionReader::convert(Type type) {
  if (type == Type::Bool) {
    if (constant_) constant_ = *constant_ != 0 ? 1 : 0;
    emit(Ins::Constant, 0);
    emit(Ins::NotEqual);
  } else if (type != Type::Real) {
    if (constant_) constant_ = std::round(*constant_);
    emit(Ins::Round);
  }
}

void ExpressionReader::push(const Definition& of) {
  constant_.reset();
  to_.expressions().emit({Ins::Local, 0, static_cast<std::uint32_t>(of.local), 0});
}

Statement ExpressionReader::variable_alone() {
  Statement found;
  found.variable_at = line_.offset();
  const std::string_view written = line_.name();
  std::size_t end = written.size();
  while (end < line_.rest().size() && is_blank(line_.ahead(end))) ++end;
  if (written.empty() || (line_.ahead(end) != ',' && line_.ahead(end) != ')')) return found;
  const std::string name = capitals(written);
  found.variable_width = static_cast<std::uint32_t>(name.size());
  VariablePlace place;
  std::int32_t number = 0;
  if (const Definition* const of = definitions_.find(name)) {
    found.target = Statement::Target::Local;
    found.index = of->local;
  } else if (name[0] == 'R' && parameter_number(name.substr(1), 0, place, number)) {
    found.target = Statement::Target::Common;
    found.index = place.index;
  }
  fault.reset();
  return found;
}

bool ExpressionReader::read_variable(const Definition& of, std::string_view name) {
  const std::uint32_t at = line_.offset();
  line_.pass(name.size());
  if (const char* const what = of.uncomputed())
    return wrong(Cause::CodeNotComputed, std::string(name) + ", " + what + ", is not computed here",
                 at);
  push(of);
  return !assigned_.contains(mark_of(of)) || late(at);
}

bool ExpressionReader::late(std::uint32_t at) {
  return wrong(Cause::CodeNotComputed, "a variable that its own block assigns is not computed here",
               at);
}

bool ExpressionReader::assignment(const Definition& to, Statement& statement) {
  const std::string_view name = line_.name();
  const std::uint32_t at = statement.variable_at = line_.offset();
  line_.pass(name.size());
  statement.variable_width = line_.width_from(at);
  if (const char* const what = to.uncomputed())
    return wrong(Cause::CodeNotComputed, capitals(name) + ", " + what + ", is not computed here",
                 at);
  if (!line_.take('='))
    return wrong(Cause::MissingEquals, "the variable stands alone: write a value after =", at);
  statement.target = Statement::Target::Local;
  statement.index = to.local;
  if (!assigned_value(to.type, statement)) return false;
  assigned_.insert(mark_of(to));
  return true;
}

/// Read the value of an assignment.
bool ExpressionReader::assigned_value(Type type, Statement& statement) {
  Value assigned;
  if (!value_of(type, assigned)) return false;
  statement.expression = to_.expressions().expression_of(assigned);
  statement.at = assigned.at;
  statement.width = assigned.width;
  return true;
}

}  // namespace cncsub::sinumerik
