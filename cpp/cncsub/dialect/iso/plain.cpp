#include "cncsub/dialect/iso/plain.hpp"

#include <algorithm>
#include <bit>
#include <string_view>

namespace cncsub {

PlainReader::PlainReader(Builder& to, const BlockRules& rules, ExpressionReader& expressions)
    : to_(to), rules_(rules), expressions_(expressions) {
  const auto& reading = rules.control.reading;
  if (to.code().general_only) return;  // no block is plain then
  // A plain block keeps every limit but an unusually tight one.
  const auto tight = [](int limit, std::ptrdiff_t usual) { return limit > 0 && limit < usual; };
  if (tight(reading.max_block_length.value, kLongestPlain) ||
      tight(reading.max_words.value, kMostPlainWords))
    return;
  assigns_ = true;
  table_.max_digits = reading.max_digits.value;
  table_.max_n = reading.max_sequence_number.value;
  table_.cuts_fine_digits = reading.cuts_fine_digits.value;
  table_.set("(", PlainTable::Kind::Comment);
  for (const char c : std::string_view("ABCDEFHIJKLPQRSTUVWXYZ")) {
    if (!rules.calling.any(c)) table_.set({&c, 1}, PlainTable::Kind::Value);
    table_.of_value[static_cast<unsigned char>(c)] = rules.takes(c);
  }
  table_.set("G", PlainTable::Kind::G);
  if (reading.m_codes_per_block.value != 0) table_.set("M", PlainTable::Kind::M);
  table_.set("N", PlainTable::Kind::N);
  for (std::size_t g = 0; g < table_.g.size(); ++g)
    table_.g[g] = rules.code.g_codes.test(g * 10) &&
                  rules.control.calls.roles.value.of_g(static_cast<int>(g * 10)) == Role::None &&
                  rules.calling.find('G', static_cast<double>(g)) == nullptr;
  table_.dwells = table_.g[PlainTable::kDwell];
  table_.g[PlainTable::kDwell] = false;
  whole_dwell_ = rules.control.motion.dwell_unit.value == DwellUnit::Milliseconds ||
                 rules.control.motion.dwell_point.value != DwellPoint::Refused;
}

/// What plain words hold beside numbers.
struct PlainReader::Language {
  PlainReader& of;
  Scanner& scanner;

  /// Return whether an M code does not change the order of blocks.
  bool takes_m(int m) const {
    const Control& control = of.rules_.control;
    const Role role = control.calls.roles.value.of_m(m);
    if (role != Role::None && role < Role::SpindleForward) return false;
    if (calls_elsewhere(control.calls.roles.value, m)) return false;  // its P has no meaning
    return of.rules_.calling.find('M', m) == nullptr;
  }

  /// Take a value that an expression at `at` gives.
  bool computed(PlainWords& words, char letter, const char*& at) {
    if (*at != '#' && *at != '[') return false;
    const std::uint32_t mark = bit(letter);
    if ((words.mask & mark) != 0 || (letter == 'P' && of.rules_.control.calls.bracket_names.value))
      return false;
    scanner.at = at;
    const auto expression = of.expressions_.word_value(scanner, letter);
    if (!expression) return false;
    words.values[static_cast<std::size_t>(letter - 'A')].expression = *expression;
    words.mask |= mark;
    words.extra.expressions |= mark;
    at = scanner.at;
    return true;
  }
};

/// Return whether a dwell has one value, no expression and no comment. A point in the block is then
/// one of this value.
bool PlainReader::is_plain_dwell(const Scanner& s, const PlainWords& words) {
  const std::string_view text(s.at, static_cast<std::size_t>(s.end - s.at));
  return std::has_single_bit(words.mask) && words.extra.expressions == 0 &&
         text.find('(') == std::string_view::npos;
}

/// Read an assignment after its N.
bool PlainReader::numbered_assignment(Scanner& s, Block& block) {
  const char* at = s.at + 1;
  PlainWords head;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  Language language{*this, s};
  const PlainWordReader reader(table_, language);
  const Mantissa number = scan_mantissa(at);
  if (number.point || !reader.fits(number) || !reader.take_n(head, number)) return false;
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
  if (s.end - s.at >= kLongestPlain) return false;
  if (*s.at == '/') return read_skipped(s, block);
  if (*s.at == 'N' && assigns_ && numbered_assignment(s, block)) return true;
  PlainWords words;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  Language language{*this, s};
  const char* const first = s.at;
  const ExpressionWriter::Place before = to_.expressions().place();
  if (!PlainWordReader(table_, language).read(first, s.end, words) || !words.any() ||
      (words.dwell && !is_plain_dwell({first, s.end, s.file}, words))) {
    to_.expressions().rollback(before);
    s.at = first;
    return false;
  }
  block.n = words.n;
  if (words.dwell && whole_dwell_ && std::find(first, s.end, '.') == s.end)
    words.extra.whole = words.mask;
  to_.plain_words(block, words.codes(), words.m, words.mask, words.extra, words.values);
  return true;
}

}  // namespace cncsub
