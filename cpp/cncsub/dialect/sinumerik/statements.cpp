// Jumps and control structures.
#include <algorithm>
#include <charconv>
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::sinumerik {

namespace {

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

constexpr std::string_view kJumps[] = {"GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS"};
constexpr std::string_view kOthers[] = {"IF", "FOR", "CASE", "REPEAT", "REPEATB"};
constexpr std::string_view kCalls[] = {"CALL", "PCALL", "EXTCALL", "ISOCALL", "SETAL"};

template <class List>
bool is_in(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool is_jump(std::string_view word) { return is_in(kJumps, word); }

}  // namespace

bool BlockReader::statement(Block& block, Link& link, bool& read_it) {
  const std::uint32_t at = line_.offset();
  const std::string word = capitals(line_.name());
  const auto* const known = std::find_if(std::begin(kStructures), std::end(kStructures),
                                         [&](const Structure& of) { return of.word == word; });
  const bool structure = known != std::end(kStructures);
  const bool other = is_in(kOthers, word) || is_jump(word) || is_in(kCalls, word);
  if (word == "RET" && trimmed(line_.rest().substr(3)).starts_with('(')) {
    line_.pass(3);
    read_it = return_by_values(block, at);
    return true;
  }
  if (!structure && !other) return false;
  line_.pass(word.size());
  Statement statement;
  statement.at = at;
  statement.width = line_.width_from(at);
  if (structure) {
    link.kind = known->kind;
    const bool until = known->kind == Link::Kind::Until;
    read_it =
        !known->condition || expression_.condition(statement.expression, until) || refuse(block);
    read_it = read_it && end_of_statement(block);
    if (read_it) to_.become(block, known->op, statement);
  } else if (is_in(kCalls, word)) {
    read_it = other_call(block, link, word, at);
  } else if (word == "IF") {
    read_it = conditional(block, link);
  } else if (word == "FOR") {
    link.kind = Link::Kind::For;
    read_it = count_loop(block, link, statement);
  } else if (word == "CASE") {
    read_it = case_of(block, link, statement);
  } else if (is_jump(word)) {
    read_it = jump(block, link, word, statement);
  } else {
    if (word == "REPEATB") link.part_end = Link::PartEnd::Block;
    read_it = repeat(block, link, at);
  }
  return true;
}

/// Return whether a jump stands in the rest of the block, which opens no structure then.
bool BlockReader::jumps_later() {
  for (char c = line_.peek(); c != '\0'; c = line_.peek()) {
    if (c == '"') {
      line_.pass_quoted();
      continue;
    }
    const std::string_view name = line_.name();
    if (is_jump(capitals(name))) return true;
    line_.pass(std::max<std::size_t>(name.size(), 1));
  }
  return false;
}

/// Read the condition of an IF, and the jumps that it makes.
bool BlockReader::conditional(Block& block, Link& link) {
  Statement statement;
  statement.at = line_.offset();
  link.kind = Link::Kind::If;
  if (!expression_.condition(statement.expression)) {
    if (jumps_later()) link.kind = Link::Kind::None;
    return refuse(block);
  }
  statement.width = line_.width_from(statement.at);
  if (is_jump(capitals(line_.name()))) return condition_jumps(block, link, statement);
  if (!end_of_statement(block)) return false;
  to_.become(block, Op::If, statement);
  return true;
}

/// Read GOTOF A after a condition, and IF R1==2 GOTOF B after that: they are tested in order.
/// [NCI jumps: manual 4.1.5.2]
bool BlockReader::condition_jumps(Block& block, Link& link, Statement first) {
  link.kind = Link::Kind::None;
  std::vector<Alternative> all{{first, {}}};
  for (;;) {
    const std::string word = capitals(line_.name());
    line_.pass(word.size());
    if (!is_jump(word))
      return refuse(block, Cause::IfFormat, "a jump must follow the condition", line_.offset());
    if (!jump_target(block, word, all.back().target)) return false;
    if (capitals(line_.name()) != "IF") break;
    line_.pass(2);
    Statement next;
    next.at = line_.offset();
    if (!expression_.condition(next.expression)) return refuse(block);
    next.width = line_.width_from(next.at);
    all.push_back({next, {}});
  }
  if (all.size() > 1 || all.front().target.direction == 'S')
    return write_switch(block, link, first, all);
  if (!end_of_statement(block)) return false;
  link.kind = Link::Kind::Jump;
  link.conditional = true;
  link.target = all.front().target;
  first.variable_at = link.target.at;
  first.variable_width = link.target.width;
  to_.become(block, Op::IfGoto, first);
  return true;
}

/// Read GOTOF END, GOTOB N10 or GOTO 10. GOTOS goes on where the PLC does not ask for the beginning
/// of the program. [NCI jumps: manual 4.1.5.1]
bool BlockReader::jump(Block& block, Link& link, std::string_view word, Statement jump) {
  if (!jump_target(block, word, link.target) || !end_of_statement(block)) return false;
  if (link.target.direction == 'S') {
    to_.words(block, {});
    return true;
  }
  jump.variable_at = link.target.at;
  jump.variable_width = link.target.width;
  link.kind = Link::Kind::Jump;
  to_.become(block, Op::Goto, jump);
  return true;
}

/// Read a label or a block number.
bool BlockReader::jump_target(Block& block, std::string_view word, JumpTarget& target) {
  target.at = line_.offset();
  if (word.size() > 4 && word.starts_with("GOTO")) target.direction = word[4];
  if (target.direction == 'S') return true;
  const std::string_view name = line_.name();
  const bool number = is_digit(line_.peek()) || (line_.peek() == 'N' && is_digit(line_.ahead(1)));
  if (number) {
    line_.take('N');
    const std::string_view digits = line_.take_digits();
    std::from_chars(digits.data(), digits.data() + digits.size(), target.number);
  } else if (line_.peek() == '"') {
    std::string text;
    if (!text_here(block, text)) return false;
    target.label = capitals(text);
  } else if (name.size() > 1) {
    target.label = capitals(name);
    line_.pass(name.size());
    if (definitions_.find(target.label) != nullptr)
      return not_computed(block, "a jump to what a text names", target.at);
  } else {
    line_.pass(name.size());
    return refuse(block, Cause::StatementFormat, "the jump has neither a label nor a block number",
                  target.at);
  }
  target.width = line_.width_from(target.at);
  return true;
}

// ---- several jumps in a block ----

/// Read CASE(R1) OF 7 GOTOF A 9 GOTOF B DEFAULT GOTOF C.
bool BlockReader::case_of(Block& block, Link& link, Statement choice) {
  const std::uint32_t at = line_.offset();
  Value value;
  if (!expression_.value(value)) return refuse(block);
  choice.at = at;
  choice.width = line_.width_from(at);
  choice.expression = to_.expressions().expression_of(value);
  choice.index = Statement::kHasValue;
  if (capitals(line_.name()) != "OF")
    return refuse(block, Cause::StatementFormat, "OF is missing: CASE(R1) OF 1 GOTOF A",
                  line_.offset());
  line_.pass(2);
  std::vector<Alternative> all;
  do
    if (!one_case(block, all.emplace_back())) return false;
  while (!line_.at_end() && all.back().choice.index != Statement::kAlways);
  return write_switch(block, link, choice, all);
}

bool BlockReader::one_case(Block& block, Alternative& one) {
  one.choice.at = line_.offset();
  if (capitals(line_.name()) == "DEFAULT") {
    one.choice.index = Statement::kAlways;
    line_.pass(7);
  } else {
    Value value;
    if (!expression_.value(value)) return refuse(block);
    one.choice.expression = to_.expressions().expression_of(value);
  }
  const std::uint32_t at = line_.offset();
  const std::string word = capitals(line_.name());
  line_.pass(word.size());
  if (!is_jump(word)) return refuse(block, Cause::StatementFormat, "a jump is missing", at);
  return jump_target(block, word, one.target);
}

/// Write a block that jumps to the first alternative which applies.
bool BlockReader::write_switch(Block& block, Link& link, Statement choice,
                               std::vector<Alternative>& alternatives) {
  if (!end_of_statement(block)) return false;
  for (Alternative& one : alternatives) {
    Block jump = block;
    if (one.target.direction == 'S') {
      to_.words(jump, {});
    } else {
      Statement statement;
      statement.at = one.choice.at;
      statement.variable_at = one.target.at;
      statement.variable_width = one.target.width;
      to_.become(jump, Op::Goto, statement);
    }
    one.choice.then = to_.keep(jump);
    if (one.target.direction != 'S') link.alternatives.push_back({one.choice.then, one.target});
  }
  choice.number = static_cast<std::int32_t>(alternatives.size());
  to_.become(block, Op::Switch, choice);
  for (const Alternative& one : alternatives) to_.keep(one.choice);
  link.kind = Link::Kind::Switch;
  return true;
}

// ---- FOR ----

/// Read FOR R1=1 TO 10. A REAL that counts is rounded, and goes up by 1. [general knowledge]
bool BlockReader::count_loop(Block& block, Link& link, Statement loop) {
  const std::uint32_t at = line_.offset();
  const std::string name = capitals(line_.name());
  const Definition* const of = definitions_.find(name);
  const bool parameter = of == nullptr && name.starts_with('R');
  if (of == nullptr && !parameter) {
    line_.pass(name.size());
    return refuse(block, Cause::StatementFormat, "FOR needs a variable: FOR R1=1 TO 10", at);
  }
  Statement first;
  if (of != nullptr ? !expression_.assignment(*of, first) : !expression_.assignment(first))
    return refuse(block);
  if (first.target != Statement::Target::Local && first.target != Statement::Target::Common)
    return not_computed(block, "a FOR that counts with a parameter of a computed number", at);
  if (capitals(line_.name()) != "TO")
    return refuse(block, Cause::StatementFormat, "TO is missing: FOR R1=1 TO 10", line_.offset());
  line_.pass(2);
  Value last;
  if (!expression_.value(last)) return refuse(block);
  if (!end_of_statement(block)) return false;
  if (of == nullptr || of->type == Type::Real)
    first.expression = to_.expressions().changed(first.expression, Ins::Round);
  Statement next = first;
  const bool local = first.target == Statement::Target::Local;
  double number = 0;
  if (parameter) system::parse(name.substr(1), number);
  to_.expressions().begin();
  to_.expressions().emit({local ? Ins::Local : Ins::Common, 0,
                          static_cast<std::uint32_t>(first.index), local ? 0 : number});
  to_.expressions().emit({Ins::Constant, 0, at, 1});
  to_.expressions().emit({Ins::Add, 0, at, 0});
  to_.expressions().emit({Ins::Round, 0, at, 0});
  next.expression = to_.expressions().end(at, line_.width_from(at));
  loop.expression = to_.expressions().expression_of(last);
  loop.then = to_.keep(first);
  loop.number = static_cast<std::int32_t>(to_.keep(next));
  link.kind = Link::Kind::For;
  to_.become(block, Op::For, loop);
  return true;
}

bool BlockReader::end_of_statement(Block& block) {
  if (line_.at_end()) return true;
  const std::uint32_t at = line_.offset();
  line_.pass(first_character(line_.rest()).size());
  return refuse(block, Cause::StatementFormat, "nothing can follow the statement in its block", at);
}

}  // namespace cncsub::sinumerik
