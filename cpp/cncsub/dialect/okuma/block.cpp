// Words and assignments, and the blocks that they make.
#include "cncsub/dialect/okuma/block.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub::okuma {

namespace {

constexpr std::size_t kLongestName = 5;  // after N [OKA 2204]
constexpr std::string_view kAddresses = "ABCDEFHIJKLPQRSTUVWXYZ";

constexpr KnownWord kWords[] = {
#define WORD(word, treatment, does) {word, Treatment::treatment, does},
#include "cncsub/dialect/okuma/keywords.def"
#undef WORD
};

}  // namespace

const KnownWord* find_word(std::string_view word) {
  for (const KnownWord& of : kWords)
    if (of.word == word && of.treatment != Treatment::Value) return &of;
  return nullptr;
}

std::span<const KnownWord> known_words() { return kWords; }

bool begins_drawing(std::string_view text) { return same_letters(name_in(text), "DEF"); }
bool ends_drawing(std::string_view text) { return same_letters(name_in(text), "END"); }

bool BlockReader::refuse(Block& block, Cause cause, std::string detail, std::uint32_t at,
                         Kind kind) {
  to_.refuse(block, Fault{.cause = cause,
                          .at = at,
                          .width = line_.fault_width(at),
                          .detail = std::move(detail),
                          .kind = kind});
  return false;
}

bool BlockReader::refuse(Block& block) {
  if (auto fault = std::exchange(expression_.fault, std::nullopt))
    to_.refuse(block, std::move(*fault));
  return false;
}

bool BlockReader::not_computed(Block& block, std::string_view what, std::uint32_t at) {
  return refuse(block, Cause::CodeNotComputed, "cncsub does not compute " + std::string(what), at);
}

bool BlockReader::read(std::string_view text, Block& block, std::string& name, Jump& jump) {
  line_.set(text, block.text);
  expression_.begin_block();
  if (line_.at_end() && !line_.has_open_comment()) return false;
  if (!skip_and_name(block, name)) return true;
  const std::string word = line_.begins_word() ? capitals(line_.name()) : "";
  const KnownWord* const known = find_word(word);
  if (known != nullptr && known->treatment == Treatment::Statement) {
    if (statement(block, jump, word)) closed(block);
    return true;
  }
  const std::uint32_t at = line_.offset();
  if (takes_variable("VDOUT", "992")) {
    if (user_alarm(block, at)) closed(block);
    return true;
  }
  if (takes_variable("VUACM", "1")) {
    if (alarm_text(block, at)) closed(block);
    return true;
  }
  Words words;
  while (!line_.at_end())
    if (!item(block, words)) return true;
  if (!work_system(block, words)) return true;
  write(block, words);
  closed(block);
  return true;
}

/// Take a system variable with this index where it stands here.
bool BlockReader::takes_variable(std::string_view name, std::string_view index) {
  const Line before = line_;
  if (same_letters(line_.name(), name)) {
    line_.pass(name.size());
    if (line_.take('[') && line_.peek() != '\0' && line_.take_number() == index && line_.take(']'))
      return true;
  }
  line_ = before;
  return false;
}

/// Refuse a block whose comment is not closed. [OKA 2236]
void BlockReader::closed(Block& block) {
  if (!line_.has_open_comment()) return;
  const auto at = block.text + static_cast<std::uint32_t>(line_.open_comment());
  to_.refuse(block, {Cause::CommentNotClosed, at, 1, ") is missing"});
}

/// Read the skip levels and the name that begin a block, in either order.
bool BlockReader::skip_and_name(Block& block, std::string& name) {
  const auto skip = [&] {
    while (line_.take('/')) {
      const char level = line_.ahead(0);
      if (is_digit(level)) line_.pass(1);
      block.skip |= 1u << (is_digit(level) && level != '0' ? level - '0' : 1);
    }
  };
  skip();
  if (!read_own_name(block, name)) return false;
  skip();
  return true;
}

/// Read N10 or NLAB1. Digits after N end where another character stands: N10G0.
bool BlockReader::read_own_name(Block& block, std::string& name) {
  if (line_.peek() != 'N' || find_word(capitals(line_.name())) != nullptr) return true;
  const std::uint32_t at = line_.offset();
  std::string_view own = line_.name().substr(1);
  if (!own.empty() && is_digit(own[0])) {
    const auto* const end = std::find_if_not(own.begin(), own.end(), is_digit);
    own = own.substr(0, static_cast<std::size_t>(end - own.begin()));
  }
  line_.pass(1 + own.size());
  if (own.empty())
    return refuse(block, Cause::IllegalSequenceNumber, "letters or digits must follow N", at);
  if (own.size() > kLongestName)
    return refuse(block, Cause::IllegalSequenceNumber, "at most 5 characters follow N", at,
                  kTooLong);
  name = "N" + capitals(own);
  if (std::all_of(own.begin(), own.end(), is_digit))
    std::from_chars(own.data(), own.data() + own.size(), block.n);
  return true;
}

bool BlockReader::end_of_statement(Block& block) {
  if (line_.at_end()) return true;
  const std::uint32_t at = line_.offset();
  line_.pass(std::max<std::size_t>(line_.name().size(), first_character(line_.rest()).size()));
  return not_computed(block, "other words in the block of a statement", at);
}

