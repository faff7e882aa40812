#include "cncsub/dialect/iso/word_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/text/look_alikes.hpp"

namespace cncsub {

namespace {

/// Return the mask bit of a slash's switch; a slash without a number has switch 1.
std::uint16_t mask_of(const Lexeme& slash) {
  return static_cast<std::uint16_t>(1U << (slash.skip == 0 ? 1U : slash.skip));
}

/// Return whether a second sign follows the sign of a number.
bool two_signs(const Number& number, Scanner behind) {
  if (number.any || !number.has_sign || number.points != 0) return false;
  const char next = behind.peek();
  return next == '-' || next == '+';
}

bool takes_name(Role role) {
  switch (role) {
    case Role::Call:
    case Role::ExternalCall:
    case Role::MacroCall:
    case Role::ModalCall:
    case Role::ModalCallEveryBlock:
      return true;
    default:
      return false;
  }
}

}  // namespace

// ---- the head ----

bool WordScanner::head() {
  for (char c = s_.peek(); c == '/' || c == 'N'; c = s_.peek()) {
    Scanner ahead = s_;
    const Lexeme read = read_lexeme(ahead, axes_);
    if (read.kind == Lexeme::Kind::Statement || (c == 'N' && block_.n >= 0)) return true;
    s_ = ahead;
    if (c == '/')
      block_.skip = static_cast<std::uint16_t>(block_.skip | mask_of(read));
    else if (!sequence_number(read))
      return false;
  }
  return true;
}

bool WordScanner::sequence_number(const Lexeme& read) {
  const std::uint32_t at = offset(read);
  const Number& number = read.number;
  const auto wrong = [&](Cause cause, std::string detail) {
    return refuse({cause, at, std::max(1u, s_.offset() - at), std::move(detail)});
  };
  if (read.value == Lexeme::Value::Expression)
    return wrong(Cause::IllegalSequenceNumber, "a sequence number cannot come from a variable");
  if (two_signs(number, s_)) return wrong(Cause::TwoSigns, "a sequence number has no sign");
  if (!number.any) return wrong(Cause::AddressWithoutValue, "N without a number");
  if (number.points != 0)
    return wrong(Cause::IllegalDecimalPoint, "a sequence number has no point");
  if (number.has_sign) return wrong(Cause::IllegalMinusSign, "a sequence number has no sign");
  if (number.value > control_.reading.max_sequence_number.value)
    return wrong(Cause::IllegalSequenceNumber,
                 "the largest sequence number is " +
                     std::to_string(control_.reading.max_sequence_number.value));
  if (number.value == 0 && control_.common.refuses.value.has(Cause::ProgramNumberZero))
    return wrong(Cause::ProgramNumberZero, "N0 is not a sequence number");
  block_.n = to_whole<std::int32_t>(number.value);
  return true;
}

// ---- words ----

bool WordScanner::words(Tokens& tokens) {
  slashes_ = block_.skip;
  for (;;) {
    if (!tokens.empty() && ends_here()) return true;
    const Lexeme read = read_lexeme(s_, axes_);
    if (read.kind == Lexeme::Kind::End) return true;
    if (to_.interrupt().requested(1)) return false;
    if (!lexeme(read, tokens)) return false;
  }
}

/// Return whether a condition begins here that may end the words: M99 is after it.
bool WordScanner::ends_here() const {
  return control_.calls.conditional_return.value && s_.at != s_.end && s_.peek() == '[';
}

bool WordScanner::lexeme(const Lexeme& read, Tokens& tokens) {
  switch (read.kind) {
    case Lexeme::Kind::End:
      return true;
    case Lexeme::Kind::Statement:
      if (read.address == '#') return stray(read.at);
      [[fallthrough]];
    case Lexeme::Kind::Word:
      return read.address == 'N' && !read.comma ? late_sequence_number(read, tokens)
                                                : word(read, tokens);
    case Lexeme::Kind::Slash:
      return skip(read, tokens);
    case Lexeme::Kind::Name:
    case Lexeme::Kind::Other:
      return other(read, tokens);
  }
  return false;
}

Token& WordScanner::add(const Lexeme& read, Tokens& tokens) {
  Token& token = tokens.emplace_back();
  token.operand.at = offset(read);
  token.letter = read.address;
  token.comma = read.comma;
  token.axis = read.axis;
  return token;
}

bool WordScanner::word(const Lexeme& read, Tokens& tokens) {
  if (read.comma && comma_place(read.address) < 0) return stray(read.at + 1);
  return value(read, add(read, tokens));
}

bool WordScanner::late_sequence_number(const Lexeme& read, Tokens& tokens) {
  if (control_.common.refuses.value.has(Cause::SequenceNumberNotFirst))
    return refuse(
        {Cause::SequenceNumberNotFirst, offset(read), 1, "N must be the first word of its block"});
  if (block_.n >= 0) return word(read, tokens);
  add(read, tokens).trailing_n = true;
  if (!sequence_number(read)) return false;
  if (!control_.reading.late_sequence_numbers.value) block_.n = -1;
  return true;
}

bool WordScanner::other(const Lexeme& read, Tokens& tokens) {
  if (read.kind == Lexeme::Kind::Name &&
      control_.reading.program_heads.value.has(ProgramHead::Name))
    return name(add(read, tokens), '>');
  if (read.address == ')' && control_.reading.open_comment.value == OpenComment::RestOfBlock) {
    s_.at = read.at;
    s_.rest_of_comment();
    if (s_.peek() != ')') return true;
    return stray(s_.at);
  }
  return stray(read.address == ',' ? read.at + 1 : read.at);
}

/// Read a slash after other words. A second slash of the same switch changes nothing: the first has
/// dropped the rest of the block already, or neither drops it.
bool WordScanner::skip(const Lexeme& read, Tokens& tokens) {
  if (control_.reading.block_skip.value == BlockSkip::HeadOnly)
    return refuse({Cause::IllegalCharacter, offset(read), 1,
                   "a block-skip slash is allowed only at the start of a block"});
  const std::uint16_t mask = mask_of(read);
  if ((mask & slashes_) == 0) add(read, tokens).skip = mask;
  slashes_ = static_cast<std::uint16_t>(slashes_ | mask);
  return true;
}

/// Refuse a character that begins no word.
bool WordScanner::stray(const char* from) {
  s_.at = from;
  const char c = s_.peek();
  const std::uint32_t at = s_.offset();
  if (c == '#')
    return refuse(
        {Cause::NcAndMacroInBlock, at, 1, "a macro statement cannot follow NC words in a block"});
  if (begins_number(c) || c == '[')
    return refuse({Cause::ValueWithoutAddress, at, 1, "there is no address before this value"});
  if (c == ']') return refuse({Cause::BracketNotOpened, at, 1, "this bracket was never opened"});
  const std::string_view character =
      first_character({s_.at, static_cast<std::size_t>(s_.end - s_.at)});
  const auto width = static_cast<std::uint32_t>(character.size());
  const bool wide = character == "\uFF08" || character == "\uFF09";  // full-width
  if ((wide || c == ')') && control_.reading.open_comment.value == OpenComment::Alarm)
    return refuse({Cause::CommentNotClosed, at, width,
                   wide ? "a full-width parenthesis does not begin a comment"
                        : "this parenthesis does not end a comment"});
  Fault unknown{Cause::IllegalCharacter, at, width,
                "the control does not know this character" + full_width_of(character)};
  if (width > 1) unknown.kind = {'N', 'A'};  // no ASCII
  return refuse(std::move(unknown));
}

// ---- values ----

bool WordScanner::value(const Lexeme& read, Token& token) {
  switch (read.value) {
    case Lexeme::Value::Number:
      return expressions_.goes_on(s_) ? arithmetic(token, read.value_at)
                                      : number(token, read.number);
    case Lexeme::Value::Expression:
      return computed(token);
    case Lexeme::Value::None:
      return no_value(token, read.comma ? read.at + 1 : read.at);
  }
  return false;
}

bool WordScanner::number(Token& token, const Number& number) {
  Operand& operand = token.operand;
  operand.kind = Operand::Kind::Constant;
  operand.value = number.value;
  operand.digits = static_cast<std::uint8_t>(std::min<std::uint32_t>(number.digits, 255));
  operand.written = static_cast<std::uint8_t>(std::min<std::uint32_t>(number.written, 255));
  operand.whole = number.points == 0;
  operand.fine = number.decimals > 3 && kLengths.find(token.letter) != std::string_view::npos;
  operand.width = std::max(1u, s_.offset() - operand.at);
  return check(token, number);
}

/// Refuse a number that is wrong in any word; note in the token what only a macro argument may
/// have.
bool WordScanner::check(Token& token, const Number& number) {
  if (two_signs(number, s_))
    return refuse(
        fault_of(token, Cause::TwoSigns, std::string(1, token.letter) + " has more than one sign"));
  if (!number.any) return refuse(fault_of(token, Cause::AddressWithoutValue, no_value_text(token)));
  if (number.points > 1)
    return refuse(fault_of(token, Cause::IllegalDecimalPoint, "two points in one number"));
  const std::uint32_t digits = number.points == 1 ? number.whole_digits + 3 : number.digits;
  token.bad_number = true;
  if (number.points == 1 && !rules_.takes_point(token.letter) && token.letter != 'G')
    token.wrong = Cause::IllegalDecimalPoint;
  else if (number.negative && !rules_.takes_minus(token.letter))
    token.wrong = Cause::IllegalMinusSign;
  else if (digits > static_cast<std::uint32_t>(most_digits(control_)))
    token.wrong = Cause::TooManyDigits;
  else
    token.bad_number = false;
  return true;
}

Fault bad_word(const Control& control, const Token& token) {
  const std::string letter(1, token.letter);
  std::string detail = letter + " cannot have a minus sign";
  if (token.wrong == Cause::IllegalDecimalPoint) detail = letter + " cannot have a decimal point";
  if (token.wrong == Cause::TooManyDigits)
    detail = "a number has at most " + std::to_string(most_digits(control)) + " digits";
  return fault_of(token, token.wrong, std::move(detail));
}

/// Read a value that an expression gives, or the bracketed name of the program that P calls.
bool WordScanner::computed(Token& token) {
  if (token.letter == 'P' && s_.peek() == '[' && is_name_here() && calls_by_name()) {
    s_.take('[');
    token.letter = '<';
    return name(token, ']');
  }
  Operand& operand = token.operand;
  Scanner behind_sign = s_;
  if (behind_sign.peek() == '-' || behind_sign.peek() == '+') ++behind_sign.at;
  operand.bracketed = behind_sign.peek() == '[';
  if (token.letter == 'O')
    return refuse(
        fault_of(token, Cause::AddressNotUsable, "a program number cannot come from a variable"));
  const auto value = expressions_.word_value(s_, token.letter);
  if (!value) return refuse(expressions_.fault());
  operand.kind = Operand::Kind::Expression;
  operand.expression = *value;
  operand.width = std::max(1u, s_.offset() - operand.at);
  return true;
}

/// Read arithmetic that begins with a number: X10+#1.
bool WordScanner::arithmetic(Token& token, const char* from) {
  Operand& operand = token.operand;
  if (token.letter == 'O')
    return refuse(
        fault_of(token, Cause::AddressNotUsable, "a program number cannot come from a variable"));
  s_.at = from;
  const auto value = expressions_.arithmetic_of_word(s_, token.letter);
  if (!value) return refuse(expressions_.fault());
  operand.kind = Operand::Kind::Expression;
  operand.expression = *value;
  operand.width = std::max(1u, s_.offset() - operand.at);
  return true;
}

std::string WordScanner::no_value_text(const Token& token) const {
  const std::string_view text(s_.file, static_cast<std::size_t>(s_.end - s_.file));
  return std::string(1, token.letter) + " has no value" + letter_for_zero(text, token.operand.at);
}

bool WordScanner::no_value(Token& token, const char* letter) {
  if (token.letter == 'G' && control_.reading.bare_g.value) {
    token.operand.kind = Operand::Kind::Constant;
    token.operand.whole = true;
    return true;
  }
  if (auto fault = other_statement(letter)) return refuse(*fault);
  if (is_letter(s_.peek()))
    if (auto fault = statement_at(letter)) {
      fault->at = token.operand.at;
      return refuse(*fault);
    }
  return refuse({Cause::AddressWithoutValue, token.operand.at, 1, no_value_text(token)});
}

/// Return the fault of a statement that only other programs of the dialect have.
std::optional<Fault> WordScanner::other_statement(const char* letter) const {
  if (rules_.variant.is_other_statement == nullptr) return std::nullopt;
  Scanner ahead = s_;
  ahead.at = letter;
  const std::string word = name_of_word(ahead);
  if (!rules_.variant.is_other_statement(word)) return std::nullopt;
  return Fault{Cause::StatementNotAvailable, static_cast<std::uint32_t>(letter - s_.file),
               static_cast<std::uint32_t>(word.size()),
               word + " is a statement of programs that begin with %@MACRO"};
}

/// Return the fault of a macro statement that stands in the place of a word.
std::optional<Fault> WordScanner::statement_at(const char* letter) const {
  Scanner ahead = s_;
  ahead.at = letter;
  if (auto lacking = rules_.code.lacks(StatementKind::Brackets, 0)) {  // ABS[1], AX[1]
    while (is_letter(ahead.peek())) ++ahead.at;
    if (ahead.peek() == '[') return lacking;
    ahead.at = letter;
  }
  for (const std::string_view word :
       {"IF", "WHILE", "GOTO", "DO", "END", "WH", "DPRNT", "POPEN", "PCLOS"}) {
    Scanner probe = ahead;
    if (probe.take_word(word) && (word != "WH" || !is_letter(probe.peek())))
      return Fault{Cause::NcAndMacroInBlock, 0, static_cast<std::uint32_t>(word.size()),
                   "a macro statement cannot follow NC words in a block"};
  }
  return std::nullopt;
}

// ---- names ----

/// Return whether the brackets may hold a name: P[#100] holds a variable.
bool WordScanner::is_name_here() const {
  if (!control_.calls.bracket_names.value) return false;
  Scanner inside = s_;
  inside.take('[');
  const bool variable = inside.take('#');
  while (is_digit(inside.peek())) ++inside.at;
  return !variable || inside.peek() != ']';
}

/// Return whether a code of the block calls what P names: P[...] of G04 is an expression. The
/// answer is kept for all P of the block.
bool WordScanner::calls_by_name() {
  if (names_call_) return *names_call_;
  names_call_ = false;
  Scanner look = s_;
  for (look.at = s_.file + block_.text; look.at < s_.end && !*names_call_; ++look.at) {
    const char letter = upper(*look.at);
    if (letter != 'G' && letter != 'M') continue;
    Scanner behind = look;
    ++behind.at;
    const Number number = scan_number(behind);
    if (number.has_sign) continue;
    const auto role = [&](double code) {
      return control_.calls.roles.value.of({letter, to_whole<int>(code * 10 + 0.5)});
    };
    // G66.1 may have a role of its own.
    names_call_ = takes_name(role(number.value)) || takes_name(role(std::floor(number.value)));
  }
  return *names_call_;
}

/// Read a name up to the character that closes it.
bool WordScanner::name(Token& token, char close) {
  const char* start = s_.at;
  while (s_.at != s_.end && *s_.at != close) ++s_.at;
  std::string_view name(start, static_cast<std::size_t>(s_.at - start));
  while (!name.empty() && is_blank(name.front())) name.remove_prefix(1);
  while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
  const bool closed = s_.at != s_.end;
  if (closed) ++s_.at;
  token.name = name;
  token.operand.kind = Operand::Kind::Constant;
  token.operand.width = std::max(1u, s_.offset() - token.operand.at);
  std::string wrong =
      closed ? wrong_name(name) : std::string("the name is not closed with ") + close;
  return wrong.empty() || refuse(fault_of(token, Cause::IllegalProgramName, std::move(wrong)));
}

/// Return what is wrong with the name of a program; empty if nothing is.
std::string WordScanner::wrong_name(std::string_view name) const {
  if (name.empty()) return "the name is empty";
  if (name[0] == '.') return "a name must not begin with a point";
  std::size_t letters = 0;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool wide = byte >= 0x80 && control_.calls.wide_names.value;
    if (!is_inside_character(c)) ++letters;
    const bool mark = control_.calls.name_marks.value.has(c);
    if (!is_letter(c) && !is_digit(c) && !mark && !wide)
      return "a program name can have only letters, digits and " +
             std::string(control_.calls.name_marks.value.text());
  }
  if (letters > static_cast<std::size_t>(control_.calls.max_name_length.value))
    return "a program name has at most " + std::to_string(control_.calls.max_name_length.value) +
           " characters";
  return {};
}

}  // namespace cncsub
