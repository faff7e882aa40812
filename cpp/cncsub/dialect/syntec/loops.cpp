// WHILE, FOR and REPEAT.
#include <algorithm>
#include <utility>

#include "cncsub/code/loop_end.hpp"
#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/dialect/syntec/statement_text.hpp"
#include "cncsub/dialect/syntec/statements.hpp"

namespace cncsub::syntec {

void StructuredReader::while_head(Scanner& s, Block& block) {
  Statement statement = at_keyword();
  push(Structure::While);
  const bool read = condition(s, "DO", statement, block, Cause::WhileFormat, {'W', 'H'});
  if (read && open_.size() > static_cast<std::size_t>(to_.control().macros.max_loops.value)) {
    refuse(block, Cause::LoopsTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
  } else if (read) {
    open_.back().branch = to_.next_address();
    to_.become(block, Op::While, statement);
  }
  append(s, block);
}

void StructuredReader::end_while(Scanner& s, Block& block) {
  Open* const open = innermost(Structure::While, block, Cause::MissingDo, {'W', 'H'});
  if (open == nullptr) return append(s, block);
  const Address end = to_.next_address();
  Statement statement = at_keyword();
  statement.to = open->head;
  to_.become(block, Op::EndDo, statement);
  append(s, block);
  close_loop(end);
}

/// Lead the ways out of the innermost loop behind its end.
void StructuredReader::close_loop(Address end) {
  const Open& open = open_.back();
  if (open.branch != kNowhere) {
    statement_of(open.branch).end = end;
    statement_of(open.branch).to = end + 1;
  }
  for (const Address way : open.exits) statement_of(way).to = end + 1;
  open_.pop_back();
}

void StructuredReader::for_head(Scanner& s, Block& block) {
  push(Structure::For);
  s.blanks();
  Counting of{s, block, {}, s, 0, {}, true};
  if (!first_value(s, block, of) || !last_value(s, block, of)) {
    go_behind(s, "DO");
    return append(s, block);
  }
  if (open_.size() > static_cast<std::size_t>(to_.control().macros.max_loops.value)) {
    refuse(block, Cause::LoopsTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
    return append(s, block);
  }
  const auto next = blocks_.expressions().counted(of.counter, of.step ? &*of.step : nullptr);
  Open& open = open_.back();
  open.count = of.begin;
  open.count.expression = next ? *next : of.begin.expression;
  open.counts_apart = !of.rising;
  if (!of.rising) return count_either_way(s, block, of);
  Statement statement = at_keyword();
  open.branch = to_.next_address();
  statement.expression = of.last;
  statement.then = to_.keep(of.begin);
  to_.become(block, Op::For, statement);
  append(s, block);
}

bool StructuredReader::wrong_for(Block& block, const char* detail) {
  return refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_, detail, {'F', 'O'});
}

/// Read the assignment of a FOR, and TO. It is read as a block of its own.
bool StructuredReader::first_value(Scanner& s, Block& block, Counting& of) {
  Scanner to = s;
  while (to.at != to.end && *to.at != ';') {
    Scanner ahead = to;
    const std::string word = is_letter(*to.at) ? name_of_word(ahead) : "";
    if (word == "TO" || word == "DO") break;
    to.at = word.empty() ? to.at + 1 : ahead.at;
  }
  Scanner behind = to;
  if (!take_whole(behind, "TO")) return wrong_for(block, "TO must follow the first value");
  Scanner assigned{s.at, to.at, s.file};
  of.first.n = -1;
  blocks_.read(assigned, of.first);
  if (of.first.op == Op::Fault) {
    block.op = Op::Fault;
    block.aux = of.first.aux;
    return false;
  }
  if (of.first.op != Op::Set && of.first.op != Op::Assign)
    return wrong_for(block, "an assignment must follow FOR");
  of.begin = of.first.op == Op::Set ? assignment_of(to_.code(), of.first)
                                    : to_.record<Statement>(of.first.aux);
  s = behind;
  return true;
}

/// Read the last value of a FOR, BY and the step, and DO.
bool StructuredReader::last_value(Scanner& s, Block& block, Counting& of) {
  s.blanks();
  of.last_at = s;
  const auto last = blocks_.expressions().number(s);
  bool read = last.has_value();
  if (read && take_whole(s, "BY")) {
    s.blanks();
    of.step = s;
    const auto by = blocks_.expressions().number(s);
    read = by.has_value();
    if (read) of.rising = constant_of(to_.code().expression(*by)).value_or(0) > 0;
  }
  if (!read) {
    to_.refuse(block, blocks_.expressions().fault());
    return false;
  }
  of.last = *last;
  return take_whole(s, "DO") || wrong_for(block, "DO must follow the last value");
}

/// Write a FOR whose step may be negative: an assignment and a WHILE.
void StructuredReader::count_either_way(Scanner& s, Block& block, const Counting& of) {
  to_.become(block, Op::Assign, of.begin);
  append(s, block);
  Block loop = block;
  Statement statement = at_keyword();
  loop.n = -1;
  open_.back().branch = to_.next_address();
  const auto asks =
      of.step ? blocks_.expressions().not_passed(of.counter, of.last_at, *of.step) : std::nullopt;
  if (asks) statement.expression = *asks;
  to_.become(loop, Op::While, statement);
  append(s, loop);
}

void StructuredReader::end_for(Scanner& s, Block& block) {
  Open* const open = innermost(Structure::For, block, Cause::MissingDo, {'F', 'O'});
  if (open == nullptr) return append(s, block);
  Statement statement = at_keyword();
  statement.to = open->branch != kNowhere ? open->branch : open->head;
  if (open->counts_apart) {
    Block count = block;
    to_.become(count, Op::Assign, open->count);
    append(s, count);
    block.n = -1;
    to_.become(block, Op::EndDo, statement);
  } else {
    statement.then = to_.keep(open->count);
    to_.become(block, Op::EndFor, statement);
  }
  const Address end = to_.next_address();
  append(s, block);
  close_loop(end);
}

void StructuredReader::repeat_head(Scanner& s, Block& block) {
  push(Structure::Repeat);
  if (open_.size() > static_cast<std::size_t>(to_.control().macros.max_loops.value))
    refuse(block, Cause::LoopsTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
  append(s, block);
}

/// Read UNTIL with its condition: it goes back to the REPEAT while that does not hold.
void StructuredReader::until(Scanner& s, Block& block) {
  Open* const open = innermost(Structure::Repeat, block, Cause::MissingDo, {'R', 'E'});
  if (open == nullptr) {
    s.at = end_of_statement(s);
    return append(s, block);
  }
  Statement statement = at_keyword();
  const auto read = blocks_.expressions().contrary(s);
  if (!read) {
    to_.refuse(block, blocks_.expressions().fault());
    s.at = end_of_statement(s);
  } else if (!take_whole(s, "END_REPEAT") && !take_whole(s, "ENDREPEAT")) {
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_,
           "END_REPEAT must follow the condition", {'U', 'N'});
    s.at = end_of_statement(s);
  } else {
    statement.expression = *read;
    statement.to = open->head;
    end_loop_by(statement, LoopEnd::ToHead);
    to_.become(block, Op::IfGoto, statement);
  }
  append(s, block);
  for (const Address way : open->exits) statement_of(way).to = to_.next_address();
  open_.pop_back();
}

/// Read EXIT: it leaves the loop around it.
void StructuredReader::exit(Scanner& s, Block& block) {
  const auto loop = std::find_if(open_.rbegin(), open_.rend(), [](const Open& of) {
    return of.kind != Structure::If && of.kind != Structure::Case;
  });
  if (loop == open_.rend()) {
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_, "EXIT stands in no loop");
    return append(s, block);
  }
  loop->exits.push_back(to_.next_address());
  to_.become(block, Op::Goto, at_keyword());
  append(s, block);
}

}  // namespace cncsub::syntec
