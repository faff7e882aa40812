#include "cncsub/analysis/points.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <string>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t kLengths = bit('X') | bit('Y') | bit('Z') | bit('U') | bit('V') | bit('W');
constexpr std::uint32_t kCentre = bit('I') | bit('J') | bit('K') | bit('R');

/// Return the words of a block that are lengths: in an arc also its centre and radius, in a
/// drilling cycle its R. Another word shows where these letters are something else, such as a
/// count.
std::uint32_t lengths_of(const Code& code, const Block& block, const GCodes& g_codes,
                         MachineType machine) {
  std::uint32_t lengths = block.op == Op::Arc ? kLengths | kCentre : kLengths;
  bool passes = false;
  each_g(code, block, [&](int g) {
    const GCode of = g_codes.find(g);
    passes = passes || is_multiple_cycle(of.meaning);
    if (of.meaning == Meaning::Cw || of.meaning == Meaning::Ccw) lengths |= kCentre;
    if (of.group == Group::Cycle && machine == MachineType::Mill) lengths |= bit('R');
  });
  return passes ? 0 : block.mask & lengths;
}

}  // namespace

Points points_of(const Code& code, const Block& block, const GCodes& g_codes, MachineType machine) {
  const std::uint32_t lengths = lengths_of(code, block, g_codes, machine);
  if (lengths == 0) return {};
  if ((block.flags & Block::kHasExtra) == 0) return {lengths, 0};
  const auto extra = code.cells[block.data].extra;
  Points points{lengths & ~extra.whole & ~extra.expressions, 0};
  const Cell* cell = code.cells.data() + block.data + 1 + block.code_cells();
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const std::uint32_t address = left & ~(left - 1);
    if ((address & lengths & extra.whole & ~extra.expressions) == 0) continue;
    if (cell->value != 0 && std::fabs(cell->value) < kFewIncrements) points.without |= address;
  }
  return points;
}

namespace {

/// Return the value of a word of a block that is written as a number.
double value_of(const Code& code, const Block& block, std::uint32_t address) {
  const auto before = static_cast<std::size_t>(std::popcount(block.mask & (address - 1)));
  return code.cells[block.data + 1 + block.code_cells() + before].value;
}

}  // namespace

WithoutPoint lengths_without_point(const Code& code, const std::vector<bool>& programs,
                                   const std::string& machine, InterruptCheck& interrupt) {
  WithoutPoint found;
  if (!counts_increments(code)) return found;
  const MachineType type = machine_of(*code.control, machine);
  const GCodes g_codes(*code.control, type);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const Program& program = code.programs[i];
    const std::size_t blocks = program.last - program.first;
    if (!programs[i] || interrupt.requested(blocks * InterruptCheck::kBlock)) continue;
    for (Address at = program.first; at < program.last; ++at)
      each_variant(code, code.blocks[at], [&](const Block& block) {
        const std::uint32_t without = points_of(code, block, g_codes, type).without;
        if (without == 0) return;
        if (found.count == 0) {
          const std::uint32_t address = without & ~(without - 1);
          found.block = at;
          found.address = static_cast<char>('A' + std::countr_zero(address));
          found.value = value_of(code, block, address);
        }
        found.count += std::popcount(without);
      });
  }
  return found;
}

}  // namespace cncsub
