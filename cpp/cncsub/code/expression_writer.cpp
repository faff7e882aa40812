#include "cncsub/code/expression_writer.hpp"

#include <vector>

namespace cncsub {

void OpenInstructions::make_room() {
  const std::uint32_t top = place_of(top_);
  const std::size_t before = table_.size(), room = 2 * (top + kRoom);
  table_.add(top + 1);  // they count while they are moved
  table_.room(room);
  table_.keep(before);
  first_ = table_.room(0) + 1;
  limit_ = first_ + top + room - kSpare;
  top_ = first_ + top;
}

std::uint32_t ExpressionWriter::one(const Instruction& only, std::uint32_t at,
                                    std::uint32_t width) {
  begin();
  emit(only);
  return end(at, width);
}

std::uint32_t ExpressionWriter::changed(std::uint32_t expression, Ins by) {
  const Expression of = code_.expression(expression);
  std::vector<Instruction> all;
  for (const Instruction each : of)
    if (each.op != Ins::End) all.push_back(each);
  const std::uint32_t at = of.at(), width = of.width();  // what is written may move it
  begin();
  for (const Instruction& each : all) emit(each);
  emit({by, 0, at, 0});
  return end(at, width);
}

}  // namespace cncsub
