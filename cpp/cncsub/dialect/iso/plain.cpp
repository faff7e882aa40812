#include "cncsub/dialect/iso/plain.hpp"

#include <algorithm>
#include <bit>
#include <string_view>

#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

constexpr int kMostWords = 20;
constexpr std::size_t kDwell = 4;  // for G04 it matters whether a value has a point
constexpr std::uint64_t kMostM = 1000;

}  // namespace

struct PlainReader::Words {
  std::array<Cell, 26> values;  // NOLINT: written where the mask says so
  std::uint32_t mask = 0;
  Cell::Extra extra{};    // `whole`: the words that count in increments
  std::array<int, 12> g;  // NOLINT: the first of them
  std::size_t g_count = 0;
  bool dwell = false;
  int m = -1;
  std::int32_t n = -1;
  int count = 0;
};

PlainReader::PlainReader(Builder& to, const BlockRules& rules, ExpressionReader& expressions)
    : to_(to),
      rules_(rules),
      expressions_(expressions),
      max_digits_(rules.control.reading.max_digits.value),
      max_n_(rules.control.reading.max_sequence_number.value),
      cuts_fine_digits_(rules.control.reading.cuts_fine_digits.value) {
  if (to.code().general_only) return;  // no block is plain then
  // A plain block keeps every limit but an unusually tight one.
  const auto tight = [](int limit, int usual) { return limit > 0 && limit < usual; };
  if (tight(rules.control.reading.max_block_length.value, kLongest) ||
      tight(rules.control.reading.max_words.value, kMostWords))
    return;
  assigns_ = true;
  kinds_['('] = Kind::Comment;
  for (const char c : std::string_view("ABCDEFHIJKLPQRSTUVWXYZ"))
    if (!rules.calling.any(c)) kinds_[static_cast<unsigned char>(c)] = Kind::Value;
  kinds_['G'] = Kind::G;
  if (rules.control.reading.m_codes_per_block.value != 0) kinds_['M'] = Kind::M;
  kinds_['N'] = Kind::N;
  for (std::size_t g = 0; g < g_.size(); ++g)
    g_[g] = rules.code.g_codes.test(g * 10) &&
            rules.control.calls.roles.value.of_g(static_cast<int>(g * 10)) == Role::None &&
            rules.calling.find('G', static_cast<double>(g)) == nullptr;
  dwells_ = g_[kDwell];
  g_[kDwell] = false;
  whole_dwell_ = rules.control.motion.dwell_unit.value == DwellUnit::Milliseconds ||
                 rules.control.motion.dwell_point.value != DwellPoint::Refused;
}

inline bool PlainReader::fits(const Mantissa& number) const {
  const auto digits = number.whole + number.decimals;
  return digits != 0 && digits <= kMostDigits &&
         number.whole + (number.point ? 3 : 0) <= max_digits_;
}

inline bool PlainReader::take_value(Words& words, char letter, bool negative,
                                    const Mantissa& number) const {
  if (number.decimals > 3 && cuts_fine_digits_) return false;
  const bool no_minus = !rules_.takes_minus(letter);
  const bool counts = rules_.in_increments(letter) & !number.point & (number.value != 0);
  const bool refused = (negative & no_minus) | (number.point & !rules_.takes_point(letter));
  const std::uint32_t mark = bit(letter);
  if (refused || (words.mask & mark) != 0) return false;
  // Signs follow no pattern: nothing branches on them.
  const double value =
      static_cast<double>(static_cast<std::int64_t>(number.value)) / kPowersOfTen[number.decimals];
  words.values[static_cast<std::size_t>(letter - 'A')].value = std::bit_cast<double>(
      std::bit_cast<std::uint64_t>(value) ^ static_cast<std::uint64_t>(negative) << 63);
  words.mask |= mark;
  words.extra.whole |= counts ? mark : 0;
  return true;
}

inline bool PlainReader::take_g(Words& words, const Mantissa& number) const {
  if (words.g_count == words.g.size() || number.value >= g_.size()) return false;
  if (!g_[number.value]) {
    if (number.value != kDwell || !dwells_) return false;
    words.dwell = true;
  }
  words.g[words.g_count++] = static_cast<int>(number.value);
  return true;
}

/// Take an M code that does not change the order of blocks.
inline bool PlainReader::take_m(Words& words, const Mantissa& number) const {
  if (words.m >= 0 || number.value >= kMostM) return false;
  const int m = static_cast<int>(number.value);
  const Role role = rules_.control.calls.roles.value.of_m(m);
  if (role != Role::None && role < Role::SpindleForward) return false;
  if (calls_elsewhere(rules_.control.calls.roles.value, m)) return false;  // its P has no meaning
  if (rules_.calling.find('M', m) != nullptr) return false;
  words.m = m;
  return true;
}

