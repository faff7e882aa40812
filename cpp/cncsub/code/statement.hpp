// Macro statements: assignments, jumps, branches, loops, and what is printed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/expression.hpp"
#include "cncsub/code/fault.hpp"

namespace cncsub {

struct Statement {
  std::uint32_t expression = 0;  // the condition, or the value to assign, or the jump's number
  std::uint32_t variable =
      0;  // Assign: an expression that gives the variable's number, when target is Indirect
  enum class Target : std::uint8_t {
    None,
    Local,
    Common,
    Variable,
    Indirect,
    Element,       // of an array: `variable` gives its place from `index` on, of `number` elements;
    CommonElement  // `count` elements from it on take the value, 0: all
  } target = Target::None;
  std::int32_t index = 0;   // Local, Common: the place; Variable: the number
  Address to = kNowhere;    // where a jump goes, when known
  Address end = kNowhere;   // Do, While: the address of the END; a jump: another block of its label
  std::int32_t number = 0;  // DO m, GOTO n, Hm of G65
  std::int32_t count = 1;
  std::uint32_t at = 0, width = 1;
  std::uint32_t variable_at = 0, variable_width = 1;
  std::uint32_t text = 0, text_length = 0;  // the comment of #3000 and #3006
  std::uint32_t then = 0;                   // IfThen: the variant block to execute
};

/// G65 Hm Pn Qn Rn.
struct HCode : Statement {
  Operand p, q, r;
};

struct PrintField {
  static constexpr int kPlain = -1;  // of whole_digits: as many as there are, and no blanks

  bool is_variable = false;
  std::string text;
  std::uint32_t expression = 0;
  int whole_digits = 0;
  int decimals = 0;
  bool is_text = false;  // the value is a text
};

struct Print {
  bool binary = false;
  bool alarms = false;         // the text is that of an alarm
  std::string number{};        // the number of the alarm; empty: that of the control
  std::string_view command{};  // the word of the comment that says it, where that is no message
  bool logs() const { return command.starts_with("LOG"); }
  std::vector<PrintField> fields;
  std::int32_t shown_if = 0;  // the variable that must be above 0, or nothing is said; 0: none
  std::uint32_t at = 0;
};

}  // namespace cncsub
