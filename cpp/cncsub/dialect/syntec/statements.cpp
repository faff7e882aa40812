#include "cncsub/dialect/syntec/statements.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "cncsub/dialect/iso/structured_words.hpp"

namespace cncsub::syntec {

namespace {

/// Take a word of letters that stands here whole.
bool take_whole(Scanner& s, std::string_view word) {
  Scanner ahead = s;
  ahead.blanks();
  if (name_of_word(ahead) != word) return false;
  s = ahead;
  return true;
}

/// Return the place of the semicolon that ends the statement here, or the end of the text.
const char* end_of_statement(const Scanner& s) { return std::find(s.at, s.end, ';'); }

/// Return the value of an expression that is a number and nothing else.
std::optional<double> constant_of(const Expression& of) {
  auto at = of.begin();
  const Instruction only = *at;
  if (only.op != Ins::Constant || !(++at == Expression::end())) return std::nullopt;
  return only.value;
}

std::uint32_t width_to(const Scanner& s, std::uint32_t from) {
  return std::max(1u, s.offset() - from);
}

}  // namespace

const StructuredReader::Word StructuredReader::kWords[] = {
    {"IF", &StructuredReader::if_head},
    {"ELSEIF", &StructuredReader::else_if},
    {"ELSE", &StructuredReader::else_head},
    {"END_IF", &StructuredReader::end_if},
    {"ENDIF", &StructuredReader::end_if},
    {"CASE", &StructuredReader::case_head},
    {"END_CASE", &StructuredReader::end_case},
    {"ENDCASE", &StructuredReader::end_case},
    {"WHILE", &StructuredReader::while_head},
    {"END_WHILE", &StructuredReader::end_while},
    {"ENDWHILE", &StructuredReader::end_while},
    {"FOR", &StructuredReader::for_head},
    {"END_FOR", &StructuredReader::end_for},
    {"ENDFOR", &StructuredReader::end_for},
    {"REPEAT", &StructuredReader::repeat_head},
    {"UNTIL", &StructuredReader::until},
    {"EXIT", &StructuredReader::exit},
    {"GOTO", &StructuredReader::jump},
    {"ALARM", &StructuredReader::alarm},
    {"MSG", &StructuredReader::message},
    // A run computes each block when those before it have moved: nothing waits.
    {"WAIT", &StructuredReader::no_words},
    {"SLEEP", &StructuredReader::no_words},
    {"OPEN", &StructuredReader::dropped},
    {"CLOSE", &StructuredReader::dropped},
    {"PRINT", &StructuredReader::dropped},
    {"SETDO", &StructuredReader::dropped},
    {"SETABIT", &StructuredReader::dropped},
    {"SETRREGBIT", &StructuredReader::dropped},
    {"SETDRAW", &StructuredReader::dropped},
    {"DRAWHOLE", &StructuredReader::dropped}};

bool is_statement(std::string_view word) {
  static constexpr std::string_view kInside[] = {"THEN", "OF", "TO", "BY", "DO", "END_REPEAT"};
  return std::find(std::begin(kInside), std::end(kInside), word) != std::end(kInside) ||
         StructuredReader::begins_statement(word);
}

bool StructuredReader::begins_statement(std::string_view word) {
  return std::any_of(std::begin(kWords), std::end(kWords),
                     [word](const Word& of) { return of.name == word; });
}

// ---- the text ----

void StructuredReader::begin_text(std::string_view written) {
  written_ = written;
  text_ = written;
  counted_ = 0;
  line_ = 1;
  blocks_.begin_text(written.data(), types_);
}

std::uint32_t StructuredReader::line_of(std::size_t at) {
  line_ += static_cast<std::uint32_t>(
      std::count(written_.begin() + static_cast<std::ptrdiff_t>(counted_),
                 written_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  counted_ = at;
  return line_;
}

void StructuredReader::read(std::size_t from, std::size_t to, std::uint32_t line) {
  translate_structured(text_, from, to);
  counted_ = from;
  line_ = line;
  Scanner s{text_.data() + from, text_.data() + to, text_.data()};
  while (s.peek() != '\0') {
    if (s.take(';')) continue;
    const char* const before = s.at;
    statement(s);
    if (to_.interrupt().requested(static_cast<std::size_t>(s.at - before))) return;
  }
}

void StructuredReader::append(const Scanner& s, Block& block) {
  std::string_view said(text_.data() + block.text, s.offset() - block.text);
  said = trimmed(said);
  block.length = static_cast<std::uint16_t>(std::min<std::size_t>(said.size(), 65535));
  to_.append(block);
}

void StructuredReader::statement(Scanner& s) {
  Block block;
  block.op = Op::Words;
  block.text = s.offset();
  block.line = line_of(block.text);
  const Scanner from = s;
  if (case_label(s, block) || keyword(s, block)) return;
  s = from;
  words(from, s, block);
}

/// Read the words of a block, or an assignment, up to the semicolon.
void StructuredReader::words(const Scanner& from, Scanner& s, Block& block) {
  s.at = end_of_statement(from);
  Scanner inside{from.at, s.at, from.file};
  block.n = -1;
  Scanner head = inside;
  if (head.peek() == 'N') types_.clear();
  blocks_.read(inside, block);
  learn_type(block);
  append(s, block);
}

/// Keep the type of the variable that a block assigns, if both are known. A label, a structure and
/// a call may be reached, or change variables, in other ways: nothing is known after them.
void StructuredReader::learn_type(const Block& block) {
  if (block.n >= 0) types_.clear();
  if (is_words(block.op))
    return static_cast<void>(std::erase_if(types_, [](const auto& of) { return of.first > 400; }));
  if (block.op != Op::Set && block.op != Op::Assign) return types_.clear();
  const Statement of =
      block.op == Op::Set ? assignment_of(to_.code(), block) : to_.record<Statement>(block.aux);
  if (of.target != Statement::Target::Local && of.target != Statement::Target::Common)
    return types_.clear();
  const std::int64_t number = assigned_number(block);
  const Value& value = blocks_.expressions().last_value();
  types_.erase(number);
  if (value.is_whole() || value.is_real()) types_[number] = value.is_whole();
}

/// Return the number of the variable whose assignment a block is.
std::int64_t StructuredReader::assigned_number(const Block& block) const {
  std::size_t at = text_.find('#', block.text);
  const std::int32_t base = written_[at] == '@' ? kAtVariables : 0;
  std::int64_t number = 0;
  while (is_digit(text_[++at]) || is_blank(text_[at]))
    if (is_digit(text_[at])) number = number * 10 + (text_[at] - '0');
  return number + base;
}

/// Read a statement that begins with a word of several letters, perhaps after N and a number.
bool StructuredReader::keyword(Scanner& s, Block& block) {
  if (s.peek() == 'N') {
    Scanner ahead = s;
    ++ahead.at;
    if (!is_digit(*ahead.at)) return false;
    const Number number = scan_number(ahead);
    if (number.points != 0 || number.value > to_.control().reading.max_sequence_number.value)
      return false;  // as a block of words it is refused
    block.n = to_whole<std::int32_t>(number.value);
    s = ahead;
    s.blanks();
  }
  if (s.end - s.at < 2 || !is_letter(s.at[0]) || (!is_letter(s.at[1]) && s.at[1] != '_'))
    return false;
  keyword_at_ = s.offset();
  const std::string name = name_of_word(s);
  keyword_width_ = width_to(s, keyword_at_);
  types_.clear();
  for (const Word& of : kWords) {
    if (of.name != name) continue;
    (this->*of.read)(s, block);
    return true;
  }
  s.at = end_of_statement(s);
  const bool app = name.starts_with("AR") || name.starts_with("MAR");
  if (is_not_computed(name) || app)
    refuse(block, Cause::CodeNotComputed, keyword_at_, keyword_width_,
           app ? "cncsub knows no variables of applications" : "cncsub does not compute " + name);
  else
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_,
           name + " is no statement of this control");
  append(s, block);
  return true;
}

// ---- faults ----

Statement StructuredReader::at_keyword() const {
  Statement statement;
  statement.at = keyword_at_;
  statement.width = keyword_width_;
  return statement;
}

bool StructuredReader::refuse(Block& block, Cause cause, std::uint32_t at, std::uint32_t width,
                              std::string detail, Kind kind) {
  Fault fault{cause, at, width, std::move(detail)};
  fault.kind = kind;
  to_.refuse(block, std::move(fault));
  return false;
}

void StructuredReader::refuse_at(Address address, Cause cause, const Open& open, const char* detail,
                                 Kind kind) {
  refuse(to_.block(address), cause, open.at, open.width, detail, kind);
}

/// Read a condition and the word after it. Where one of them is wrong the block is refused, and
/// the reading goes on after that word all the same.
bool StructuredReader::condition(Scanner& s, std::string_view behind, Statement& statement,
                                 Block& block, Cause cause, Kind kind) {
  const auto read = blocks_.expressions().condition(s);
  if (read && take_whole(s, behind)) {
    statement.expression = *read;
    return true;
  }
  if (!read)
    to_.refuse(block, blocks_.expressions().fault());
  else
    refuse(block, cause, keyword_at_, keyword_width_,
           std::string(behind) + " must follow the condition", kind);
  const char* const end = end_of_statement(s);
  while (s.at < end && !take_whole(s, behind)) ++s.at;
  return false;
}

void StructuredReader::push(Structure kind) {
  open_.push_back({kind, to_.next_address(), keyword_at_, keyword_width_});
}

/// Return the open structure that a word belongs to; where another one is open, or none, the block
/// is refused.
StructuredReader::Open* StructuredReader::innermost(Structure kind, Block& block, Cause cause,
                                                    Kind missing) {
  if (!open_.empty() && open_.back().kind == kind) return &open_.back();
  refuse(block, cause, keyword_at_, keyword_width_,
         "this word has no beginning, or another structure is open in between", missing);
  return nullptr;
}

/// Make the block one that goes on at the end of its structure: it stands after a branch.
void StructuredReader::way_to_end(Open& open, Block& block) {
  open.ways.push_back(to_.next_address());
  to_.become(block, Op::Else, at_keyword());
}

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
  if (!of) {
    const char* const end = end_of_statement(s);
    while (s.at < end && !take_whole(s, "OF")) ++s.at;
  }
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
  if (head.op == Op::Fault) return;
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

// ---- loops ----

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
  if (open->branch != kNowhere) {
    statement_of(open->branch).end = end;
    statement_of(open->branch).to = end + 1;
  }
  for (const Address way : open->exits) statement_of(way).to = end + 1;
  open_.pop_back();
}

void StructuredReader::for_head(Scanner& s, Block& block) {
  push(Structure::For);
  const auto wrong = [&](const char* detail) {
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_, detail, {'F', 'O'});
    const char* const end = end_of_statement(s);
    while (s.at < end && !take_whole(s, "DO")) ++s.at;
    append(s, block);
  };
  s.blanks();
  const Scanner counter = s;
  Block first = block;
  // The assignment ends before TO: it is read as a block of its own.
  const char* to = s.at;
  Scanner ahead = s;
  const char* const end = end_of_statement(s);
  for (; ahead.at < end; ++ahead.at) {
    const bool begins = ahead.at == s.at || !is_letter(ahead.at[-1]);
    Scanner word = ahead;
    if (begins && take_whole(word, "TO") && is_letter(*ahead.at)) break;
  }
  if (ahead.at >= end) return wrong("TO must follow the first value");
  to = ahead.at;
  first.n = -1;
  Scanner assigned{counter.at, to, counter.file};
  blocks_.read(assigned, first);
  if (first.op == Op::Fault) {
    block.op = Op::Fault;
    block.aux = first.aux;
    s.at = end;
    Scanner rest = counter;
    while (rest.at < end && !take_whole(rest, "DO")) ++rest.at;
    s.at = rest.at;
    return append(s, block);
  }
  if (first.op != Op::Set && first.op != Op::Assign) return wrong("an assignment must follow FOR");
  s = ahead;
  take_whole(s, "TO");
  s.blanks();
  const Scanner last_at = s;
  const auto last = blocks_.expressions().number(s);
  std::optional<Scanner> step;
  bool rising = true;
  bool read = last.has_value();
  if (read && take_whole(s, "BY")) {
    s.blanks();
    step = s;
    const auto by = blocks_.expressions().number(s);
    read = by.has_value();
    if (read) {
      rising = constant_of(to_.code().expression(*by)).value_or(0) > 0;
    }
  }
  if (!read) {
    to_.refuse(block, blocks_.expressions().fault());
    while (s.at < end && !take_whole(s, "DO")) ++s.at;
    return append(s, block);
  }
  if (!take_whole(s, "DO")) return wrong("DO must follow the last value");
  if (open_.size() > static_cast<std::size_t>(to_.control().macros.max_loops.value)) {
    refuse(block, Cause::LoopsTooDeep, keyword_at_, keyword_width_,
           "more structures inside each other than the control allows");
    return append(s, block);
  }
  const auto assignment = [&] {
    return first.op == Op::Set ? assignment_of(to_.code(), first)
                               : to_.record<Statement>(first.aux);
  };
  const Statement begin = assignment();
  const auto next = blocks_.expressions().counted(counter, step ? &*step : nullptr);
  Open& open = open_.back();
  open.count = begin;
  open.count.expression = next ? *next : begin.expression;
  open.counts_apart = !rising;
  Statement statement = at_keyword();
  if (rising) {
    open.branch = to_.next_address();
    statement.expression = *last;
    statement.then = to_.keep(begin);
    to_.become(block, Op::For, statement);
    return append(s, block);
  }
  to_.become(block, Op::Assign, begin);
  append(s, block);
  Block loop = block;
  loop.n = -1;
  open.branch = to_.next_address();
  statement.expression = *blocks_.expressions().not_passed(counter, last_at, *step);
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
  if (open->branch != kNowhere) {
    statement_of(open->branch).end = end;
    statement_of(open->branch).to = end + 1;
  }
  for (const Address way : open->exits) statement_of(way).to = end + 1;
  open_.pop_back();
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

// ---- jumps and messages ----

void StructuredReader::jump(Scanner& s, Block& block) {
  Statement statement = at_keyword();
  s.blanks();
  const std::uint32_t at = s.offset();
  statement.variable_at = at;
  statement.number = -1;
  const auto value = blocks_.expressions().number(s);
  statement.variable_width = width_to(s, at);
  if (!value) {
    to_.refuse(block, blocks_.expressions().fault());
    s.at = end_of_statement(s);
    return append(s, block);
  }
  if (const auto number = constant_of(to_.code().expression(*value))) {
    const int most = to_.control().calls.max_jump_number.value;
    if (!(*number >= 1 && *number <= most)) {
      refuse(block, Cause::IllegalJumpNumber, at, statement.variable_width,
             "the number of GOTO must be 1 to " + std::to_string(most));
      return append(s, block);
    }
    statement.number = to_whole<std::int32_t>(*number);
    jumps_.push_back(to_.next_address());
  }
  statement.variable = *value;
  to_.become(block, Op::Goto, statement);
  append(s, block);
}

/// Read a text between quotation marks, as it is written.
std::string StructuredReader::text(Scanner& s) {
  if (!s.take('"')) return {};
  const char* const from = s.at;
  s.at = std::find(s.at, s.end, '"');
  const auto at = static_cast<std::size_t>(from - s.file);
  std::string said(written_.substr(at, static_cast<std::size_t>(s.at - from)));
  if (s.at != s.end) ++s.at;
  return said;
}

/// Read ALARM(300), MSG("TEXT"), MSG(100, "TEXT").
void StructuredReader::print(Scanner& s, Block& block, bool alarms) {
  Print print;
  print.at = keyword_at_;
  print.alarms = alarms;
  const auto wrong = [&](std::string detail) {
    refuse(block, Cause::StatementFormat, keyword_at_, keyword_width_, std::move(detail));
    s.at = end_of_statement(s);
    append(s, block);
  };
  if (!s.take('[')) return wrong("brackets must follow");
  PrintField number, said;
  if (s.peek() != '"') {
    const auto value = blocks_.expressions().number(s);
    if (!value) {
      to_.refuse(block, blocks_.expressions().fault());
      s.at = end_of_statement(s);
      return append(s, block);
    }
    number.is_variable = true;
    number.expression = *value;
    number.whole_digits = PrintField::kPlain;
    print.fields.push_back(number);
    if (s.take(',')) {
      said.text = " " + text(s);
      print.fields.push_back(said);
    }
  } else {
    said.text = text(s);
    print.fields.push_back(said);
  }
  if (!s.take(']')) return wrong("the bracket is not closed");
  to_.become(block, Op::Print, std::move(print));
  append(s, block);
}

void StructuredReader::alarm(Scanner& s, Block& block) { print(s, block, true); }
void StructuredReader::message(Scanner& s, Block& block) { print(s, block, false); }

/// Read a statement without an effect on a run.
void StructuredReader::no_words(Scanner& s, Block& block) {
  s.at = end_of_statement(s);
  to_.words(block, WordList{});
  append(s, block);
}

/// Read a statement that only the machine and the screen obey: it is dropped, and told.
void StructuredReader::dropped(Scanner& s, Block& block) {
  s.at = end_of_statement(s);
  to_.drop(keyword_at_, keyword_width_);
  to_.words(block, WordList{});
  append(s, block);
}

// ---- the end ----

void StructuredReader::end_program(const Program& program) {
  for (const Open& open : open_) {
    const bool other = open.otherwise;
    switch (open.kind) {
      case Structure::If:
        refuse_at(open.head, Cause::IfWithoutEnd, open, "this IF has no END_IF",
                  other ? Kind{'E', 'L'} : Kind{'I', 'F'});
        break;
      case Structure::Case:
        refuse_at(open.head, Cause::IfWithoutEnd, open, "this CASE has no END_CASE",
                  other ? Kind{'C', 'E'} : Kind{'C', 'A'});
        break;
      case Structure::While:
        refuse_at(open.head, Cause::MissingEnd, open, "this WHILE has no END_WHILE", {'W', 'H'});
        break;
      case Structure::For:
        refuse_at(open.head, Cause::MissingEnd, open, "this FOR has no END_FOR", {'F', 'O'});
        break;
      case Structure::Repeat:
        refuse_at(open.head, Cause::MissingEnd, open, "this REPEAT has no UNTIL", {'R', 'E'});
        break;
    }
  }
  open_.clear();
  for (const Address address : jumps_) {
    if (to_.block(address).op != Op::Goto) continue;
    Statement& jump = statement_of(address);
    jump.to = to_.code().jump_target(program, jump.number, address);
  }
  jumps_.clear();
}

}  // namespace cncsub::syntec
