#include "cncsub/block.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <string>

#include "cncsub/statement.hpp"

namespace cncsub {

namespace {

constexpr int kPlainLength = 200;
constexpr std::uint8_t kPoint = 1, kMinus = 2, kLength = 4;
constexpr std::string_view kLengths =
    "ABCIJKQRUVWXYZ";  // a whole number counts in increments where the control says so

std::int64_t key(char address, std::int32_t code) {
  return (static_cast<std::int64_t>(address) << 32) | code;
}

/// Calls `use` for each code of a list such as "0 1 54.1", as ten times the code.
template <class Use>
void for_each_code(const Codes& codes, Use&& use) {
  const char* at = codes.data();
  const char* end = at + codes.size();
  while (at < end) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc()) {
      ++at;
      continue;
    }
    if (value >= 0 && value <= 1000) use(static_cast<int>(value * 10 + 0.5));
    at = read.ptr + 1;
  }
}

std::string spell(double value) {
  std::array<char, 32> text{};
  const auto done = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), done.ptr};
}

/// Ten times a written code, as an index into the sets of codes.
std::size_t code_index(const Operand& operand) {
  const bool known =
      operand.kind == Operand::Kind::Constant && operand.value >= 0 && operand.value < 1000;
  return known ? static_cast<std::size_t>(operand.value * 10 + 0.5) : std::size_t{10000};
}

/// #i of an argument letter by specification I, 0 for the letters that are none.
int argument_variable(char letter) {
  static constexpr int kVariables[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kVariables[letter - 'A'];
}

}  // namespace

/// What the words of a block say together.
struct BlockReader::Meaning {
  const Token* call = nullptr;  // M98, G65, a calling code ...
  const Token* second_call = nullptr;
  CallKind kind = CallKind::M98;
  CodeCallKind code_kind = CodeCallKind::Subprogram;
  const RegisteredCall* registered = nullptr;
  const Token* back = nullptr;    // M99
  const Token* jump = nullptr;    // M97
  const Token* end = nullptr;     // M02, M30
  const Token* cancel = nullptr;  // G67
  std::array<const Token*, 12> g{};
  std::array<const Token*, 12> m{};
  int g_count = 0;
  int m_count = 0;
  const Token* lonely = nullptr;  // an M code that wants to be alone
  int m_words = 0;

  bool calls_macro() const { return call != nullptr && is_macro(kind, code_kind); }
};

BlockReader::BlockReader(Code& code) : code_(code), control_(*code.control) {
  for (const char c : control_.point_addresses.value)
    letters_[static_cast<std::size_t>(c)] |= kPoint;
  for (const char c : control_.minus_addresses.value)
    letters_[static_cast<std::size_t>(c)] |= kMinus;
  if (control_.whole_numbers.value == WholeNumbers::Increments)
    for (const char c : kLengths) letters_[static_cast<std::size_t>(c)] |= kLength;
  const auto list = [](const Rule<Codes>& rule, std::bitset<10001>& codes) {
    for_each_code(rule.value, [&](int code10) { codes.set(static_cast<std::size_t>(code10)); });
  };
  list(control_.g_codes, code_.g_codes);
  if (code_.g_codes.none()) code_.g_codes.set();
  list(control_.codes_not_with_call, not_with_call_);
  list(control_.codes_not_with_return, not_with_return_);
  list(control_.codes_not_with_macro_call, not_with_macro_);
  list(control_.codes_not_with_modal_call, not_with_modal_);
  list(control_.m_codes_not_with_macro_call, m_not_with_macro_);
  register_calls();
  allow_plain();
}

