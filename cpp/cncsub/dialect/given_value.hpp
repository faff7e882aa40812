// The words of languages in which = may stand between an address and an expression.
#pragma once

#include <string_view>

#include "cncsub/system/decimal.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {

/// Pass over a number with its sign, and give the word its value. `Line` reads a block from left to
/// right.
template <class Line>
void pass_number(Line& line, WrittenWord& word) {
  const bool negative = line.peek() == '-';
  if (negative || line.peek() == '+') line.pass(1);
  line.peek();
  const auto text = line.take_number();
  double number = 0;
  word.known = !text.empty() && system::parse(text, number).length == text.size();
  word.value = negative ? -number : number;
}

/// Pass over an expression: operands as long as operators stand between them, which are one of
/// these signs or a name.
template <class Line, class PassOperand, class IsOperator>
void pass_operands(Line& line, std::string_view signs, const PassOperand& pass_operand,
                   const IsOperator& is_operator) {
  for (;;) {
    pass_operand(line);
    const char c = line.peek();
    if (is_operator(line.name()))
      line.pass(line.name().size());
    else if (c != '\0' && signs.find(c) != std::string_view::npos)
      line.pass(1);
    else
      return;
  }
}

/// Pass over what is given after =: a number, which the word then has, or an expression.
template <class Line, class PassExpression>
void pass_given(Line& line, WrittenWord& word, const PassExpression& pass_expression) {
  line.peek();
  Line number = line;
  pass_number(number, word);
  pass_expression(line);
  line.peek();
  number.peek();
  word.known = word.known && line.rest().size() == number.rest().size();
}

}  // namespace cncsub
