// Jumps and control structures.
#include <algorithm>
#include <charconv>
#include <utility>

#include "cncsub/dialect/sinumerik/open_block.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::sinumerik {

namespace {

/// A jump of a block that has several: its condition, or the value that leads to it.
struct Alternative {
  Statement choice;
  JumpTarget target;
};

struct Structure {
  std::string_view word;
  Link::Kind kind;
  Op op;
  bool condition;
};
constexpr Structure kStructures[] = {{"ELSE", Link::Kind::Else, Op::Else, false},
                                     {"ENDIF", Link::Kind::EndIf, Op::EndIf, false},
                                     {"WHILE", Link::Kind::While, Op::While, true},
                                     {"ENDWHILE", Link::Kind::EndWhile, Op::EndDo, false},
                                     {"LOOP", Link::Kind::Loop, Op::Do, false},
                                     {"ENDLOOP", Link::Kind::EndLoop, Op::EndDo, false},
                                     {"ENDFOR", Link::Kind::EndFor, Op::EndFor, false},
                                     {"UNTIL", Link::Kind::Until, Op::IfGoto, true}};

constexpr std::string_view kOthers[] = {"IF", "FOR", "CASE", "REPEAT", "REPEATB"};
constexpr std::string_view kCalls[] = {"CALL", "PCALL", "EXTCALL", "ISOCALL", "CALLPATH", "SETAL"};

/// Return whether a jump stands in the rest of the block, which opens no structure then.
bool jumps_later(OpenBlock& open) {
  for (char c = open.line.peek(); c != '\0'; c = open.line.peek()) {
    if (c == '"') {
      open.line.pass_quoted();
      continue;
    }
    const std::string_view name = open.line.name();
    if (is_jump(capitals(name))) return true;
    open.line.pass(std::max<std::size_t>(name.size(), 1));
  }
  return false;
}

/// Let a jump know its target, as far as that is known before the whole program is read.
void name_target(Statement& jump, const JumpTarget& target) {
  jump.variable_at = target.at;
  jump.variable_width = target.width;
  if (!target.computed) return;
  using Search = Statement::Search;
  jump.number = -1;
  jump.variable = target.text;
  jump.search = target.direction == 'F'   ? Search::Forward
                : target.direction == 'B' ? Search::Back
                : target.direction == 'C' ? Search::BothOrOn
                                          : Search::Both;
}

/// Read the text of a jump: NAME<<R1, or a variable.
bool text_target(OpenBlock& open, Block& block, JumpTarget& target) {
  Value value;
  Type type = Type::Real;
  if (!open.expression.value_of_any(value, type)) return open.refuse(block);
  target.width = open.line.width_from(target.at);
  if (type != Type::String)
    return open.refuse(block, Cause::TypeMismatch,
                       "a jump goes to a label or to a text that names it", target.at);
  target.computed = value.computed;
  target.text = value.expression;
  if (value.computed) return true;
  const std::string text =
      capitals(trimmed(open.to.code().texts.at(to_whole<std::size_t>(value.number))));
  target.label = text.empty() ? "\"" : text;  // no block has it
  const std::size_t digits = text.starts_with('N') ? 1 : 0;
  const bool number =
      text.size() > digits &&
      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(digits), text.end(), is_digit);
  if (!number) return true;
  target.label.clear();
  std::from_chars(text.data() + digits, text.data() + text.size(), target.number);
  return true;
}

/// Write a block that jumps to the first alternative which applies.
bool write_switch(OpenBlock& open, Block& block, Link& link, Statement choice,
                  std::vector<Alternative>& alternatives) {
  if (!open.end_of_statement(block)) return false;
  for (Alternative& one : alternatives) {
    Block jump = block;
    if (one.target.direction == 'S') {
      open.to.words(jump, {});
    } else {
      Statement statement;
      statement.at = one.choice.at;
      name_target(statement, one.target);
      open.to.become(jump, Op::Goto, statement);
    }
    one.choice.then = open.to.keep(jump);
    if (one.target.direction != 'S') link.alternatives.push_back({one.choice.then, one.target});
  }
  choice.number = static_cast<std::int32_t>(alternatives.size());
  open.to.become(block, Op::Switch, choice);
  for (const Alternative& one : alternatives) open.to.keep(one.choice);
  link.kind = Link::Kind::Switch;
  return true;
}

