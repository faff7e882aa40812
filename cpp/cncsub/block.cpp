#include "cncsub/block.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>

#include "cncsub/statement.hpp"

namespace cncsub {

namespace {

constexpr int kPlainLength = 200;
constexpr std::string_view kLengths =
    "ABCHIJKQRUVWXYZ";  // a whole number counts in increments where the control says so

std::int64_t key(char address, std::int32_t code) {
  return (static_cast<std::int64_t>(address) << 32) | code;
}

}  // namespace

BlockReader::BlockReader(Code& code, Patience& patience)
    : code_(code), control_(*code.control), patience_(patience) {
  for (const char c : control_.point_addresses.value)
    letters_[static_cast<unsigned char>(c)] |= kPoint;
  for (const char c : control_.minus_addresses.value)
    letters_[static_cast<unsigned char>(c)] |= kMinus;
  if (control_.whole_numbers.value == WholeNumbers::Increments)
    for (const char c : kLengths) letters_[static_cast<unsigned char>(c)] |= kLength;
  const auto list = [](const Rule<Codes>& rule, std::bitset<10001>& codes) {
    for_each_code(rule.value, [&](int code10) { codes.set(static_cast<std::size_t>(code10)); });
  };
  code_.list_statements();
  list(control_.g_codes, code_.g_codes);
  if (code_.g_codes.none() || !control_.g_codes_complete.value) code_.g_codes.set();
  list(control_.codes_not_with_call, not_with_call_);
  list(control_.codes_not_with_return, not_with_return_);
  list(control_.codes_not_with_macro_call, not_with_macro_);
  list(control_.codes_not_with_modal_call, not_with_modal_);
  list(control_.m_codes_not_with_macro_call, m_not_with_macro_);
  const std::string refused = " " + control_.refuses.value + " ";
  if (refused.find(" corner-with-call ") != std::string::npos)
    corners_not_with_call_ =
        " " + control_.chamfer_words.value + " " + control_.round_words.value + " ";
  register_calls();
  allow_plain();
}

void BlockReader::register_calls() {
  const auto value_of = [&](std::int32_t parameter) {
    return to_whole<std::int32_t>(control_.parameter(std::to_string(parameter)), -1'000'000'000,
                                  1'000'000'000);
  };
  if (const std::int32_t m = value_of(6030); m > 0 && m < 1000) external_m_ = m;
  for (const CodeCall& list : control_.code_calls) {
    if (!list.enable.empty() && control_.parameter(list.enable) == 0) continue;
    const auto add = [&](std::int32_t code, std::int32_t program) {
      CodeCallKind kind = list.kind;
      if (code < 0 && list.address == 'G') {  // a negative G code calls modally
        code = -code;
        kind = CodeCallKind::Modal;
      }
      char address = list.address;
      if (address == '@') {  // the parameter holds the letter, every code of which calls
        if (code < 'A' || code > 'Z') return;
        switches_.push_back({kind, program, list.variable, false, true});
        switched_[static_cast<std::size_t>(code - 'A')] = static_cast<int>(switches_.size());
        return;
      }
      if (code == 0 || code < list.first_code || code > list.last_code) return;
      const bool own =
          address == 'G' && code < 1000 && code_.g_codes.test(static_cast<std::size_t>(code) * 10);
      if (own && !list.own_codes) return;
      bool refused = false;
      for_each_code(list.refused, [&](int code10) { refused = refused || code10 == code * 10; });
      registered_.emplace(key(address, code),
                          RegisteredCall{kind, program, list.variable, refused, false});
    };
    switch (list.form) {
      case CodeCall::Form::List:
        for (std::int32_t i = 0; i < list.count; ++i)
          add(value_of(list.parameter + i), list.program + i);
        break;
      case CodeCall::Form::Range: {
        const std::int32_t first = value_of(list.parameter);
        const std::int32_t count = std::min(value_of(list.count), 1000);
        for (std::int32_t i = 0; i < count; ++i) add(first + i, value_of(list.program) + i);
        break;
      }
      case CodeCall::Form::Switch:
        switches_.push_back({list.kind, list.program, list.variable, false, false});
        switched_[static_cast<std::size_t>(list.address - 'A')] =
            static_cast<int>(switches_.size());
        break;
    }
  }
}

const RegisteredCall* BlockReader::registered(char address, double code) const {
  if (const int place = switched_[static_cast<std::size_t>(address - 'A')]; place != 0)
    return &switches_[static_cast<std::size_t>(place - 1)];
  if (registered_.empty() || std::fabs(code) > 1e9 || code != std::floor(code)) return nullptr;
  const auto found = registered_.find(key(address, to_whole<std::int32_t>(code)));
  return found == registered_.end() ? nullptr : &found->second;
}

void BlockReader::refuse(Block& block, Fault fault) {
  block.op = Op::Fault;
  block.aux = static_cast<std::uint32_t>(code_.faults.size());
  code_.faults.push_back(std::move(fault));
}

/// Blocks such as `N10 G1 X10.5 Y-3. F200` are most of what is read, and every control reads them
/// alike: they are compiled in one pass. Whatever is not that plain is left to the general way,
/// which gives the same code.
bool BlockReader::plain(const Scanner& s, Block& block) {
  const char* p = s.at;
  const char* const end = s.end;  // a character that is in no word stands there
  std::array<double, 26> values;  // NOLINT: written where the mask says so
  std::uint32_t mask = 0;
  int g = -1;
  std::int32_t n = -1;
  int words = 0;
  for (;;) {
    while (*p == ' ') ++p;
    if (p >= end) break;
    const char letter = *p++;
    const Plain what = plain_[static_cast<unsigned char>(letter)];
    if (what == Plain::No) return false;
    ++words;
    const bool negative = *p == '-';  // signs come as they like: nothing branches on them
    p += negative ? 1 : 0;
    const auto [mantissa, whole, decimals, point] = scan_mantissa(p);
    if (whole + decimals == 0 || whole + decimals > kMostDigits ||
        whole + (point ? 3 : 0) > control_.max_digits.value)
      return false;
    if (what == Plain::Value) {
      const std::uint8_t allowed = letters_[static_cast<unsigned char>(letter)];
      const std::uint32_t mark = bit(letter);
      if (decimals > 3 && control_.cuts_fine_digits.value) return false;
      const bool refused = (negative & ((allowed & kMinus) == 0)) |
                           (point ? (allowed & kPoint) == 0 : (allowed & kLength) != 0);
      if (refused || (mask & mark) != 0) return false;
      const double value =
          static_cast<double>(static_cast<std::int64_t>(mantissa)) / kPowersOfTen[decimals];
      values[static_cast<std::size_t>(letter - 'A')] = std::bit_cast<double>(
          std::bit_cast<std::uint64_t>(value) ^ static_cast<std::uint64_t>(negative) << 63);
      mask |= mark;
    } else if (point || negative) {
      return false;
    } else if (what == Plain::G) {
      if (g >= 0 || mantissa > 3 || !plain_g_[mantissa]) return false;
      g = static_cast<int>(mantissa);
    } else {
      if (words > 1 || mantissa == 0 ||
          mantissa > static_cast<std::uint64_t>(control_.max_sequence_number.value))
        return false;
      n = static_cast<std::int32_t>(mantissa);
    }
  }
  if (mask == 0 && g < 0) return false;
  block.n = n;
  block.mask = mask;
  block.data = static_cast<std::uint32_t>(code_.cells.size());
  const auto write = [this](double value) {
    Cell cell;  // NOLINT: written below
    cell.value = value;
    code_.cells.push_back(cell);
  };
  if (g >= 0) {
    block.g_count = 1;
    write(g * 10.0);
  }
  for (std::uint32_t left = mask; left != 0; left &= left - 1)
    write(values[static_cast<std::size_t>(std::countr_zero(left))]);
  mark_move(block, g);
  return true;
}

void BlockReader::allow_plain() {
  for (const char c : std::string_view("ABCFIJKRUVWXYZ"))
    if (switched_[static_cast<std::size_t>(c - 'A')] == 0)
      plain_[static_cast<unsigned char>(c)] = Plain::Value;
  plain_['G'] = Plain::G;
  plain_['N'] = Plain::N;
  for (std::size_t g = 0; g < plain_g_.size(); ++g)
    plain_g_[g] = code_.g_codes.test(g * 10) && !not_with_call_.test(g * 10) &&
                  registered('G', static_cast<double>(g)) == nullptr;
  // A plain block is short: within every limit but an unusually tight one.
  const int length = control_.max_block_length.value, words = control_.max_words.value;
  if ((length > 0 && length < kPlainLength) || (words > 0 && words < 20)) plain_.fill(Plain::No);
}

/// A block of nothing but G00 or G01 (or no G), X, Y, Z and F is a linear move; with G02 or G03 (or
/// no G) and words of a centre a round one.
void BlockReader::mark_move(Block& block, int g) {
  constexpr std::uint32_t kAxesAndFeed = bit('X') | bit('Y') | bit('Z') | bit('F');
  constexpr std::uint32_t kCentre = bit('I') | bit('J') | bit('K');
  const bool round = g < 0 ? (block.mask & kCentre) != 0 : g >= 2;
  if (block.mask == 0 || (block.mask & ~(kAxesAndFeed | (round ? kCentre : 0))) != 0 || g > 3)
    return;
  if (round && (block.mask & kCentre) == 0) return;
  block.op = round ? Op::Round : Op::Linear;
  block.flags = g < 0 ? Block::kNoG : g % 2 == 1 ? Block::kSecondG : std::uint8_t{0};
}

void BlockReader::read(Scanner s, Block& block) {
  block.op = Op::Words;
  if (s.end - s.at < kPlainLength && plain(s, block)) return;
  if (!head(s, block)) return;
  const std::uint32_t start = block.text;
  if (control_.max_block_length.value > 0 &&
      s.end - (s.file + start) > static_cast<std::ptrdiff_t>(control_.max_block_length.value))
    return refuse(block, {Cause::BlockTooLong, start, 1,
                          "a block has at most " + std::to_string(control_.max_block_length.value) +
                              " characters"});
  if (control_.conditional_return.value && s.peek() == '[') return conditional_return(s, block);
  StatementReader statement(code_, s, block);
  if (statement.read()) return;
  tokens_.clear();
  if (!scan_words(s, block)) return;
  build(block, tokens_, true);
}

/// `[#1 LT 10] M99 P10`: M99 is kept as a block of its own, as what stands behind THEN is.
void BlockReader::conditional_return(Scanner s, Block& block) {
  Statement statement;
  statement.at = s.offset();
  ExpressionReader reader(code_, s);
  const auto condition = reader.condition();
  if (!condition) return refuse(block, reader.fault());
  statement.expression = *condition;
  statement.width = s.offset() - statement.at;
  Block back = block;
  tokens_.clear();
  if (scan_words(s, back)) build(back, tokens_, true);
  if (back.op == Op::Fault) {
    block.op = Op::Fault;
    block.aux = back.aux;
    return;
  }
  if (back.op != Op::Return)
    return refuse(block, {Cause::StatementFormat, statement.at, statement.width,
                          "a condition at the head of a block stands before M99"});
  statement.then = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(back);
  block.op = Op::IfThen;
  block.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(statement);
}

/// Block-skip slashes and the sequence number. False where the block is faulty.
bool BlockReader::head(Scanner& s, Block& block) {
  for (;;) {
    const char c = s.peek();
    if (c == '/') {
      skip_slash(s, block.skip);
    } else if (c == 'N' && block.n < 0) {
      Scanner ahead = s;
      ++ahead.at;
      if (is_letter(ahead.peek())) return true;
      s = ahead;
      if (!sequence_number(s, block)) return false;
    } else {
      return true;
    }
  }
}

/// A slash, and the number of its switch: 1 where none stands.
void BlockReader::skip_slash(Scanner& s, std::uint16_t& mask) {
  ++s.at;
  const char c = s.peek();
  const bool numbered = c >= '1' && c <= '9';
  if (numbered) ++s.at;
  mask = static_cast<std::uint16_t>(mask | (1u << (numbered ? c - '0' : 1)));
}

bool BlockReader::sequence_number(Scanner& s, Block& block) {
  const std::uint32_t at = s.offset() - 1;
  const char c = s.peek();
  const auto wrong = [&](Cause cause, std::string detail) {
    refuse(block, {cause, at, std::max(1u, s.offset() - at), std::move(detail)});
    return false;
  };
  if (c == '#' || c == '[')
    return wrong(Cause::IllegalSequenceNumber, "a sequence number cannot come from a variable");
  const Number number = scan_number(s);
  if (!number.any) return wrong(Cause::AddressWithoutValue, "N without a number");
  if (number.points != 0)
    return wrong(Cause::IllegalDecimalPoint, "a sequence number has no point");
  if (number.has_sign) return wrong(Cause::IllegalMinusSign, "a sequence number has no sign");
  if (number.value > control_.max_sequence_number.value)
    return wrong(
        Cause::IllegalSequenceNumber,
        "the largest sequence number is " + std::to_string(control_.max_sequence_number.value));
  if (number.value == 0 && !control_.zero_numbers.value)
    return wrong(Cause::ProgramNumberZero, "N0 is no sequence number");
  block.n = to_whole<std::int32_t>(number.value);
  return true;
}

bool BlockReader::scan_words(Scanner& s, Block& block) {
  std::uint16_t slashes = block.skip;
  for (;;) {
    char c = s.peek();
    if (c == '\0' && s.at == s.end) break;
    if (patience_.over(1)) return false;
    Token token;
    token.operand.at = s.offset();
    if (c == ',') {
      ++s.at;
      token.comma = true;
      c = s.peek();
      if (c != 'C' && c != 'R' && c != 'A' && c != 'D') return stray(s, block);
    }
    if (!is_letter(c)) {
      if (c == '/') {
        const std::uint32_t at = s.offset();
        if (control_.block_skip.value == BlockSkip::HeadOnly) {
          refuse(block, {Cause::IllegalCharacter, at, 1,
                         "a block-skip slash stands only at the head of a block"});
          return false;
        }
        token.letter = '/';
        skip_slash(s, token.skip);
        // A second slash of one switch says nothing new: the first has dropped the rest, or none
        // does.
        if ((token.skip & slashes) == 0) tokens_.push_back(token);
        slashes = static_cast<std::uint16_t>(slashes | token.skip);
        continue;
      }
      if (c == '<' && control_.named_programs.value) {
        token.letter = '<';
        ++s.at;
        if (!scan_name(s, block, token, '>')) return false;
        tokens_.push_back(token);
        continue;
      }
      if (c == ')' && control_.open_comment.value == OpenComment::RestOfBlock) {
        s.rest_of_comment();
        if (s.peek() != ')') continue;
      }
      return stray(s, block);
    }
    token.letter = c;
    if (c == 'N' && !token.comma) {
      if (control_.sequence_number_first.value) {
        refuse(block, {Cause::SequenceNumberNotFirst, s.offset(), 1,
                       "N must be the first word of its block"});
        return false;
      }
      if (block.n < 0) {
        ++s.at;
        token.late = true;
        if (!sequence_number(s, block)) return false;
        if (!control_.late_sequence_numbers.value) block.n = -1;
        tokens_.push_back(token);
        continue;
      }
    }
    if (!scan_value(s, block, token)) return false;
    tokens_.push_back(token);
  }
  return true;
}

/// Something that is no word.
bool BlockReader::stray(Scanner& s, Block& block) {
  const char c = s.peek();
  const std::uint32_t at = s.offset();
  Fault fault{Cause::IllegalCharacter, at, 1, ""};
  if (c == '#') {
    fault = {Cause::NcAndMacroInBlock, at, 1, "a macro statement stands behind NC words"};
  } else if (is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[') {
    fault = {Cause::ValueWithoutAddress, at, 1, "a value stands without an address"};
  } else if (c == ']') {
    fault = {Cause::BracketNotOpened, at, 1, "this bracket was never opened"};
  } else {
    std::uint32_t width = 1;
    while (s.at + width < s.end && (static_cast<unsigned char>(s.at[width]) & 0xC0u) == 0x80u)
      ++width;
    fault.width = width;
    fault.detail = "the control does not know this character";
    const std::string_view character(s.at, width);
    const bool wide = character == "\uFF08" || character == "\uFF09";  // full-width
    if ((wide || c == ')') && control_.open_comment.value == OpenComment::Alarm) {
      fault.cause = Cause::CommentNotClosed;
      fault.detail =
          wide ? "a full-width parenthesis begins no comment" : "this parenthesis ends no comment";
    }
  }
  refuse(block, fault);
  return false;
}

bool BlockReader::scan_value(Scanner& s, Block& block, Token& token) {
  Operand& operand = token.operand;
  const char* letter_at = s.at;
  ++s.at;
  const char* value_at = s.at;
  char c = s.at == s.end ? '\0' : *s.at;
  if (is_blank(c) || c == '(') {
    c = s.peek();
    value_at = s.at;
  }
  if (is_digit(c) || c == '.' || c == '-' || c == '+') {
    if (c == '-' || c == '+') {
      Scanner ahead = s;
      ++ahead.at;
      const char next = ahead.peek();
      if (next == '#' || next == '[') c = next;
    }
    if (c != '#' && c != '[') {
      const Number number = scan_number(s);
      if (control_.numbered_axis_arguments.value && token.axis == 0 && number.points == 0 &&
          number.any && s.peek() == '=' && number.value >= 1 && number.value <= 2 &&
          token.letter >= 'X') {
        ++s.at;
        token.axis = to_whole<std::uint8_t>(number.value);
        --s.at;
        return scan_value(s, block, token);  // the equals sign stands where the letter did
      }
      operand.kind = Operand::Kind::Constant;
      operand.value = number.value;
      operand.digits = static_cast<std::uint8_t>(std::min<std::uint32_t>(number.digits, 255));
      operand.written = static_cast<std::uint8_t>(std::min<std::uint32_t>(number.written, 255));
      operand.whole = number.points == 0;
      operand.fine = number.decimals > 3 && kLengths.find(token.letter) != std::string_view::npos;
      operand.width = std::max(1u, s.offset() - operand.at);
      if (auto fault = check_number(token, number)) {
        fault->at = operand.at;
        fault->width = operand.width;
        refuse(block, *fault);
        return false;
      }
      return true;
    }
  }
  if (c == '[' && token.letter == 'P' && control_.bracket_names.value &&
      bracket_name(s, block, token))
    return block.op != Op::Fault;
  if (c == '#' || c == '[') {
    if (token.letter == 'O') {
      refuse(block, {Cause::AddressNotUsable, operand.at, 1,
                     "a program number cannot come from a variable"});
      return false;
    }
    s.at = value_at;
    ExpressionReader reader(code_, s);
    const auto value = reader.word_value(token.letter);
    if (!value) {
      refuse(block, reader.fault());
      return false;
    }
    operand.kind = Operand::Kind::Expression;
    operand.expression = *value;
    operand.bracketed = c == '[';
    operand.width = std::max(1u, s.offset() - operand.at);
    return true;
  }
  if (token.letter == 'G' && control_.bare_g.value) {
    operand.kind = Operand::Kind::Constant;
    operand.whole = true;
    return true;
  }
  if (is_letter(c)) {
    Scanner ahead = s;
    ahead.at = letter_at;
    if (const auto lacking = code_.lacks(StatementKind::Brackets, operand.at)) {  // ABS[1], AX[1]
      while (is_letter(ahead.peek())) ++ahead.at;
      if (ahead.peek() == '[') {
        refuse(block, *lacking);
        return false;
      }
      ahead.at = letter_at;
    }
    for (const std::string_view word :
         {"IF", "WHILE", "GOTO", "DO", "END", "WH", "DPRNT", "POPEN", "PCLOS"}) {
      Scanner probe = ahead;
      if (probe.take_word(word) && (word != "WH" || !is_letter(probe.peek()))) {
        refuse(block,
               {Cause::NcAndMacroInBlock, operand.at, static_cast<std::uint32_t>(word.size()),
                "a macro statement stands behind NC words"});
        return false;
      }
    }
  }
  refuse(block, {Cause::AddressWithoutValue, operand.at, 1,
                 std::string(1, token.letter) + " stands without a value"});
  return false;
}

/// P[NAME], or P[#100] which is read as an expression. True where a name stands here (or the block
/// was refused).
bool BlockReader::bracket_name(Scanner& s, Block& block, Token& token) {
  Scanner inside = s;
  inside.take('[');
  const bool variable = inside.take('#');
  while (is_digit(inside.peek())) ++inside.at;
  if (variable && inside.peek() == ']') return false;
  const std::string_view whole(s.file + block.text,
                               static_cast<std::size_t>(s.end - s.file) - block.text);
  const auto says = [&](std::string_view word) {
    Scanner look = s;
    for (look.at = whole.data(); look.at < s.end; ++look.at)
      if (upper(*look.at) == word[0]) {
        Scanner probe = look;
        ++probe.at;
        while (probe.peek() == '0') ++probe.at;
        if (probe.take_word(word.substr(1)) && !is_digit(probe.peek())) return true;
      }
    return false;
  };
  if (call_file_ != s.file || call_text_ != block.text) {  // asked once for all P of a block
    call_file_ = s.file;
    call_text_ = block.text;
    names_call_ = says("M98") || says("M198") || says("G65") || says("G66");
  }
  if (!names_call_) return false;  // G04 P[...] takes an expression
  s.take('[');
  token.letter = '<';
  scan_name(s, block, token, ']');
  return true;
}

bool BlockReader::scan_name(Scanner& s, Block& block, Token& token, char close) {
  const char* start = s.at;
  while (s.at != s.end && *s.at != close) ++s.at;
  token.operand.kind = Operand::Kind::Constant;
  token.name = std::string_view(start, static_cast<std::size_t>(s.at - start));
  while (!token.name.empty() && is_blank(token.name.front())) token.name.remove_prefix(1);
  while (!token.name.empty() && is_blank(token.name.back())) token.name.remove_suffix(1);
  const auto wrong = [&](std::string detail) {
    token.operand.width = std::max(1u, s.offset() - token.operand.at);
    refuse(block,
           {Cause::IllegalProgramName, token.operand.at, token.operand.width, std::move(detail)});
    return false;
  };
  if (s.at == s.end) return wrong(std::string("the name is not closed with ") + close);
  ++s.at;
  token.operand.width = std::max(1u, s.offset() - token.operand.at);
  if (token.name.empty()) return wrong("the name is empty");
  if (token.name[0] == '.') return wrong("a name does not begin with a point");
  std::size_t letters = 0;
  for (const char c : token.name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool wide = byte >= 0x80;
    if ((byte & 0xC0u) != 0x80u) ++letters;
    const bool mark = control_.name_marks.value.find(c) != std::string::npos;
    if (!is_letter(c) && !is_digit(c) && !mark && !(wide && control_.wide_names.value))
      return wrong("a program name has letters, digits and " + control_.name_marks.value + " only");
  }
  if (letters > static_cast<std::size_t>(control_.max_name_length.value))
    return wrong("a program name has at most " + std::to_string(control_.max_name_length.value) +
                 " characters");
  return true;
}

/// What is wrong whatever the word is for; what only an argument of a macro may have is kept in the
/// token.
std::optional<Fault> BlockReader::check_number(Token& token, const Number& number) const {
  const std::uint8_t allowed = letters_[static_cast<unsigned char>(token.letter)];
  if (!number.any)
    return Fault{.cause = Cause::AddressWithoutValue,
                 .detail = std::string(1, token.letter) + " stands without a value"};
  if (number.points > 1)
    return Fault{.cause = Cause::IllegalDecimalPoint, .detail = "two points in one number"};
  const std::uint32_t digits = number.points == 1 ? number.whole_digits + 3 : number.digits;
  token.odd = true;
  if (number.points == 1 && (allowed & kPoint) == 0 && token.letter != 'G')
    token.wrong = Cause::IllegalDecimalPoint;
  else if (number.negative && (allowed & kMinus) == 0)
    token.wrong = Cause::IllegalMinusSign;
  else if (digits > static_cast<std::uint32_t>(most_digits(control_)))
    token.wrong = Cause::TooManyDigits;
  else
    token.odd = false;
  return std::nullopt;
}

Fault BlockReader::odd_word(const Token& token) const {
  const std::string letter(1, token.letter);
  std::string detail = letter + " takes no minus sign";
  if (token.wrong == Cause::IllegalDecimalPoint) detail = letter + " takes no decimal point";
  if (token.wrong == Cause::TooManyDigits)
    detail = "a number has at most " + std::to_string(most_digits(control_)) + " digits";
  return {token.wrong, token.operand.at, token.operand.width, std::move(detail)};
}

}  // namespace cncsub
