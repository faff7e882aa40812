#include "cncsub/dialect/syntec/statements.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/dialect/syntec/statement_text.hpp"

namespace cncsub::syntec {

namespace {

/// Return the number of the variable whose assignment a block is.
std::int64_t assigned_number(const Block& block, std::string_view text, std::string_view written) {
  std::size_t at = text.find('#', block.text);
  const std::int32_t base = written[at] == '@' ? kAtVariables : 0;
  std::int64_t number = 0;
  for (++at; at < text.size() && (is_digit(text[at]) || is_blank(text[at])); ++at)
    if (is_digit(text[at])) number = number * 10 + (text[at] - '0');
  return number + base;
}

/// Read a text between quotation marks, as it is written.
std::string quoted_text(Scanner& s, std::string_view written) {
  if (!s.take('"')) return {};
  const char* const from = s.at;
  s.at = std::find(s.at, s.end, '"');
  const auto at = static_cast<std::size_t>(from - s.file);
  std::string said(written.substr(at, static_cast<std::size_t>(s.at - from)));
  if (s.at != s.end) ++s.at;
  return said;
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
  const auto& begins = StructuredReader::kWords;
  return std::find(std::begin(kInside), std::end(kInside), word) != std::end(kInside) ||
         std::any_of(std::begin(begins), std::end(begins),
                     [word](const auto& of) { return of.name == word; });
}

// ---- the text ----

void StructuredReader::begin_text(std::string_view written) {
  written_ = written;
  text_ = written;
  counted_ = 0;
  line_ = 1;
  blocks_.begin_text(written, types_);
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

/// Keep the type of the variable that a block assigns, if both are known and no switch skips the
/// block. A label, a structure and a call may be reached, or change variables, in other ways:
/// nothing is known after them.
void StructuredReader::learn_type(const Block& block) {
  if (block.n >= 0) types_.clear();
  if (is_words(block.op))
    return static_cast<void>(std::erase_if(types_, [](const auto& of) { return of.first > 400; }));
  if (block.op != Op::Set && block.op != Op::Assign) return types_.clear();
  const Statement of =
      block.op == Op::Set ? assignment_of(to_.code(), block) : to_.record<Statement>(block.aux);
  if (of.target != Statement::Target::Local && of.target != Statement::Target::Common)
    return types_.clear();
  const std::int64_t number = assigned_number(block, text_, written_);
  const Value& value = blocks_.expressions().last_value();
  types_.erase(number);
  if (!block.can_be_skipped() && (value.is_whole() || value.is_real()))
    types_[number] = value.is_whole();
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
  go_behind(s, behind);
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
    if (*number < 1 || *number > most) {
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
      said.text = " " + quoted_text(s, written_);
      print.fields.push_back(said);
    }
  } else {
    said.text = quoted_text(s, written_);
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
  const auto refuse_at = [this](Address head, Cause cause, const Open& open, const char* detail,
                                Kind kind) {
    refuse(to_.block(head), cause, open.at, open.width, detail, kind);
  };
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
