// Macro statements: assignments, jumps, branches, loops, and what is printed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/expression.hpp"
#include "cncsub/code/fault.hpp"

namespace cncsub {

struct Statement {
  // The condition, or the value to assign, or the jump's number; For: the last value; Switch: the
  // value that an alternative must be, where it has one.
  std::uint32_t expression = 0;
  std::uint32_t variable =
      0;  // Assign: an expression that gives the variable's number, when target is Indirect
  enum class Target : std::uint8_t {
    None,
    Local,
    Common,
    Variable,
    Indirect,
    Element,  // of an array: `variable` gives its place from `index` on, of `number` elements;
    CommonElement,  // `count` elements from it on take the value, 0: all
    // The same of what a parameter stands for: `index` is the local that holds it, see Reference,
    // and the one after it how many elements it has.
    ReferencedElement,
    Referenced,  // the variable that a parameter stands for; `number`: the local that counts where
                 // a call gave none
    VariableAt   // the variable of the index that `variable` gives; `index`: that of index 0
  } target = Target::None;
  std::int32_t index = 0;  // Local, Common: the place; Variable: the number; see kAlways, kHasValue
  Address to = kNowhere;   // where a jump goes, when known
  // Do, While, For: the address of the END; a jump: another block of its label.
  Address end = kNowhere;
  std::int32_t number = 0;  // DO m, GOTO n, Hm of G65; Switch: how many alternatives follow it
  std::int32_t count = 1;
  std::uint32_t at = 0, width = 1;
  std::uint32_t variable_at = 0, variable_width = 1;
  std::uint32_t text = 0, text_length = 0;  // the comment of #3000 and #3006
  // IfThen, an alternative: the variant block to execute. For, EndFor: the assignment, a statement.
  std::uint32_t then = 0;

  /// Where a jump to a label looks for it whose name is a text that is computed: the value of
  /// `variable`.
  enum class Search : std::uint8_t { None, Forward, Back, Both, BothOrOn } search = Search::None;

  /// Return whether the target is an element of an array, whose place `variable` gives.
  bool is_element() const {
    return target >= Target::Element && target <= Target::ReferencedElement;
  }
  /// Return whether `variable` is an expression that says which variable is meant.
  bool is_computed() const { return target == Target::Indirect || is_element(); }

  static constexpr std::int32_t kAlways = 1;    // `index` of an alternative without a condition
  static constexpr std::int32_t kHasValue = 1;  // `index` of a Switch whose alternatives are values
};

/// Return the alternatives of a Switch, which follow it in Code::statements.
inline std::span<const Statement> alternatives_of(const Statement& choice) {
  return {&choice + 1, static_cast<std::size_t>(choice.number)};
}

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
  std::string_view command{};  // the word of the comment that says it, where that is no message
  bool logs() const { return command.starts_with("LOG"); }
  std::vector<PrintField> fields;
  std::int32_t shown_if = 0;  // the variable that must be above 0, or nothing is said; 0: none
  // Of an alarm with a number: the expression that gives it, and the numbers that it may be.
  std::uint32_t number = 0;
  std::int32_t first_number = 0, last_number = 0;  // 0: it has none
  std::uint32_t at = 0;
};

}  // namespace cncsub
