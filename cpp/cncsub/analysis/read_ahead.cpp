// Inputs that are read while blocks before them still run.
#include <string>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

constexpr int kLimit = 1030;  // G103 P1: no block is read ahead

bool is_input(const Code& code, std::int64_t number) {
  const VariablePlace place = code.place(number);
  return place.range != nullptr &&
         (place.kind == VariableKind::Input || place.kind == VariableKind::InputWord);
}

bool names_limit(const Checker& c, const Block& block) {
  bool named = false;
  each_g(c.code, block, [&](int g) { named = named || g == kLimit; });
  return named;
}

/// Whether a block reads an input: its place, of no width where it reads none.
TextPlace input_of(const Checker& c, const Block& block, std::int32_t program) {
  if (block.op < Op::Set || block.op == Op::Fault || block.op == Op::EndOfRecord) return {0, 0};
  for (const VariableReference& of : references_of(c.code, block, program).reads)
    if (of.number >= 0 && !of.computed && is_input(c.code, of.number)) return of.place;
  return {0, 0};
}

/// The blocks that some way leads to without a limit of what is read ahead.
std::vector<bool> unlimited(const Checker& c, const ProgramFlow& flow) {
  std::vector<bool> found(flow.size(), false);
  std::vector<Address> waiting{flow.first()};
  for (Address at = flow.first(); at < flow.last(); ++at)  // G103 alone takes the limit back
    if (names_limit(c, c.code.blocks[at]) && (c.code.blocks[at].mask & bit('P')) == 0)
      waiting.push_back(at);
  while (!waiting.empty() && !c.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (found[at - flow.first()]) continue;
    found[at - flow.first()] = true;
    const bool limits = at < flow.last() && names_limit(c, c.code.blocks[at]) &&
                        (c.code.blocks[at].mask & bit('P')) != 0;
    if (limits) continue;
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      waiting.push_back(exit->to);
  }
  return found;
}

}  // namespace

void check_read_ahead(Checker& c) {
  const GCode limit = c.g_codes.find(kLimit);
  if (limit.meaning != Meaning::Neutral || !c.code.g_codes.test(kLimit)) return;
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow) || c.is_called(flow.program())) continue;
    std::vector<bool> free;  // looked for where it is asked
    for (Address at = flow.first(); at < flow.last() && !c.over(4); ++at) {
      const TextPlace place = input_of(c, c.code.blocks[at], flow.program());
      if (place.width == 0) continue;
      if (free.empty()) free = unlimited(c, flow);
      if (free[at - flow.first()])
        c.found(Check::InputAhead, at, place,
                "the control reads blocks ahead: the input may be read before the blocks above "
                "have run");
    }
  }
}

}  // namespace cncsub
