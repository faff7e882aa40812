// Statements that print, and SETVN, which names variables.
#include "cncsub/dialect/iso/statement.hpp"

namespace cncsub {

void StatementReader::print(const Keyword& keyword, Statement& /*statement*/) {
  Print print;
  print.binary = keyword.kind == StatementKind::Bprnt;
  print.at = s_.offset();
  if (!s_.take('['))
    return refuse(Cause::OutputFormat, s_.offset(), 1,
                  "what is written must be in brackets, as in DPRNT[...]");
  while (s_.peek() != ']') {
    if (s_.peek() == '\0')
      return refuse(Cause::OutputFormat, s_.offset(), 1, "the bracket of the output is not closed");
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
  to_.become(block_, Op::Print, std::move(print));
}

/// Read a field such as `#100[53]`: five digits before the point, three after it.
bool StatementReader::print_field(Print& print) {
  PrintField field;
  field.is_variable = true;
  const auto value = expressions_.word_value(s_, '\0');
  if (!value) {
    refuse(expressions_.fault());
    return false;
  }
  field.expression = *value;
  const std::uint32_t at = s_.offset();
  if (!s_.take('[')) {
    refuse(Cause::OutputFormat, at, 1, "the number of digits must follow the variable, as [53]");
    return false;
  }
  const Number format = scan_number(s_);
  const bool good =
      format.written == (print.binary ? 1 : 2) && !format.negative && format.points == 0;
  if (!good || !s_.take(']')) {
    refuse(Cause::OutputFormat, at, 1,
           "the number of digits must be two digits in brackets, as [53]");
    return false;
  }
  const int digits = to_whole<int>(format.value);
  field.whole_digits = print.binary ? 0 : digits / 10;
  field.decimals = digits % 10;
  print.fields.push_back(field);
  return true;
}

/// Read SETVN 510[TOOLNO, WORKNO].
void StatementReader::name_variables(const Keyword& /*keyword*/, Statement& statement) {
  if (!code_.control->macros.variable_forms.value.has(VariableForm::Names))
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
                    "a variable name must be a letter, then letters, digits and _");
    to_.names().text(name);
    if (s_.take(']')) break;
    if (!s_.take(','))
      return refuse(Cause::SetvnFormat, s_.offset(), 1, "the list of names is not closed");
  }
  statement.variable_width =
      static_cast<std::uint32_t>(code_.names.size()) - static_cast<std::uint32_t>(statement.index);
  if (at_end(Cause::NcAndMacroInBlock)) to_.become(block_, Op::NameVariables, statement);
}

}  // namespace cncsub
