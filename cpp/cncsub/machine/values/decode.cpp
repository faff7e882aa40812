#include "cncsub/machine/values/decode.hpp"

#include <bit>
#include <cmath>
#include <string>

#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

namespace {

struct Place {
  std::uint32_t at, width;
};

/// Return where a code is written that is an expression; for other codes, their block.
Place place_of(const Run& run, const Block& block, const Cell& cell) {
  if (cell.value >= 0) return {block.text, block.length};
  const auto expression = run.code->expression(to_whole<std::uint32_t>(-1.0 - cell.value));
  return {expression.at(), expression.width()};
}

/// Decode a G or M code from its cell: a number, or an expression, whose vacant value (-1) is no
/// code.
bool decode_code(Run& run, const Block& block, Address of, const Cell& cell, double factor,
                 int& code) {
  double value = cell.value;
  if (value < 0) {
    const auto expression = to_whole<std::uint32_t>(-1.0 - value);
    if (!evaluate(run, expression, value, of)) return false;
    if (is_vacant(value)) {
      code = -1;
      return true;
    }
    value = std::round(value * factor);
  }
  if (const auto [at, width] = place_of(run, block, cell); value < 0 || value > kLargestCode)
    return alarm(run, {Cause::ValueOutOfRange, at, width, "the code is out of range", of});
  code = to_whole<int>(value);
  return true;
}

/// Decode codes of which one is an expression, or of which a library has too many lists.
bool decode_codes(Run& run, const Block& block, Address of, const Cell*& cell, NcWords& words) {
  CodeList list;
  for (unsigned i = 0; i < block.g_count; ++i) {
    const Place place = place_of(run, block, *cell);
    int g = 0;
    if (!decode_code(run, block, of, *cell++, 10, g)) return false;
    if (g > 10000 || (g >= 0 && !run.code->g_codes.test(static_cast<std::size_t>(g))))
      return alarm(run, {.cause = Cause::GCodeNotAvailable,
                         .at = place.at,
                         .width = place.width,
                         .detail = "the control has no such G code",
                         .block = of});
    if (g >= 0) list.add_g(g);
  }
  for (unsigned i = 0; i < block.m_count; ++i) {
    int m = 0;
    if (!decode_code(run, block, of, *cell++, 1, m)) return false;
    if (m >= 0) list.add_m(m);
  }
  run.codes = {list, *run.meanings};
  words.codes = &run.codes;
  return true;
}

/// Decode a word whose value is an expression.
bool decode_computed(Run& run, std::uint32_t expression, Address of, std::size_t place,
                     NcWords& words) {
  double value = 0;
  if (!evaluate(run, expression, value, of)) return false;
  if (std::fabs(value) >= run.largest_word) {  // a vacant value compares false
    const Expression e = run.code->expression(expression);
    if (std::fabs(value) > kLargest)
      return alarm(run, {Cause::Overflow, e.at(), e.width(), "the result is too large", of});
    return alarm(
        run,
        {Cause::ValueOutOfRange, e.at(), e.width(),
         "the value has more than " + std::to_string(most_digits(run.control())) + " digits", of});
  }
  constexpr double kHair = 1e-9;  // 0.3-0.1-0.2 is no number below zero
  if (value < -kHair && (run.unsigned_words >> place & 1) != 0) {
    const Expression e = run.code->expression(expression);
    const std::string address = run.code->spelling->address_of(static_cast<int>(place));
    return alarm(run, {Cause::ValueOutOfRange, e.at(), e.width(), address + " is negative", of});
  }
  if (is_vacant(value)) {
    if (run.control().macros.vacant_address.value == VacantAddress::Ignored)
      words.mask &= ~(1u << place);
    value = 0;
  }
  words.value[place] = (run.computed_whole >> place & 1) != 0 ? std::round(value) : value;
  words.computed |= 1u << place;
  return true;
}

/// Decode the words of a block, of which `expressions` marks those that are expressions.
bool decode_words(Run& run, const Block& block, const Cell* cell, std::uint32_t expressions,
                  NcWords& words) {
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const auto place = static_cast<std::size_t>(std::countr_zero(left));
    if ((expressions & (1u << place)) == 0)
      words.value[place] = cell->value;
    else if (!decode_computed(run, static_cast<std::uint32_t>(cell->expression), words.at, place,
                              words))
      return false;
  }
  return true;
}

}  // namespace

bool decode(Run& run, const Block& block, Address at, NcWords& words) {
  const Cell* cell = run.code->cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) {
    expressions = cell->extra.expressions;
    words.whole = cell->extra.whole;
    ++cell;
  }
  words.at = at;
  if ((block.flags & Block::kListed) != 0)
    words.codes = &run.meanings->blocks[block.list];
  else if (block.has_codes() && !decode_codes(run, block, at, cell, words))
    return false;
  words.mask = block.mask;
  if (expressions != 0) run.codes_decoded = words.codes;
  const bool fine = decode_words(run, block, cell, expressions, words);
  if ((block.flags & Block::kHasForms) != 0) {
    cell += std::popcount(block.mask);
    words.forms = {cell[0].extra.expressions, cell[0].extra.whole, cell[1].extra.expressions};
  }
  run.codes_decoded = nullptr;
  return fine;
}

}  // namespace cncsub
