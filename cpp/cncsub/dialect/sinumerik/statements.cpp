// Calls, jumps and control structures.
#include <algorithm>
#include <charconv>
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"

namespace cncsub::sinumerik {

namespace {

Operand operand_of(const Value& value) {
  Operand operand;
  operand.kind = value.computed ? Operand::Kind::Expression : Operand::Kind::Constant;
  operand.value = value.number;
  operand.expression = value.expression;
  operand.at = value.at;
  operand.width = value.width;
  return operand;
}

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
                                     {"UNTIL", Link::Kind::Until, Op::IfGoto, true}};

constexpr std::string_view kJumps[] = {"GOTO", "GOTOF", "GOTOB", "GOTOC"};

bool is_jump(std::string_view word) {
  return std::find(std::begin(kJumps), std::end(kJumps), word) != std::end(kJumps);
}

/// Return a program's name without what the control puts around it: _N_SUB_SPF is SUB. [828D p.490]
std::string_view bare(std::string_view name) {
  const std::string capital = capitals(name);
  const std::size_t before = capital.starts_with("_N_") ? 3 : 0;
  const bool ending = capital.ends_with("_SPF") || capital.ends_with("_MPF");
  const std::size_t around = before + (ending ? 4 : 0);
  return name.size() > around ? name.substr(before, name.size() - around) : name;
}

}  // namespace

// ---- calls ----

/// Read L100, SUB or SUB(), and a P with the count.
bool BlockReader::call(Block& block, Words& words, std::string_view name) {
  const std::uint32_t at = line_.offset();
  line_.pass(name.size());
  CallRecord call;
  call.kind = CallKind::Named;
  call.at = at;
  call.width = line_.width_from(at);
  CallExtras& named = call.extras.make();
  named.name_at = call.at;
  named.name_width = call.width;
  named.name = std::string(bare(name));
  named.count = 'P';
  if (words.call) return refuse(block, Cause::CallGivenTwice, "a second call", at);
  if (name.size() == 1) return refuse(block, Cause::AddressWithoutValue, "L without a number", at);
  if (line_.take('(') && !given_values(block, named.given)) return false;
  if (line_.peek() == 'P' && line_.name().size() > 1 && !is_digit(line_.name()[1])) {
    words.call = std::move(call);
    return true;  // another name, which is read next
  }
  if (line_.peek() == 'P') {
    const std::uint32_t word = line_.offset();
    line_.pass(1);
    Value value;
    if (line_.take('=') ? !expression_.value(value) : !expression_.number(value))
      return refuse(block);
    value.at = word;
    value.width = line_.width_from(word);
    call.l = operand_of(value);
  }
  words.call = std::move(call);
  return true;
}

/// Read the values of a call up to the closing bracket. A value may be left out between its commas.
bool BlockReader::given_values(Block& block, std::vector<ActualParameter>& given) {
  while (!line_.take(')')) {
    ActualParameter& one = given.emplace_back();
    one.operand.at = line_.offset();
    if (line_.peek() != ',') {
      one.variable = expression_.variable_alone();
      Value value;
      if (!expression_.value_or_text(value, one.is_text)) return refuse(block);
      one.operand = operand_of(value);
    }
    if (line_.peek() != ')' && !line_.take(','))
      return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  }
  return true;
}

/// Write a call, which has a block of its own.
bool BlockReader::write_call(Block& block, const Words& words, CallRecord call) {
  const bool alone = !words.any && words.statements.empty() && !words.print && !words.back;
  if (!alone)
    return refuse(block, Cause::IllegalWordWithCall, "a call must be alone in its block", call.at);
  to_.become(block, Op::Call, std::move(call));
  return true;
}

// ---- statements ----

bool BlockReader::statement(Block& block, Link& link, bool& read_it) {
  const std::uint32_t at = line_.offset();
  const std::string word = capitals(line_.name());
  const auto* const known = std::find_if(std::begin(kStructures), std::end(kStructures),
                                         [&](const Structure& of) { return of.word == word; });
  const bool structure = known != std::end(kStructures);
  if (!structure && word != "IF" && word != "REPEAT" && !is_jump(word)) return false;
  line_.pass(word.size());
  Statement statement;
  statement.at = at;
  statement.width = line_.width_from(at);
  if (word == "IF") {
    read_it = conditional(block, link);
  } else if (word == "REPEAT") {
    read_it = line_.at_end() || not_computed(block, "REPEAT of a part of the program", at);
    link.kind = read_it ? Link::Kind::Repeat : Link::Kind::None;
  } else if (is_jump(word)) {
    read_it = jump(block, link, word, statement);
  } else {
    link.kind = known->kind;
    const bool until = known->kind == Link::Kind::Until;
    read_it =
        !known->condition || expression_.condition(statement.expression, until) || refuse(block);
    read_it = read_it && end_of_statement(block);
    if (read_it) to_.become(block, known->op, statement);
  }
  return true;
}

/// Read the condition of an IF, and the jump that it makes.
bool BlockReader::conditional(Block& block, Link& link) {
  Statement statement;
  statement.at = line_.offset();
  link.kind = Link::Kind::If;
  if (!expression_.condition(statement.expression)) return refuse(block);
  statement.width = line_.width_from(statement.at);
  const std::string word = capitals(line_.name());
  if (is_jump(word)) {
    line_.pass(word.size());
    link.conditional = true;
    return jump(block, link, word, statement);
  }
  if (!end_of_statement(block)) return false;
  to_.become(block, Op::If, statement);
  return true;
}

/// Read GOTOF END, GOTOB N10 or GOTO 10.
bool BlockReader::jump(Block& block, Link& link, std::string_view word, Statement jump) {
  link.kind = Link::Kind::None;
  link.at = line_.offset();
  if (word.size() > 4) link.direction = word[4];
  const std::string_view name = line_.name();
  const bool number = is_digit(line_.peek()) || (line_.peek() == 'N' && is_digit(line_.ahead(1)));
  if (number) {
    line_.take('N');
    const std::string_view digits = line_.take_digits();
    std::from_chars(digits.data(), digits.data() + digits.size(), link.number);
  } else if (name.size() > 1) {
    link.target = capitals(name);
    line_.pass(name.size());
  } else {
    line_.pass(name.size());
    return refuse(block, Cause::StatementFormat, "the jump has neither a label nor a block number",
                  link.at);
  }
  link.width = line_.width_from(link.at);
  if (link.conditional && capitals(line_.name()) == "IF")
    return not_computed(block, "a second condition in a block", line_.offset());
  if (!end_of_statement(block)) return false;
  jump.variable_at = link.at;
  jump.variable_width = link.width;
  link.kind = Link::Kind::Jump;
  to_.become(block, link.conditional ? Op::IfGoto : Op::Goto, jump);
  return true;
}

bool BlockReader::end_of_statement(Block& block) {
  if (line_.at_end()) return true;
  const std::uint32_t at = line_.offset();
  line_.pass(first_character(line_.rest()).size());
  return refuse(block, Cause::StatementFormat, "nothing can follow the statement in its block", at);
}

}  // namespace cncsub::sinumerik
