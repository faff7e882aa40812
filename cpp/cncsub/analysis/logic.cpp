// Finds AND, OR and XOR whose precedence is not what it looks.
#include <span>
#include <string>
#include <string_view>

#include "cncsub/analysis/brackets.hpp"
#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// The mixtures to report: logic beside another operation, or AND beside OR where both have the
/// same precedence.
enum class Asked : std::uint8_t { Nothing, OtherOperations, OtherLogic, Both };

/// Return which mixtures to report. Logic of numbers may stand beside arithmetic, and AND may have
/// the precedence of OR.
Asked asked_of(std::span<const OperatorRow> rows) {
  bool numbers = false;
  int conjunction = 0, disjunction = 0;
  for (const OperatorRow& of : rows) {
    if (!of.is_logic()) continue;
    numbers = numbers || of.op == Ins::And;
    (of.is_conjunction() ? conjunction : disjunction) = of.level;
  }
  const bool alike = conjunction == disjunction;
  if (numbers) return alike ? Asked::Both : Asked::OtherOperations;
  return alike ? Asked::OtherLogic : Asked::Nothing;
}

class LogicCheck {
 public:
  explicit LogicCheck(Checker& c)
      : c_(c),
        order_(c.code.control->macros.logic_order.value),
        asked_(asked_of(c.code.spelling->operators(order_))) {}
  bool asks() const { return asked_ != Asked::Nothing; }
  void block(Address at, const Block& block, std::string_view text);

 private:
  bool is_statement(const Block& block) const;
  bool of_numbers(const Expression& of) const;
  bool of_conditions(const Expression& of) const;
  bool is_mixed(std::string_view text, Asked asked) const;
  void mend(Finding& found, Address at, std::string_view written, LogicOrder order) const;
  void brackets(Address at, std::string_view text, std::uint32_t first);
  void tell_word(Address at, TextPlace place, std::string_view written);
  void tell(Address at, TextPlace place, const Expression& of, std::string_view written,
            Asked asked);
  const char* read_as(Asked asked) const;

  Checker& c_;
  LogicOrder order_;
  Asked asked_;
};

/// Return whether a logic operation stands beside another one in the same brackets.
bool LogicCheck::is_mixed(std::string_view text, Asked asked) const {
  const WrittenLogic found = read_logic(text, *c_.code.spelling, order_);
  return (asked != Asked::OtherLogic && found.beside_other) ||
         (asked != Asked::OtherOperations && found.and_after_or);
}

const char* LogicCheck::read_as(Asked asked) const {
  if (asked == Asked::OtherLogic) return "this control takes AND, OR and XOR from left to right";
  switch (order_) {
    case LogicOrder::Last:
      return "on this control AND, OR and XOR come after comparisons and arithmetic";
    case LogicOrder::LastOfConditions:
      return "on this control AND, OR and XOR of conditions come last, those of numbers rank like "
             "* and +";
    default:
      return "on this control AND ranks like *, OR and XOR like +, before any comparison";
  }
}

bool LogicCheck::is_statement(const Block& block) const {
  switch (block.op) {
    case Op::Set:
    case Op::Assign:
    case Op::IfGoto:
    case Op::IfThen:
    case Op::If:
    case Op::While:
      return true;
    default:
      return false;
  }
}

/// Return whether an expression has logic of numbers, which may be meant as logic of conditions.
bool LogicCheck::of_numbers(const Expression& of) const {
  for (const Instruction ins : of)
    if (ins.op == Ins::And || ins.op == Ins::Or || ins.op == Ins::Xor) return true;
  return false;
}

bool LogicCheck::of_conditions(const Expression& of) const {
  for (const Instruction ins : of)
    if (ins.op == Ins::BothTrue || ins.op == Ins::OneTrue || ins.op == Ins::EitherTrue) return true;
  return false;
}

/// Offer the brackets that show the order in which the control evaluates the text.
void LogicCheck::mend(Finding& found, Address at, std::string_view written,
                      LogicOrder order) const {
  const Control& control = *c_.code.control;
  // The brackets around the expression count too.
  const std::string text =
      read_logic(written, *c_.code.spelling, order, asked_ != Asked::OtherOperations,
                 control.macros.max_brackets.value - 1)
          .bracketed;
  if (text.empty()) return;
  const int most = control.reading.max_block_length.value;
  const std::size_t length = c_.code.blocks[at].length + text.size() - written.size();
  if (most > 0 && length > static_cast<std::size_t>(most)) return;
  found.edits.push_back({at, found.place, text});
}

/// Check the expressions in brackets of a block of words, of a call or of a label.
void LogicCheck::brackets(Address at, std::string_view text, std::uint32_t first) {
  std::size_t depth = 0, from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == ';') return;  // a comment
    if (text[i] == '[' && depth == 0) from = i;
    if (text[i] == '[') ++depth;
    if (text[i] != ']' || depth == 0) continue;
    --depth;
    if (depth > 0) continue;
    const std::string_view inside = text.substr(from + 1, i - from - 1);
    if (!is_mixed(inside, asked_)) continue;
    const auto width = static_cast<std::uint32_t>(i - from + 1);
    return tell_word(at, {static_cast<std::uint32_t>(first + from), width},
                     text.substr(from, width));
  }
}

void LogicCheck::tell_word(Address at, TextPlace place, std::string_view written) {
  Finding& found = c_.found(Check::LogicOrder, at, place, read_as(asked_));
  if (asked_ == Asked::OtherLogic || order_ != LogicOrder::LastOfConditions)
    mend(found, at, written, order_);
}

void LogicCheck::tell(Address at, TextPlace place, const Expression& of, std::string_view written,
                      Asked asked) {
  Finding& found = c_.found(Check::LogicOrder, at, place, read_as(asked));
  const bool conditions = of_conditions(of), numbers = of_numbers(of);
  if (asked_ == Asked::OtherLogic || order_ != LogicOrder::LastOfConditions)
    return mend(found, at, written, order_);
  if (conditions != numbers)
    mend(found, at, written, numbers ? LogicOrder::LikeArithmetic : LogicOrder::Last);
}

void LogicCheck::block(Address at, const Block& block, std::string_view text) {
  const bool extra =
      (block.flags & Block::kHasExtra) != 0 && c_.code.cells[block.data].extra.expressions != 0;
  if (!is_statement(block)) {
    if (block.op == Op::Fault || (block.op <= Op::Arc && !extra)) return;
    return brackets(at, std::string_view(text).substr(block.text, block.length), block.text);
  }
  const bool set = block.op == Op::Set;
  const Expression of =
      c_.code.expression(set ? block.aux : c_.code.statements[block.aux].expression);
  if (!of_numbers(of) && !of_conditions(of)) return;
  const std::uint32_t first = of.at();
  const std::string_view written = std::string_view(text).substr(first, of.width());
  // Comparisons are done before logic joins them, as it looks. Only AND beside OR may mislead.
  const bool numbers = asked_ == Asked::OtherLogic || of_numbers(of);
  const Asked asked = numbers ? asked_ : asked_ == Asked::Both ? Asked::OtherLogic : Asked::Nothing;
  if (asked != Asked::Nothing && is_mixed(written, asked))
    tell(at, {first, of.width()}, of, written, asked);
}

}  // namespace

void check_logic(Checker& c) {
  LogicCheck logic(c);
  if (!logic.asks()) return;
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    const std::string_view text = c.code.files[c.program(flow.program()).file].text.view();
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
      each_variant(c.code, c.code.blocks[at],
                   [&](const Block& block) { logic.block(at, block, text); });
  }
}

}  // namespace cncsub