/// Read GOTOF A after a condition, and IF R1==2 GOTOF B after that: they are tested in order.
/// [NCI jumps: manual 4.1.5.2]
bool condition_jumps(OpenBlock& open, Block& block, Link& link, Statement first) {
  link.kind = Link::Kind::None;
  std::vector<Alternative> all{{first, {}}};
  for (;;) {
    const std::string word = capitals(open.line.name());
    open.line.pass(word.size());
    if (!is_jump(word))
      return open.refuse(block, Cause::IfFormat, "a jump must follow the condition",
                         open.line.offset());
    if (!jump_target(open, block, word, all.back().target)) return false;
    if (capitals(open.line.name()) != "IF") break;
    open.line.pass(2);
    Statement next;
    next.at = open.line.offset();
    if (!open.expression.condition(next.expression)) return open.refuse(block);
    next.width = open.line.width_from(next.at);
    all.push_back({next, {}});
  }
  if (all.size() > 1 || all.front().target.direction == 'S')
    return write_switch(open, block, link, first, all);
  if (!open.end_of_statement(block)) return false;
  link.kind = Link::Kind::Jump;
  link.conditional = true;
  link.target = all.front().target;
  name_target(first, link.target);
  open.to.become(block, Op::IfGoto, first);
  return true;
}

/// Read the condition of an IF, and the jumps that it makes.
bool conditional(OpenBlock& open, Block& block, Link& link) {
  Statement statement;
  statement.at = open.line.offset();
  link.kind = Link::Kind::If;
  if (!open.expression.condition(statement.expression)) {
    if (jumps_later(open)) link.kind = Link::Kind::None;
    return open.refuse(block);
  }
  statement.width = open.line.width_from(statement.at);
  if (is_jump(capitals(open.line.name()))) return condition_jumps(open, block, link, statement);
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, Op::If, statement);
  return true;
}

/// Read GOTOF END, GOTOB N10 or GOTO 10. GOTOS goes on where the PLC does not ask for the beginning
/// of the program. [NCI jumps: manual 4.1.5.1]
bool jump(OpenBlock& open, Block& block, Link& link, std::string_view word, Statement jump) {
  if (!jump_target(open, block, word, link.target) || !open.end_of_statement(block)) return false;
  if (link.target.direction == 'S') {
    open.to.words(block, {});
    return true;
  }
  name_target(jump, link.target);
  link.kind = Link::Kind::Jump;
  open.to.become(block, Op::Goto, jump);
  return true;
}

/// Read 7 GOTOF A, or DEFAULT GOTOF C.
bool one_case(OpenBlock& open, Block& block, Alternative& one) {
  one.choice.at = open.line.offset();
  if (capitals(open.line.name()) == "DEFAULT") {
    one.choice.index = Statement::kAlways;
    open.line.pass(7);
  } else {
    Value value;
    if (!open.expression.value(value)) return open.refuse(block);
    one.choice.expression = open.to.expressions().expression_of(value);
  }
  const std::uint32_t at = open.line.offset();
  const std::string word = capitals(open.line.name());
  open.line.pass(word.size());
  if (!is_jump(word)) return open.refuse(block, Cause::StatementFormat, "a jump is missing", at);
  return jump_target(open, block, word, one.target);
}

/// Read CASE(R1) OF 7 GOTOF A 9 GOTOF B DEFAULT GOTOF C.
bool case_of(OpenBlock& open, Block& block, Link& link, Statement choice) {
  const std::uint32_t at = open.line.offset();
  Value value;
  if (!open.expression.value(value)) return open.refuse(block);
  choice.at = at;
  choice.width = open.line.width_from(at);
  choice.expression = open.to.expressions().expression_of(value);
  choice.index = Statement::kHasValue;
  if (capitals(open.line.name()) != "OF")
    return open.refuse(block, Cause::StatementFormat, "OF is missing: CASE(R1) OF 1 GOTOF A",
                       open.line.offset());
  open.line.pass(2);
  std::vector<Alternative> all;
  do
    if (!one_case(open, block, all.emplace_back())) return false;
  while (!open.line.at_end() && all.back().choice.index != Statement::kAlways);
  return write_switch(open, block, link, choice, all);
}

/// Return the assignment that lets the variable of a FOR, which an instruction reads, go up by 1.
Statement counted_up(OpenBlock& open, const Statement& first, const Instruction& read,
                     std::uint32_t at) {
  Statement next = first;
  open.to.expressions().begin();
  open.to.expressions().emit(read);
  open.to.expressions().emit({Ins::Constant, 0, at, 1});
  open.to.expressions().emit({Ins::Add, 0, at, 0});
  open.to.expressions().emit({Ins::Round, 0, at, 0});
  next.expression = open.to.expressions().end(at, open.line.width_from(at));
  return next;
}

