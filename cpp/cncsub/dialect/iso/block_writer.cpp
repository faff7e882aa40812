#include "cncsub/dialect/iso/block_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

namespace cncsub {

namespace {

/// Return the bit of a word's address in a mask.
int place_of(const Token& token) {
  return token.comma ? comma_place(token.letter) : token.letter - 'A';
}

}  // namespace

void BlockWriter::write() {
  if (meaning_.calls()) return call();
  if (meaning_.back != nullptr) return back();
  if (meaning_.jump != nullptr) return jump();
  drop_plain_p();
  words();
  if (meaning_.cancel != nullptr) block_.op = Op::CancelModal;
  if (meaning_.end != nullptr) block_.op = Op::EndProgram;
}

/// Write the words that the block executes: G and M codes, and the values of its addresses.
void BlockWriter::words() {
  WordList words;
  values(words);
  codes(words);
  to_.words(block_, words);
}

/// Write the values of the addresses. Of an address given twice the last value counts.
void BlockWriter::values(WordList& words) {
  const bool dwell = (control_.motion.dwell_unit.value == DwellUnit::Milliseconds ||
                      control_.motion.dwell_point.value != DwellPoint::Refused) &&
                     meaning_.has_g(4, 4);
  std::array<const Token*, kAddresses> last{};
  for (const Token& token : tokens_) {
    if (macro_ && token.operand.at >= meaning_.call->operand.at) break;  // arguments follow
    if (!executed(token)) continue;
    const int place = place_of(token);
    const Token*& before = last[static_cast<std::size_t>(place)];
    if (before != nullptr) to_.drop(before->operand.at, before->operand.width);
    before = &token;
    words.set(place, {}, token.operand.whole && (dwell || rules_.in_increments(token.letter)));
    if (may_be_increment(token)) words.whole |= 1u << kPointedH;
  }
  for (std::uint32_t left = words.mask; left != 0; left &= left - 1) {
    const int place = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(place);
    words.values[at] = value_of(last[at]->operand, place);
  }
}

void BlockWriter::codes(WordList& words) {
  const auto code = [](const Operand& operand, double factor) {
    return WordValue{operand.kind == Operand::Kind::Expression, operand.expression,
                     std::floor(operand.value * factor + 0.5)};
  };
  for (const Token* token : meaning_.g)
    if (!macro_ || token->operand.at <= meaning_.call->operand.at)
      words.add_g(code(token->operand, 10));
  const int most = std::min(control_.reading.m_codes_per_block.value, 6);
  const int count = static_cast<int>(meaning_.m.size());
  for (int i = 0; i < count; ++i) {
    const Operand& operand = meaning_.m[static_cast<std::size_t>(i)].operand;
    if (i < count - most)
      to_.drop(operand.at, operand.width);
    else
      words.add_m(code(operand, 1));
  }
}

/// Return whether the block executes a word. The other words belong to its call, return or jump.
bool BlockWriter::executed(const Token& token) const {
  const bool address = token.letter != 'G' && token.letter != 'M' && token.letter != '<' &&
                       token.letter != '/' && !token.trailing_n;
  return address && !belongs_to_call(token);
}

bool BlockWriter::belongs_to_call(const Token& token) const {
  const char letter = token.letter;
  const bool sub = meaning_.calls_subprogram();
  if (token.comma) return sub && letter == 'D' && control_.calls.device_word.value;
  if (&token == meaning_.call) return true;
  const bool p_or_l = letter == 'P' || letter == 'L';
  if (meaning_.jump_reads_input && letter == 'Q') return true;
  if (letter == 'Q' && meaning_.back != nullptr && control_.calls.return_to_line.value) return true;
  if (p_or_l && (meaning_.back != nullptr || meaning_.jump != nullptr)) return true;
  if (!sub || meaning_.registered != nullptr) return false;
  return p_or_l || letter == 'Q' ||
         (letter == 'H' && control_.calls.start_word.value == StartWord::H);
}

/// Return the value of a word. A length with more digits than the least increment has is cut when
/// the block runs, because the unit in force decides how far.
WordValue BlockWriter::value_of(const Operand& operand, int place) {
  if (!operand.fine || !control_.reading.cuts_fine_digits.value)
    return {operand.kind == Operand::Kind::Expression, operand.expression, operand.value};
  to_.expressions().begin();
  to_.expressions().emit({Ins::Constant, 0, operand.at, operand.value});
  to_.expressions().emit({Ins::CutWord, static_cast<std::uint8_t>('A' + place), operand.at, 0});
  return {true, to_.expressions().end(operand.at, operand.width), 0};
}

}  // namespace cncsub