/// Read a word or an assignment.
bool BlockReader::item(Block& block, Words& words) {
  if (!line_.begins_word() && !line_.name().starts_with('V') && !line_.name().starts_with('v'))
    return word(block, words);
  const std::string name = capitals(line_.name());
  if (const KnownWord* const known = find_word(name)) {
    const std::uint32_t at = line_.offset();
    line_.pass(name.size());
    if (known->treatment == Treatment::PassedOver) {
      words.any = true;
      words.drops.push_back({0, at, line_.width_from(at)});
      return true;
    }
    if (known->treatment == Treatment::NotComputed) return not_computed(block, name, at);
    return not_computed(block, name + " after other words of its block", at);
  }
  return assignment(block, words);
}

/// Read the value of an address: a number, or = and an expression.
bool BlockReader::value_of_word(Block& block, Value& value) {
  const bool read = line_.take('=') ? expression_.value(value) : expression_.number(value);
  return read || refuse(block);
}

bool BlockReader::word(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const char letter = line_.peek();
  const bool known = letter == 'G' || letter == 'M' || kAddresses.find(letter) != std::string::npos;
  if (!known) {
    line_.pass(first_character(line_.rest()).size());
    if (is_letter(letter))
      return refuse(block, Cause::AddressNotUsable, "this address does not stand here", at);
    return refuse(block, Cause::IllegalCharacter, "no word begins with this character", at);
  }
  line_.pass(1);
  Value value;
  if (!value_of_word(block, value)) return false;
  value.at = at;
  value.width = line_.width_from(at);
  words.any = true;
  if (letter == 'G') return g_code(block, words, value);
  if (letter == 'M') return m_code(block, words, value);
  const std::uint32_t mark = 1U << (letter - 'A');
  if ((words.given & mark) != 0)
    return not_computed(block, "an address that stands twice in its block", at);
  words.given |= mark;
  words.at[static_cast<std::size_t>(letter - 'A')] = at;
  words.list.set(letter - 'A', word_of(value), false);
  return true;
}

bool BlockReader::g_code(Block& block, Words& words, const Value& value) {
  if (value.computed) return not_computed(block, "a G code that is an expression", value.at);
  constexpr double kMost = 999;
  const double tenfold = 10 * value.number;
  if (value.number < 0 || value.number > kMost || std::fabs(tenfold - std::round(tenfold)) > 1e-6)
    return refuse(block, Cause::GCodeNotAvailable, "there is no such G code", value.at);
  const int code = to_whole<int>(std::round(tenfold));
  const ReadingRules& reading = to_.control().reading;
  if (!reading.g_codes.value.has(code)) {
    const bool known = reading.unlisted_codes.value == UnlistedCode::Refused;
    return refuse(block, known ? Cause::GCodeNotAvailable : Cause::CodeNotKnown,
                  known ? "the control has no such G code"
                        : "no source says whether the control has this G code, or what it does",
                  value.at);
  }
  if (words.list.g_count == static_cast<int>(kGCodesOfBlock))
    return refuse(block, Cause::TooManyWords, "too many G codes in one block", value.at);
  constexpr int kSelect = 150;
  if (code == kSelect) {
    words.selects = true;
    words.selects_at = value.at;
  }
  words.list.add_g({false, 0, static_cast<double>(code)});
  return true;
}

bool BlockReader::m_code(Block& block, Words& words, const Value& value) {
  if (value.computed) return not_computed(block, "an M code that is an expression", value.at);
  constexpr double kMost = 99999;
  if (value.number < 0 || value.number > kMost || std::trunc(value.number) != value.number)
    return refuse(block, Cause::MCodeNotAvailable, "there is no such M code", value.at);
  if (words.list.m_count == static_cast<int>(kMCodesOfBlock))
    return refuse(block, Cause::TooManyWords, "too many M codes in one block", value.at);
  const int code = to_whole<int>(value.number);
  words.ends = words.ends || to_.control().calls.roles.value.of_m(code) == Role::End;
  words.list.add_m({false, 0, static_cast<double>(code)});
  return true;
}

/// Read PX=1, V5=PX+1 or VZOFX[2]=10.
bool BlockReader::assignment(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const std::string name = capitals(variable_in(line_.rest()));
  Statement statement;
  statement.at = at;
  if (!expression_.left_side(statement)) return refuse(block);
  if (!line_.take('='))
    return refuse(block, Cause::MissingEquals, "= must follow the variable", line_.offset());
  Value value;
  if (!expression_.value(value)) return refuse(block);
  expression_.note_assigned(name);
  statement.expression = to_.expressions().expression_of(value);
  statement.width = line_.width_from(at);
  words.statements.push_back(statement);
  return true;
}

/// G15 selects a work system by H. Machine coordinates, by H0, are not computed.
bool BlockReader::work_system(Block& block, const Words& words) {
  if (!words.selects) return true;
  if ((words.given & 1U << ('H' - 'A')) == 0)
    return refuse(block, Cause::MotionWordMissing, "G15 needs H: G15 H1", words.selects_at);
  const WordValue system = words.list.values['H' - 'A'];
  if (!system.computed && system.value == 0)
    return not_computed(block, "the machine coordinates of G15 H0", words.at['H' - 'A']);
  return true;
}

void BlockReader::write(Block& block, Words& words) {
  for (const Drop& drop : words.drops) to_.drop(drop.at, drop.width);
  if (words.statements.empty()) {
    to_.words(block, words.list);
    if (words.ends) block.op = Op::EndProgram;
    return;
  }
  if (!words.any && words.statements.size() == 1)
    return assign(to_, block, words.statements.front());
  Block own = block;
  if (words.any) {
    to_.words(own, words.list);
    own.op = words.ends ? Op::EndProgram : Op::Words;  // no plain move: more stands beside it
  }
  to_.parallel_assign(block, words.statements, nullptr, words.any ? &own : nullptr);
}

}  // namespace cncsub::okuma