/// Read FOR R1=1 TO 10. A REAL that counts is rounded, and goes up by 1. [general knowledge]
bool count_loop(OpenBlock& open, Block& block, Link& link, Statement loop) {
  const std::uint32_t at = open.line.offset();
  const std::string name = capitals(open.line.name());
  const Definition* const of = open.definitions.find(name);
  const bool parameter = of == nullptr && name.starts_with('R');
  if (of == nullptr && !parameter) {
    open.line.pass(name.size());
    return open.refuse(block, Cause::StatementFormat, "FOR needs a variable: FOR R1=1 TO 10", at);
  }
  Statement first;
  if (of != nullptr ? !open.expression.assignment(*of, first) : !open.expression.assignment(first))
    return open.refuse(block);
  using Target = Statement::Target;
  if (first.target != Target::Local && first.target != Target::Common &&
      first.target != Target::Referenced)
    return open.not_computed(block, "a FOR that counts with a parameter of a computed number", at);
  if (capitals(open.line.name()) != "TO")
    return open.refuse(block, Cause::StatementFormat, "TO is missing: FOR R1=1 TO 10",
                       open.line.offset());
  open.line.pass(2);
  Value last;
  if (!open.expression.value(last)) return open.refuse(block);
  if (!open.end_of_statement(block)) return false;
  if (of == nullptr || of->type == Type::Real)
    first.expression = open.to.expressions().changed(first.expression, Ins::Round);
  double number = 0;
  if (parameter) system::parse(name.substr(1), number);
  const Statement next = counted_up(
      open, first,
      of != nullptr ? reading(*of)
                    : Instruction{Ins::Common, 0, static_cast<std::uint32_t>(first.index), number},
      at);
  loop.expression = open.to.expressions().expression_of(last);
  loop.then = open.to.keep(first);
  loop.number = static_cast<std::int32_t>(open.to.keep(next));
  link.kind = Link::Kind::For;
  open.to.become(block, Op::For, loop);
  return true;
}

}  // namespace

/// Read the rest of a block that begins, parts or ends a structure.
static bool structure_word(OpenBlock& open, Block& block, const Structure& of,
                           Statement& statement) {
  const bool until = of.kind == Link::Kind::Until;
  if (of.condition && !open.expression.condition(statement.expression, until))
    return open.refuse(block);
  if (!open.end_of_statement(block)) return false;
  open.to.become(block, of.op, statement);
  return true;
}

bool statement(OpenBlock& open, Block& block, Link& link, bool& read_it) {
  const std::uint32_t at = open.line.offset();
  const std::string word = capitals(open.line.name());
  const auto* const known = std::find_if(std::begin(kStructures), std::end(kStructures),
                                         [&](const Structure& of) { return of.word == word; });
  const bool structure = known != std::end(kStructures);
  const bool other = is_among(kOthers, word) || is_jump(word) || is_among(kCalls, word);
  if (word == "RET" && trimmed(open.line.rest().substr(3)).starts_with('(')) {
    open.line.pass(3);
    read_it = return_by_values(open, block, at);
    return true;
  }
  if (!structure && !other) return false;
  open.line.pass(word.size());
  Statement statement;
  link.at = statement.at = at;
  link.width = statement.width = open.line.width_from(at);
  if (structure) {
    link.kind = known->kind;
    read_it = structure_word(open, block, *known, statement);
  } else if (is_among(kCalls, word)) {
    read_it = other_call(open, block, link, word, at);
  } else if (word == "IF") {
    read_it = conditional(open, block, link);
  } else if (word == "FOR") {
    link.kind = Link::Kind::For;
    read_it = count_loop(open, block, link, statement);
  } else if (word == "CASE") {
    read_it = case_of(open, block, link, statement);
  } else if (is_jump(word)) {
    read_it = jump(open, block, link, word, statement);
  } else {
    if (word == "REPEATB") link.part_end = Link::PartEnd::Block;
    read_it = repeat(open, block, link, at);
  }
  return true;
}

/// Read a label or a block number.
bool jump_target(OpenBlock& open, Block& block, std::string_view word, JumpTarget& target) {
  target.at = open.line.offset();
  if (word.size() > 4 && word.starts_with("GOTO")) target.direction = word[4];
  if (target.direction == 'S') return true;
  const std::string_view name = open.line.name();
  const bool number =
      is_digit(open.line.peek()) || (open.line.peek() == 'N' && is_digit(open.line.ahead(1)));
  if (number) {
    open.line.take('N');
    const std::string_view digits = open.line.take_digits();
    std::from_chars(digits.data(), digits.data() + digits.size(), target.number);
  } else if (open.line.peek() == '"') {
    return text_target(open, block, target);
  } else if (name.size() > 1) {
    target.label = capitals(name);
    const Definition* const of = open.definitions.find(target.label);
    if (of != nullptr && of->type == Type::String) return text_target(open, block, target);
    open.line.pass(name.size());
  } else {
    open.line.pass(name.size());
    return open.refuse(block, Cause::StatementFormat,
                       "the jump has neither a label nor a block number", target.at);
  }
  target.width = open.line.width_from(target.at);
  return true;
}

}  // namespace cncsub::sinumerik