inline bool PlainReader::take_n(Words& words, const Mantissa& number) const {
  if (words.count > 1 || number.value == 0 || number.value > static_cast<std::uint64_t>(max_n_))
    return false;
  words.n = static_cast<std::int32_t>(number.value);
  return true;
}

inline bool PlainReader::take(Words& words, char letter, bool negative,
                              const Mantissa& number) const {
  const Kind kind = kinds_[static_cast<unsigned char>(letter)];
  if (kind == Kind::Value) return take_value(words, letter, negative, number);
  if (number.point || negative) return false;
  return kind == Kind::G   ? take_g(words, number)
         : kind == Kind::M ? take_m(words, number)
                           : take_n(words, number);
}

namespace {

/// Pass over a comment with its closing bracket; false if it is not closed.
bool pass_comment(const char*& at, const char* end) {
  at = std::find(at, end, ')');
  return at++ != end;
}

}  // namespace

/// Take a value that an expression at `at` gives.
bool PlainReader::take_computed(Words& words, char letter, const char*& at, Scanner& s) {
  const std::uint32_t mark = bit(letter);
  if ((words.mask & mark) != 0 || (letter == 'P' && rules_.control.calls.bracket_names.value))
    return false;
  s.at = at;
  const auto expression = expressions_.word_value(s, letter);
  if (!expression) return false;
  words.values[static_cast<std::size_t>(letter - 'A')].expression = *expression;
  words.mask |= mark;
  words.extra.expressions |= mark;
  at = s.at;
  return true;
}

CNCSUB_ALWAYS_INLINE inline bool PlainReader::take_words(Scanner& s, Words& words) {
  const char* p = s.at;
  for (;;) {
    while (*p == ' ') ++p;
    if (p >= s.end) return true;  // the character there is in no word
    const char letter = *p++;
    const Kind kind = kinds_[static_cast<unsigned char>(letter)];
    if (kind == Kind::Comment && pass_comment(p, s.end)) continue;
    if (kind <= Kind::Comment || ++words.count > kMostWords) return false;
    const char* const value = p;
    const bool negative = *p == '-';
    p += negative ? 1 : 0;
    const Mantissa number = scan_mantissa(p);
    const bool taken = fits(number)
                           ? take(words, letter, negative, number)
                           : kind == Kind::Value && number.whole == 0 && (*p == '#' || *p == '[') &&
                                 take_computed(words, letter, p = value, s);
    if (!taken) return false;
  }
}

/// Return whether a dwell has one value, no expression and no comment. A point in the block is then
/// one of this value.
bool PlainReader::is_plain_dwell(const Scanner& s, const Words& words) {
  const std::string_view text(s.at, static_cast<std::size_t>(s.end - s.at));
  return std::has_single_bit(words.mask) && words.extra.expressions == 0 &&
         text.find('(') == std::string_view::npos;
}

/// Read an assignment after its N.
bool PlainReader::numbered_assignment(Scanner& s, Block& block) {
  const char* at = s.at + 1;
  Words head;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const Mantissa number = scan_mantissa(at);
  if (number.point || !fits(number) || !take_n(head, number)) return false;
  while (*at == ' ') ++at;
  if (at >= s.end || *at != '#') return false;
  s.at = at;
  block.n = head.n;
  StatementReader(to_, expressions_, s, block).assign();
  return true;
}

/// Read a block after a slash at its head; the switch of the slash skips the block.
bool PlainReader::read_skipped(Scanner& s, Block& block) {
  const char* const slash = s.at++;
  const bool numbered = *s.at >= '1' && *s.at <= '9';
  const int number = numbered ? *s.at++ - '0' : 1;
  while (*s.at == ' ') ++s.at;
  if (*s.at == '/' || !read(s, block)) {
    s.at = slash;
    return false;
  }
  block.skip = static_cast<std::uint16_t>(block.skip | 1U << number);
  return true;
}

bool PlainReader::read_words(Scanner& s, Block& block) {
  if (s.end - s.at >= kLongest) return false;
  if (*s.at == '/') return read_skipped(s, block);
  if (*s.at == 'N' && assigns_ && numbered_assignment(s, block)) return true;
  Words words;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const char* const first = s.at;
  const ExpressionWriter::Place before = to_.expressions().place();
  if (!take_words(s, words) || (words.mask == 0 && words.g_count == 0 && words.m < 0) ||
      (words.dwell && !is_plain_dwell({first, s.end, s.file}, words))) {
    to_.expressions().rollback(before);
    s.at = first;
    return false;
  }
  block.n = words.n;
  if (words.dwell && whole_dwell_ && std::find(first, s.end, '.') == s.end)
    words.extra.whole = words.mask;
  to_.plain_words(block, {words.g.data(), words.g_count}, words.m, words.mask, words.extra,
                  words.values);
  return true;
}

}  // namespace cncsub
