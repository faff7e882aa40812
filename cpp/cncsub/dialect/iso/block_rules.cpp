#include "cncsub/dialect/iso/block_rules.hpp"

namespace cncsub {

BlockRules::BlockRules(const Code& of, const IsoVariant& its)
    : code(of), control(*of.control), variant(its), expressions(of, its.structured), calling(of) {
  const auto mark = [this](const auto& letters, std::uint8_t what) {
    for (const char letter : letters) letters_[static_cast<unsigned char>(letter)] |= what;
  };
  mark(control.reading.point_addresses.value, PlainTable::kPoint);
  mark(control.reading.minus_addresses.value, PlainTable::kMinus);
  if (control.reading.whole_numbers.value == WholeNumbers::Increments)
    mark(kLengths, PlainTable::kIncrements);
  if (control.motion.dwell_point.value == DwellPoint::CyclesToo)
    mark(std::string_view("P"), PlainTable::kIncrements);
  if (control.common.refuses.value.has(Cause::CornerWithCall))
    for (const CornerLetters& words :
         {control.motion.chamfer_words.value, control.motion.round_words.value})
      for (const auto& word : words) corners_not_with_call.put(word);
}

}  // namespace cncsub