void BlockReader::register_calls() {
  const auto value_of = [&](std::int32_t parameter) {
    return static_cast<std::int32_t>(control_.parameter(std::to_string(parameter)));
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
  if (registered_.empty() || code != static_cast<std::int32_t>(code)) return nullptr;
  const auto found = registered_.find(key(address, static_cast<std::int32_t>(code)));
  return found == registered_.end() ? nullptr : &found->second;
}

void BlockReader::refuse(Block& block, Fault fault) {
  block.op = Op::Fault;
  block.aux = static_cast<std::uint32_t>(code_.faults.size());
  code_.faults.push_back(std::move(fault));
}

// ---- reading words ----

/// Blocks such as `N10 G1 X10.5 Y-3. F200` are most of what is read, and every control reads them
/// alike: they are compiled in one pass. Whatever is not that plain is left to the general way,
/// which gives the same code.
bool BlockReader::plain(const Scanner& s, Block& block) {
  const char* p = s.at;
  const char* const end = s.end;
  std::array<double, 26> values;  // NOLINT: written where the mask says so
  std::uint32_t mask = 0;
  int g = -1;
  std::int32_t n = -1;
  int words = 0;
  for (;;) {
    while (p != end && *p == ' ') ++p;
    if (p == end) break;
    const char letter = *p++;
    const Plain what = plain_[static_cast<unsigned char>(letter)];
    if (what == Plain::No) return false;
    ++words;
    const bool negative = p != end && *p == '-';
    if (negative) ++p;
    std::uint64_t mantissa = 0;
    const char* first = p;
    while (p != end && is_digit(*p))
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    const auto whole = p - first;
    std::ptrdiff_t decimals = 0;
    const bool point = p != end && *p == '.';
    if (point) {
      first = ++p;
      while (p != end && is_digit(*p))
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
      decimals = p - first;
    }
    if (whole + decimals == 0 || whole + decimals > 15 ||
        whole + (point ? 3 : 0) > control_.max_digits.value)
      return false;
    if (what == Plain::Value) {
      const std::uint8_t allowed = letters_[static_cast<std::size_t>(letter)];
      const std::uint32_t mark = bit(letter);
      if (decimals > 3 && control_.cuts_fine_digits.value) return false;
      const bool refused = (negative && (allowed & kMinus) == 0) ||
                           (point ? (allowed & kPoint) == 0 : (allowed & kLength) != 0);
      if (refused || (mask & mark) != 0) return false;
      const double value = static_cast<double>(mantissa) / kPowersOfTen[decimals];
      values[static_cast<std::size_t>(letter - 'A')] = negative ? -value : value;
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
  const std::size_t count = static_cast<std::size_t>(std::popcount(mask)) + (g >= 0 ? 1 : 0);
  code_.cells.resize(code_.cells.size() + count);
  Cell* cell = code_.cells.data() + block.data;
  if (g >= 0) {
    block.g_count = 1;
    (cell++)->value = g * 10.0;
  }
  for (std::uint32_t left = mask; left != 0; left &= left - 1)
    (cell++)->value = values[static_cast<std::size_t>(std::countr_zero(left))];
  mark_linear(block, g);
  return true;
}

void BlockReader::allow_plain() {
  for (const char c : std::string_view("ABCFIJKRUVWXYZ"))
    if (switched_[static_cast<std::size_t>(c - 'A')] == 0)
      plain_[static_cast<std::size_t>(c)] = Plain::Value;
  plain_['G'] = Plain::G;
  plain_['N'] = Plain::N;
  for (std::size_t g = 0; g < plain_g_.size(); ++g)
    plain_g_[g] = code_.g_codes.test(g * 10) && !not_with_call_.test(g * 10) &&
                  registered('G', static_cast<double>(g)) == nullptr;
  // A plain block is short: within every limit but an unusually tight one.
  const int length = control_.max_block_length.value, words = control_.max_words.value;
  if ((length > 0 && length < kPlainLength) || (words > 0 && words < 20)) plain_.fill(Plain::No);
}

/// A block of nothing but G00 or G01 (or no G), X, Y, Z and F is a linear move.
void BlockReader::mark_linear(Block& block, int g) {
  constexpr std::uint32_t kAxesAndFeed = bit('X') | bit('Y') | bit('Z') | bit('F');
  if (block.mask == 0 || (block.mask & ~kAxesAndFeed) != 0 || g > 1) return;
  block.op = Op::Linear;
  block.flags = g < 0 ? Block::kNoG : g == 1 ? Block::kSecondG : std::uint8_t{0};
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
  StatementReader statement(code_, s, block);
  if (statement.read()) return;
  tokens_.clear();
  if (!scan_words(s, block)) return;
  build(block, tokens_, true);
}

/// Block-skip slashes and the sequence number. False where the block is faulty.
bool BlockReader::head(Scanner& s, Block& block) {
  for (;;) {
    const char c = s.peek();
    if (c == '/') {
      if (!skip_slash(s, block.skip)) return true;
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

bool BlockReader::skip_slash(Scanner& s, std::uint16_t& mask) {
  ++s.at;
  const char c = s.peek();
  if (c >= '1' && c <= '9') {
    ++s.at;
    mask = static_cast<std::uint16_t>(mask | (1u << (c - '0')));
  } else {
    mask = static_cast<std::uint16_t>(mask | 2u);
  }
  return true;
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
  if (number.signed_) return wrong(Cause::IllegalMinusSign, "a sequence number has no sign");
  if (number.value > control_.max_sequence_number.value)
    return wrong(
        Cause::IllegalSequenceNumber,
        "the largest sequence number is " + std::to_string(control_.max_sequence_number.value));
  if (number.value == 0 && !control_.zero_numbers.value)
    return wrong(Cause::ProgramNumberZero, "N0 is no sequence number");
  block.n = static_cast<std::int32_t>(number.value);
  return true;
}

bool BlockReader::scan_words(Scanner& s, Block& block) {
  for (;;) {
    char c = s.peek();
    if (c == '\0' && s.at == s.end) break;
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
        tokens_.push_back(token);
        continue;
      }
      if (c == '<' && control_.named_programs.value) {
        token.letter = '<';
        ++s.at;
        if (!scan_name(s, block, token, '>')) return false;
        tokens_.push_back(token);
        continue;
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
    const bool parenthesis = character == "\uFF08" || character == "\uFF09";  // full-width
    if (parenthesis && control_.open_comment.value == OpenComment::Alarm) {
      fault.cause = Cause::CommentNotClosed;
      fault.detail = "a full-width parenthesis begins no comment";
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
      if (control_.numbered_axis_arguments.value && number.points == 0 && number.any &&
          s.peek() == '=' && number.value >= 1 && number.value <= 2 && token.letter >= 'X') {
        ++s.at;
        token.axis = static_cast<std::uint8_t>(number.value);
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
  if (!says("M98") && !says("M198") && !says("G65") && !says("G66"))
    return false;  // G04 P[...] takes an expression
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
  const std::uint8_t allowed = letters_[static_cast<std::size_t>(token.letter)];
  if (!number.any)
    return Fault{Cause::AddressWithoutValue, 0, 1,
                 std::string(1, token.letter) + " stands without a value"};
  if (number.points > 1) return Fault{Cause::IllegalDecimalPoint, 0, 1, "two points in one number"};
  const std::uint32_t digits = number.points == 1 ? number.whole_digits + 3 : number.digits;
  token.odd = true;
  if (number.points == 1 && (allowed & kPoint) == 0 && token.letter != 'G')
    token.wrong = Cause::IllegalDecimalPoint;
  else if (number.negative && (allowed & kMinus) == 0)
    token.wrong = Cause::IllegalMinusSign;
  else if (digits > static_cast<std::uint32_t>(control_.max_digits.value) && token.letter != 'P')
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
    detail = "a number has at most " + std::to_string(control_.max_digits.value) + " digits";
  return {token.wrong, token.operand.at, token.operand.width, std::move(detail)};
}

// ---- what the words say ----

void BlockReader::build(Block& block, const Tokens& tokens, bool calls) {
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (tokens[i].letter == '/') return build_slash(block, tokens, i, calls);
  Meaning meaning;
  auto fault = sort(tokens, calls, meaning);
  if (!fault && control_.max_words.value > 0 && !meaning.calls_macro() &&
      tokens.size() > static_cast<std::size_t>(control_.max_words.value))
    fault = {Cause::TooManyWords, block.text, 1,
             "a block has at most " + std::to_string(control_.max_words.value) + " words"};
  if (!fault) fault = check_together(tokens, meaning);
  if (fault) return refuse(block, *fault);
  if (meaning.registered != nullptr &&
      calls) {  // inside a program that a code called, codes may not call
    Variant variant;
    variant.address = meaning.call->letter;
    Block first = block;
    Block second = block;
    build_call(first, tokens, meaning);
    build(second, tokens, false);
    variant.first = static_cast<std::uint32_t>(code_.variants.size());
    code_.variants.push_back(first);
    variant.second = static_cast<std::uint32_t>(code_.variants.size());
    code_.variants.push_back(second);
    block.op = Op::Choose;
    block.aux = static_cast<std::uint32_t>(code_.choices.size());
    code_.choices.push_back(variant);
    return;
  }
  if (meaning.call != nullptr) return build_call(block, tokens, meaning);
  if (meaning.back != nullptr) return build_return(block, tokens, meaning);
  if (meaning.jump != nullptr) return build_jump(block, tokens, meaning);
  write_words(block, tokens, meaning);
  if (meaning.cancel != nullptr) block.op = Op::CancelModal;
  if (meaning.end != nullptr) block.op = Op::EndProgram;
}

/// A slash that is not at the head: the words behind it do not count while its switch is on.
void BlockReader::build_slash(Block& block, const Tokens& tokens, std::size_t slash, bool calls) {
  Tokens without(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(slash));
  Tokens with = without;
  with.insert(with.end(), tokens.begin() + static_cast<std::ptrdiff_t>(slash) + 1, tokens.end());
  Variant variant;
  variant.skip = tokens[slash].skip;
  Block first = block;
  Block second = block;
  build(first, with, calls);
  build(second, without, calls);
  variant.first = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(first);
  variant.second = static_cast<std::uint32_t>(code_.variants.size());
  code_.variants.push_back(second);
  block.op = Op::Choose;
  block.aux = static_cast<std::uint32_t>(code_.choices.size());
  code_.choices.push_back(variant);
}

std::optional<Fault> BlockReader::sort(const Tokens& tokens, bool calls, Meaning& meaning) const {
  for (const Token& token : tokens) {
    std::optional<Fault> fault;
    const bool argument = meaning.calls_macro() && token.letter != 'P' && token.letter != 'L';
    if (token.odd && !argument) return odd_word(token);
    if (token.late) continue;
    if (token.letter == 'G') {
      fault = sort_g(token, calls, meaning);
    } else if (token.letter == 'M') {
      // Behind G65 and its family every letter but G L N O P is an argument.
      if (meaning.calls_macro()) continue;
      fault = sort_m(token, calls, meaning);
    } else if (token.letter == 'O') {
      fault = Fault{Cause::AddressNotUsable, token.operand.at, token.operand.width,
                    "a program number stands at the head of a program only"};
    } else if (calls && !token.comma && token.letter != '<' && token.letter != 'P' &&
               token.letter != 'L' && !meaning.calls_macro() &&
               token.operand.kind == Operand::Kind::Constant) {
      if (const RegisteredCall* found = registered(token.letter, token.operand.value)) {
        if (meaning.call != nullptr) meaning.second_call = &token;
        meaning.call = &token;
        meaning.registered = found;
        meaning.code_kind = found->kind;
        meaning.kind = found->ascii          ? CallKind::Ascii
                       : token.letter == 'T' ? CallKind::TCode
                       : token.letter == 'S' ? CallKind::SCode
                       : token.letter == 'B' ? CallKind::BCode
                                             : CallKind::Ascii;
      }
    }
    if (fault) return fault;
  }
  return std::nullopt;
}

std::optional<Fault> BlockReader::sort_g(const Token& token, bool calls, Meaning& meaning) const {
  const Operand& operand = token.operand;
  const auto full = [&] {
    return Fault{Cause::TooManyWords, operand.at, operand.width, "too many G codes in one block"};
  };
  if (operand.kind == Operand::Kind::Expression) {
    if (static_cast<std::size_t>(meaning.g_count) == meaning.g.size()) return full();
    meaning.g[static_cast<std::size_t>(meaning.g_count++)] = &token;
    return std::nullopt;
  }
  const double code = operand.value;
  const auto code10 = static_cast<int>(code_index(operand));
  const auto call = [&](CallKind kind, CodeCallKind code_kind, const RegisteredCall* found) {
    if (meaning.call != nullptr) {
      if (!meaning.second_call) meaning.second_call = &token;
      return;
    }
    meaning.call = &token;
    meaning.kind = kind;
    meaning.code_kind = code_kind;
    meaning.registered = found;
  };
  if (calls && meaning.call == nullptr) {
    if (const RegisteredCall* found = registered('G', code)) {
      call(CallKind::GCode, found->kind, found);
      return std::nullopt;
    }
  }
  if (control_.macro_calls.value) {
    if (code10 == 650) return call(CallKind::G65, CodeCallKind::Macro, nullptr), std::nullopt;
    if (code10 == 660) return call(CallKind::G66, CodeCallKind::Modal, nullptr), std::nullopt;
    if (code10 == 661 && control_.modal_every_block.value)
      return call(CallKind::G661, CodeCallKind::ModalEveryBlock, nullptr), std::nullopt;
    if (code10 == 670) {
      meaning.cancel = &token;
      return std::nullopt;
    }
  }
  const bool macro_code = code10 >= 650 && code10 <= 670;
  const bool known = code >= 0 && code < 1000 &&
                     code_.g_codes.test(static_cast<std::size_t>(code10)) &&
                     (!macro_code || control_.macro_calls.value);
  if (!known)
    return Fault{Cause::GCodeNotAvailable, operand.at, operand.width,
                 "G" + spell(code) + " is no code of this control"};
  if (meaning.calls_macro()) return std::nullopt;  // told as an argument
  if (static_cast<std::size_t>(meaning.g_count) == meaning.g.size()) return full();
  meaning.g[static_cast<std::size_t>(meaning.g_count++)] = &token;
  return std::nullopt;
}

std::optional<Fault> BlockReader::sort_m(const Token& token, bool calls, Meaning& meaning) const {
  const Operand& operand = token.operand;
  ++meaning.m_words;
  if (operand.kind == Operand::Kind::Constant) {
    const double code = operand.value;
    if (code == 0 || code == 1 || code == 2 || code == 30 || code == 98 || code == 99 ||
        code == external_m_)
      meaning.lonely = &token;
    const auto call = [&](CallKind kind, CodeCallKind code_kind, const RegisteredCall* found) {
      if (meaning.call != nullptr) {
        meaning.second_call = &token;
        return;
      }
      meaning.call = &token;
      meaning.kind = kind;
      meaning.code_kind = code_kind;
      meaning.registered = found;
    };
    if (calls) {
      if (const RegisteredCall* found = registered('M', code)) {
        if (found->refused)
          return Fault{Cause::CodeMayNotCall, operand.at, operand.width,
                       "M" + spell(code) + " may not call a program"};
        meaning.lonely = &token;
        call(CallKind::MCode, found->kind, found);
        return std::nullopt;
      }
    }
    if (code == 98) return call(CallKind::M98, CodeCallKind::Subprogram, nullptr), std::nullopt;
    if (code == external_m_ && control_.external_calls.value)
      return call(CallKind::M198, CodeCallKind::Subprogram, nullptr), std::nullopt;
    if (code == 99) {
      meaning.back = &token;
      return std::nullopt;
    }
    if (code == 97 && control_.jump_m97.value) {
      meaning.jump = &token;
      return std::nullopt;
    }
    if (code == 2 || code == 30) {
      meaning.end = &token;
      return std::nullopt;
    }
  }
  if (static_cast<std::size_t>(meaning.m_count) == meaning.m.size())
    return Fault{Cause::TooManyWords, operand.at, operand.width, "too many M codes in one block"};
  meaning.m[static_cast<std::size_t>(meaning.m_count++)] = &token;
  return std::nullopt;
}

std::optional<Fault> BlockReader::check_together(const Tokens& tokens,
                                                 const Meaning& meaning) const {
  const auto at = [](Cause cause, const Token& token, std::string detail) {
    return Fault{cause, token.operand.at, token.operand.width, std::move(detail)};
  };
  if (meaning.second_call != nullptr) {
    const bool macros = meaning.calls_macro() && meaning.second_call->letter == 'G';
    return at(macros ? Cause::MacroCallGivenTwice : Cause::CallGivenTwice, *meaning.second_call,
              "a block calls once");
  }
  if (meaning.call != nullptr && meaning.back != nullptr)
    return at(Cause::CallGivenTwice, *meaning.back, "a block calls or returns");
  if (control_.m_codes_alone.value && meaning.lonely != nullptr && meaning.m_words > 1)
    return at(Cause::IllegalMCombination, *meaning.lonely,
              "this M code shares no block with another M code");
  for (int i = 0; i < meaning.g_count; ++i) {
    const Token& token = *meaning.g[static_cast<std::size_t>(i)];
    if (token.operand.kind != Operand::Kind::Constant) continue;
    const std::size_t code10 = code_index(token.operand);
    if (meaning.call != nullptr && meaning.kind == CallKind::M98 && not_with_call_.test(code10))
      return at(Cause::IllegalWordWithCall, token, "this code may not stand with M98");
    if (meaning.back != nullptr && not_with_return_.test(code10))
      return at(Cause::IllegalWordWithReturn, token, "this code may not stand with M99");
  }
  if (control_.repeated_address.value == RepeatedAddress::Alarm && !meaning.calls_macro()) {
    std::uint64_t seen = 0;
    for (const Token& token : tokens) {
      if (token.letter == 'G' || token.letter == 'M' || token.letter == '<') continue;
      const std::uint64_t mark = 1ULL << (token.letter - 'A' + (token.comma ? 32 : 0));
      if ((seen & mark) != 0)
        return at(Cause::AddressGivenTwice, token, "the address stands twice in the block");
      seen |= mark;
    }
  }
  return std::nullopt;
}

bool BlockReader::cut(const Operand& operand) const {
  return operand.fine && control_.cuts_fine_digits.value;
}

/// A length with more digits than the least increment has, which depends on the unit in force.
std::uint32_t BlockReader::cut_word(const Operand& operand, char address) {
  Expression expression;
  expression.first = static_cast<std::uint32_t>(code_.instructions.size());
  expression.at = operand.at;
  expression.width = operand.width;
  code_.instructions.push_back({Ins::Constant, 0, operand.at, operand.value});
  code_.instructions.push_back({Ins::CutWord, static_cast<std::uint8_t>(address), operand.at, 0});
  code_.instructions.push_back({Ins::End, 0, operand.at, 0});
  code_.expressions.push_back(expression);
  return static_cast<std::uint32_t>(code_.expressions.size() - 1);
}

/// The block's own words: G and M codes, and the values of its addresses; of an address given twice
/// the last.
void BlockReader::write_words(Block& block, const Tokens& tokens, const Meaning& meaning) {
  const bool call = meaning.call != nullptr;
  const bool macro = meaning.calls_macro();
  const bool sub = call && !macro;
  std::array<const Token*, kAddresses> values{};
  std::uint32_t mask = 0, expressions = 0, whole = 0;
  const auto owned = [&](const Token& token) {  // by the call or the return, not by the block
    if (token.late || token.letter == 'G' || token.letter == 'M' || token.letter == '<' ||
        token.letter == '/')
      return true;
    if (token.comma) return sub && token.letter == 'D' && control_.device_word.value;
    if (&token == meaning.call) return true;
    if ((meaning.back != nullptr || meaning.jump != nullptr) &&
        (token.letter == 'P' || token.letter == 'L'))
      return true;
    if (meaning.kind != CallKind::M98 && meaning.kind != CallKind::M198) return false;
    if (!sub) return false;
    if (token.letter == 'P' || token.letter == 'L' || token.letter == 'Q') return true;
    return token.letter == 'H' && control_.start_word.value == StartWord::H;
  };
  for (const Token& token : tokens) {
    if (macro && token.operand.at >= meaning.call->operand.at) break;  // from here on: arguments
    if (owned(token)) continue;
    int place = token.letter - 'A';
    if (token.comma)
      place = token.letter == 'C'   ? kCommaC
              : token.letter == 'R' ? kCommaR
              : token.letter == 'A' ? kCommaA
                                    : kCommaD;
    values[static_cast<std::size_t>(place)] = &token;
    const std::uint32_t mark = 1u << place;
    mask |= mark;
    const bool computed = token.operand.kind == Operand::Kind::Expression || cut(token.operand);
    expressions = computed ? expressions | mark : expressions & ~mark;
    const bool length =
        token.operand.whole && (letters_[static_cast<std::size_t>(token.letter)] & kLength) != 0;
    whole = length ? whole | mark : whole & ~mark;
  }
  block.data = static_cast<std::uint32_t>(code_.cells.size());
  block.mask = mask;
  block.flags = 0;
  if ((expressions | whole) != 0) {
    Cell cell{};
    cell.extra = {expressions, whole};
    code_.cells.push_back(cell);
    block.flags |= Block::kHasExtra;
  }
  const auto code_cell = [&](const Token& token, double factor) {
    Cell cell{};
    if (token.operand.kind == Operand::Kind::Expression) {
      block.flags |= Block::kCodeExpression;
      cell.value = -1.0 - token.operand.expression;
    } else {
      cell.value =
          static_cast<double>(static_cast<std::int64_t>(token.operand.value * factor + 0.5));
    }
    code_.cells.push_back(cell);
  };
  int g_count = 0;
  for (int i = 0; i < meaning.g_count; ++i) {
    const Token& token = *meaning.g[static_cast<std::size_t>(i)];
    if (macro && token.operand.at > meaning.call->operand.at) continue;
    code_cell(token, 10);
    ++g_count;
  }
  const int most = std::min(control_.m_codes_per_block.value, 6);
  const int first_m = std::max(0, meaning.m_count - most);
  for (int i = first_m; i < meaning.m_count; ++i)
    code_cell(*meaning.m[static_cast<std::size_t>(i)], 1);
  block.g_count = static_cast<std::uint8_t>(g_count);
  block.m_count = static_cast<std::uint8_t>(meaning.m_count - first_m);
  for (std::uint32_t left = mask; left != 0; left &= left - 1) {
    const Operand& operand = values[static_cast<std::size_t>(__builtin_ctz(left))]->operand;
    Cell cell{};
    if (cut(operand))
      cell.expression = cut_word(operand, static_cast<char>('A' + std::countr_zero(left)));
    else if (operand.kind == Operand::Kind::Expression)
      cell.expression = operand.expression;
    else
      cell.value = operand.value;
    code_.cells.push_back(cell);
  }
  block.op = Op::Words;
  if (block.flags != 0 || block.m_count != 0 || block.g_count > 1) return;
  const double g = block.g_count == 0 ? -10 : code_.cells[block.data].value;
  if (g == -10 || g == 0 || g == 10) mark_linear(block, static_cast<int>(g / 10));
}

void BlockReader::build_call(Block& block, const Tokens& tokens, const Meaning& meaning) {
  const Token& word = *meaning.call;
  const bool macro = meaning.calls_macro();
  CallRecord call;
  call.kind = meaning.kind;
  call.code_kind = meaning.code_kind;
  call.macro = macro;
  call.at = word.operand.at;
  call.width = word.operand.width;
  if (meaning.registered != nullptr) {
    call.program_number = meaning.registered->program;
    call.variable = meaning.registered->variable;
    call.code = static_cast<std::int32_t>(word.operand.value);
  }
  const bool by_number = meaning.registered == nullptr;
  const Token* seen_p = nullptr;
  const Token* seen_l = nullptr;
  for (const Token& token : tokens) {
    if (&token == &word) continue;
    if (token.comma) {
      if (token.letter == 'D' && control_.device_word.value && by_number)
        call.device = token.operand;
      if (token.letter == 'D' && !control_.device_word.value)
        return refuse(block, {Cause::AddressNotUsable, token.operand.at, token.operand.width,
                              "the control has no ,D"});
      continue;
    }
    if (by_number && token.letter == '<') {
      call.name = std::string(token.name);
      call.name_at = token.operand.at;
      call.name_width = token.operand.width;
    }
    const bool first_p = seen_p == nullptr, first_l = seen_l == nullptr;
    if (token.letter == 'P' && by_number) {
      call.p = token.operand;
      seen_p = &token;
      if (macro && !first_p && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return refuse(block, {Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                              "P stands twice in the call"});
    }
    if (token.letter == 'L' && (by_number || macro)) {
      call.l = token.operand;
      seen_l = &token;
      if (macro && !first_l && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return refuse(block, {Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                              "L stands twice in the call"});
    }
    if (by_number && !macro) {
      if (token.letter == 'Q' && control_.start_word.value == StartWord::Q)
        call.start = token.operand;
      if (token.letter == 'H' && control_.start_word.value == StartWord::H)
        call.start = token.operand;
    }
  }
  if (control_.h_codes.value && meaning.kind == CallKind::G65) {
    // H makes it a statement, unless words stand there that only a macro call has.
    bool h = false, others = false;
    for (const Token& token : tokens) {
      h = h || token.letter == 'H';
      others = others || std::string_view("GHPQR").find(token.letter) == std::string_view::npos;
    }
    if (h && !others) return build_h_code(block, tokens, meaning);
    if (!call.p.present() && call.name.empty())
      return refuse(block, {Cause::HCodeMissing, call.at, call.width, "G65 has neither P nor H"});
  }
  if (macro || control_.call_passes_words.value) {
    if (auto fault = arguments(call, tokens, meaning)) return refuse(block, *fault);
  }
  write_words(block, tokens, meaning);
  if (macro && (block.mask != 0 || block.g_count != 0 || block.m_count != 0) &&
      control_.words_before_macro_call.value == WordsBeforeMacroCall::Alarm) {
    const Token& first = tokens.front();
    return refuse(block, {Cause::MacroCallNotFirst, first.operand.at, first.operand.width,
                          "a word stands before the macro call"});
  }
  switch (meaning.code_kind) {
    case CodeCallKind::Subprogram:
      block.op = Op::Call;
      break;
    case CodeCallKind::Macro:
      block.op = Op::MacroCall;
      break;
    case CodeCallKind::Modal:
    case CodeCallKind::ModalEveryBlock:
      block.op = Op::ModalCall;
      break;
  }
  block.aux = static_cast<std::uint32_t>(code_.calls.size());
  code_.calls.push_back(std::move(call));
}

/// The arguments of a macro call, as the locals they set, in the order written: the later one wins.
std::optional<Fault> BlockReader::arguments(CallRecord& call, const Tokens& tokens,
                                            const Meaning& meaning) {
  call.first_argument = static_cast<std::uint32_t>(code_.arguments.size());
  const auto add = [&](int variable, const Token& token) {
    code_.arguments.push_back({static_cast<std::int16_t>(variable), token.letter, token.operand});
  };
  if (!call.macro) {  // M98 that passes its words: A is #0 ... Z is #25
    for (const Token& token : tokens)
      if (&token != meaning.call && is_letter(token.letter) && !token.comma)
        add(token.letter - 'A', token);
    call.arguments = static_cast<std::uint32_t>(code_.arguments.size()) - call.first_argument;
    return std::nullopt;
  }
  std::uint32_t seen = 0;
  int set = 1;
  char last = 0;
  std::array<int, 3> of_letter{};
  bool behind = false;
  for (const Token& token : tokens) {
    if (&token == meaning.call) {
      behind = true;
      continue;
    }
    if (!behind || token.letter == 'P' || token.letter == 'L' || token.letter == '<') {
      if (token.letter == 'P' && meaning.registered != nullptr && behind)
        return Fault{Cause::IllegalArgument, token.operand.at, token.operand.width,
                     "P cannot be an argument"};
      continue;
    }
    if (token.late)
      return Fault{Cause::SequenceNumberNotFirst, token.operand.at, 1,
                   "N stands at the head of a macro call"};
    const std::size_t code = code_index(token.operand);
    const auto refused = [&](Cause cause) {
      return Fault{cause, token.operand.at, token.operand.width,
                   "this code may not stand with a macro call"};
    };
    if (token.letter == 'G' && meaning.kind == CallKind::G65 && not_with_macro_.test(code))
      return refused(Cause::CodeWithMacroCall);
    if (token.letter == 'G' && meaning.kind == CallKind::G66 && not_with_modal_.test(code))
      return refused(Cause::CodeWithModalCall);
    if (token.letter == 'M' && meaning.kind == CallKind::G65 && m_not_with_macro_.test(code))
      return refused(Cause::MCodeWithMacroCall);
    if (token.letter == 'G' || token.letter == 'O' || token.letter == 'N' || token.comma)
      return Fault{Cause::IllegalArgument, token.operand.at, token.operand.width,
                   std::string(token.comma ? "," : "") + token.letter + " cannot be an argument"};
    if (token.axis != 0) {
      static constexpr int kNumbered[2][3] = {{27, 28, 29}, {30, 31, 32}};
      add(kNumbered[token.axis - 1][token.letter - 'X'], token);
      continue;
    }
    if (token.letter < 'I' || token.letter > 'K') {
      const std::uint32_t mark = bit(token.letter);
      if ((seen & mark) != 0 && control_.repeated_argument.value == RepeatedAddress::Alarm)
        return Fault{Cause::AddressGivenTwice, token.operand.at, token.operand.width,
                     "the argument stands twice in the call"};
      seen |= mark;
      add(argument_variable(token.letter), token);
      continue;
    }
    const int place = token.letter - 'I';
    switch (control_.argument_sets.value) {
      case ArgumentSets::ByOrder:
        if (last != 0 && token.letter <= last) ++set;
        break;
      case ArgumentSets::PerLetter:
        set = ++of_letter[static_cast<std::size_t>(place)];
        break;
      case ArgumentSets::First:
        set = 1;
        break;
    }
    last = token.letter;
    if (set > 10)
      return Fault{Cause::TooManyArgumentSets, token.operand.at, token.operand.width,
                   "there are ten sets of I, J, K"};
    add(3 * set + 1 + place, token);
  }
  call.arguments = static_cast<std::uint32_t>(code_.arguments.size()) - call.first_argument;
  return std::nullopt;
}

void BlockReader::build_return(Block& block, const Tokens& tokens, const Meaning& meaning) {
  CallRecord back;
  back.at = meaning.back->operand.at;
  back.width = meaning.back->operand.width;
  for (const Token& token : tokens) {
    if (token.comma) continue;
    if (token.letter == 'P') back.p = token.operand;
    if (token.letter == 'L') back.l = token.operand;
  }
  if (back.p.present() && control_.return_with_p.value == ReturnWithP::Refused)
    return refuse(block, {Cause::IllegalWordWithReturn, back.p.at, back.p.width,
                          "M99 takes no P on this control"});
  write_words(block, tokens, meaning);
  block.op = Op::Return;
  block.aux = static_cast<std::uint32_t>(code_.calls.size());
  code_.calls.push_back(std::move(back));
}

void BlockReader::build_jump(Block& block, const Tokens& tokens, const Meaning& meaning) {
  Statement jump;
  jump.at = meaning.jump->operand.at;
  jump.width = meaning.jump->operand.width;
  for (const Token& token : tokens)
    if (token.letter == 'P' && !token.comma) jump.p = token.operand;
  if (!jump.p.present())
    return refuse(block, {Cause::ProgramNumberMissing, jump.at, jump.width,
                          "M97 does not say where to jump"});
  write_words(block, tokens, meaning);
  block.op = Op::Jump;
  block.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(jump);
}

void BlockReader::build_h_code(Block& block, const Tokens& tokens, const Meaning& meaning) {
  Statement h;
  h.at = meaning.call->operand.at;
  h.width = meaning.call->operand.width;
  for (const Token& token : tokens) {
    switch (token.letter) {
      case 'H':
        h.number = token.operand.kind == Operand::Kind::Constant
                       ? static_cast<std::int32_t>(token.operand.value)
                       : -1;
        h.variable_at = token.operand.at;
        h.variable_width = token.operand.width;
        break;
      case 'P':
        h.p = token.operand;
        break;
      case 'Q':
        h.q = token.operand;
        break;
      case 'R':
        h.r = token.operand;
        break;
      case 'G':
        break;
      default:
        break;
    }
  }
  const std::string_view whole(code_.files.back().text);
  const std::size_t open = whole.find('(', h.at);
  const std::size_t line_end = std::min(whole.find('\n', h.at), whole.size());
  if (open < line_end) {
    h.text = static_cast<std::uint32_t>(open) + 1;
    h.text_length =
        static_cast<std::uint32_t>(std::min(whole.find(')', open), line_end) - open - 1);
  }
  block.op = Op::HCode;
  block.aux = static_cast<std::uint32_t>(code_.statements.size());
  code_.statements.push_back(h);
}

}  // namespace cncsub
