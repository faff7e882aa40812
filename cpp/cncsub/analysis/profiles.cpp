#include "cncsub/analysis/profiles.hpp"

#include <algorithm>
#include <cmath>

namespace cncsub {

namespace {

bool follows_profile(Meaning meaning) {
  return meaning == Meaning::Finish || meaning == Meaning::RoughTurn ||
         meaning == Meaning::RoughFace || meaning == Meaning::RoughPattern;
}

/// Return the value of a word that is written as a number, -1 where there is none.
std::int64_t written(const Code& code, const Block& block, char address) {
  if ((block.mask & bit(address)) == 0) return -1;
  const Cell* cell = code.cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) expressions = (cell++)->extra.expressions;
  if ((expressions & bit(address)) != 0) return -1;
  cell += block.code_cells();
  for (std::uint32_t left = block.mask & (bit(address) - 1); left != 0; left &= left - 1) ++cell;
  return std::abs(cell->value) < 1e9 ? to_whole<std::int64_t>(cell->value) : -1;
}

}  // namespace

bool cuts_profile(const Code& code, const GCodes& codes, const Block& block) {
  if ((block.mask & bit('P')) == 0 || (block.mask & bit('Q')) == 0 || block.g_count == 0)
    return false;
  const auto& codes_here = code.codes_of(block);  // kept: `g` looks into it
  const auto g = codes_here.g();
  return std::any_of(g.begin(), g.end(),
                     [&](int each) { return follows_profile(codes.find(each).meaning); });
}

NamedProfile profile_of(const Code& code, const Program& program, Address at) {
  const Block& block = code.blocks[at];
  NamedProfile named{written(code, block, 'P'), written(code, block, 'Q')};
  named.first = code.next_of(program, named.p, at);
  if (named.first == kNowhere) named.first = code.first_of(program, named.p);
  named.last = named.first == kNowhere ? code.first_of(program, named.q)
                                       : code.first_from(program, named.q, named.first);
  return named;
}

}  // namespace cncsub
