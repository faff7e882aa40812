// IF and CASE.
#include <utility>

#include "cncsub/dialect/syntec/statement_text.hpp"
#include "cncsub/dialect/syntec/statements.hpp"

namespace cncsub::syntec {

// ---- IF ----

void StructuredReader::if_head(Scanner& s, Block& block) {
  Statement statement = at_keyword();
  push(Structure::If);
  const std::size_t deep = open_.size();
  const bool read = condition(s, "THEN", statement, block, Cause::IfFormat, {'N', 'I'});
  if (read && deep > static_cast<std::size_t>(to_.control().macros.max_ifs.value)) {
    refuse(block, Cause::IfTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
  } else if (read) {
    open_.back().branch = to_.next_address();
    to_.become(block, Op::If, statement);
  }
  append(s, block);
}

/// Read ELSEIF: a block that goes on at the END_IF, then an IF.
void StructuredReader::else_if(Scanner& s, Block& block) {
  Open* const open = innermost(Structure::If, block, Cause::IfWithoutEnd, {'N', 'I'});
  if (open == nullptr || open->otherwise) {
    if (open != nullptr)
      refuse(block, Cause::IfWithoutEnd, keyword_at_, keyword_width_, "ELSEIF stands after ELSE");
    s.at = end_of_statement(s);
    return append(s, block);
  }
  Block second = block;
  Statement statement = at_keyword();
  second.n = -1;
  const bool read = condition(s, "THEN", statement, second, Cause::IfFormat, {'N', 'I'});
  way_to_end(*open, block);
  append(s, block);
  const Address branch = std::exchange(open->branch, kNowhere);
  if (branch != kNowhere) statement_of(branch).to = to_.next_address();
  if (read) {
    open->branch = to_.next_address();
    to_.become(second, Op::If, statement);
  }
  append(s, second);
}

void StructuredReader::else_head(Scanner& s, Block& block) {
  const bool of_case = !open_.empty() && open_.back().kind == Structure::Case;
  Open* const open =
      of_case ? &open_.back() : innermost(Structure::If, block, Cause::IfWithoutEnd, {'N', 'I'});
  if (open == nullptr) return append(s, block);
  if (open->otherwise) {
    refuse(block, Cause::IfWithoutEnd, keyword_at_, keyword_width_, "a second ELSE");
    return append(s, block);
  }
  open->otherwise = true;
  way_to_end(*open, block);
  append(s, block);
  const Address next = to_.next_address();
  open->rest = next;
  if (open->branch != kNowhere) statement_of(std::exchange(open->branch, kNowhere)).to = next;
}

void StructuredReader::end_if(Scanner& s, Block& block) {
  Open* const open = innermost(Structure::If, block, Cause::IfWithoutEnd, {'N', 'I'});
  if (open == nullptr) return append(s, block);
  const Address end = to_.next_address();
  to_.become(block, Op::EndIf, at_keyword());
  append(s, block);
  if (open->branch != kNowhere) statement_of(open->branch).to = end;
  for (const Address way : open->ways) statement_of(way).to = end;
  open_.pop_back();
}

// ---- CASE ----

void StructuredReader::case_head(Scanner& s, Block& block) {
  push(Structure::Case);
  const auto value = blocks_.expressions().number(s);
  const bool of = value && take_whole(s, "OF");
  if (!value)
    to_.refuse(block, blocks_.expressions().fault());
  else if (!of)
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_, "OF must follow the value",
           {'C', 'A'});
  else if (open_.size() > static_cast<std::size_t>(to_.control().macros.max_ifs.value))
    refuse(block, Cause::IfTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
  else
    open_.back().expression = *value;
  if (!of) go_behind(s, "OF");
  append(s, block);
}

/// Read the values before a colon: `1:`, `2, 3:`. The branch before them ends there.
bool StructuredReader::case_label(Scanner& s, Block& block) {
  if (open_.empty() || open_.back().kind != Structure::Case || !is_digit(s.peek())) return false;
  keyword_at_ = s.offset();
  std::vector<Alternative> alternatives;
  bool read = true;
  do {
    s.blanks();
    const std::uint32_t at = s.offset();
    const auto value = blocks_.expressions().number(s);
    read = value.has_value();
    if (read) alternatives.push_back({*value, kNowhere, at});
  } while (read && s.take(','));
  keyword_width_ = width_to(s, keyword_at_);
  types_.clear();
  Open& open = open_.back();
  if (!read) {
    to_.refuse(block, blocks_.expressions().fault());
    open.wrong = to_.next_address();
    s.at = end_of_statement(s);
  } else if (!s.take(':')) {
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_,
           "a colon must follow the values of a branch", {'C', 'O'});
    open.wrong = to_.next_address();
    s.at = end_of_statement(s);
  } else {
    way_to_end(open, block);
  }
  const Address first = to_.next_address() + 1;
  for (Alternative& one : alternatives) one.to = first;
  open.alternatives.insert(open.alternatives.end(), alternatives.begin(), alternatives.end());
  append(s, block);
  return true;
}

void StructuredReader::end_case(Scanner& s, Block& block) {
  Open* const found = innermost(Structure::Case, block, Cause::IfWithoutEnd, {'N', 'C'});
  if (found == nullptr) return append(s, block);
  const Address end = to_.next_address();
  to_.become(block, Op::EndIf, at_keyword());
  append(s, block);
  const Open open = std::move(open_.back());
  open_.pop_back();
  for (const Address way : open.ways) statement_of(way).to = end;
  Block& head = to_.block(open.head);
  if (head.op != Op::Fault && open.wrong != kNowhere) {
    head.op = Op::Fault;
    head.aux = to_.block(open.wrong).aux;
  }
  if (head.op != Op::Fault) choose(open, end);
}

/// Write the choice at the head of a CASE: a jump for each of its values, and one for the rest.
void StructuredReader::choose(const Open& open, Address end) {
  const Block head = to_.block(open.head);
  const auto jump_to = [&](Address to) {
    Statement jump;
    jump.at = open.at;
    jump.width = open.width;
    jump.to = to;
    Block then = head;
    to_.become(then, Op::Goto, jump);
    return to_.keep(then);
  };
  std::vector<Statement> all;
  for (const Alternative& of : open.alternatives) {
    Statement one;
    one.at = of.at;
    one.expression = of.expression;
    one.then = jump_to(of.to);
    all.push_back(one);
  }
  Statement rest;
  rest.at = open.at;
  rest.index = Statement::kAlways;
  rest.then = jump_to(open.rest != kNowhere ? open.rest : end);
  all.push_back(rest);
  Statement choice;
  choice.at = open.at;
  choice.width = open.width;
  choice.expression = open.expression;
  choice.index = Statement::kHasValue;
  choice.number = static_cast<std::int32_t>(all.size());
  to_.become(to_.block(open.head), Op::Switch, choice);
  for (const Statement& one : all) to_.keep(one);
}

}  // namespace cncsub::syntec
