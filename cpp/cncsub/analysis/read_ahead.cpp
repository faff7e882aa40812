// Finds inputs that are read, and outputs that are set, while the blocks before them still run. A
// control that reads ahead executes macro statements early. Offsets and positions are read when
// their block runs. [H96 p.91, look-ahead]
#include <string>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

bool is_input(VariableKind kind) {
  return kind == VariableKind::Input || kind == VariableKind::InputWord;
}
bool is_output(VariableKind kind) {
  return kind == VariableKind::Output || kind == VariableKind::OutputWord;
}

/// Return whether a block has the code that limits reading ahead.
bool names_limit(const Checker& c, const Block& block) {
  bool named = false;
  each_g(c.code, block,
         [&](int g) { named = named || c.g_codes.find(g).meaning == Meaning::LookAheadLimit; });
  return named;
}

/// The input that a block reads, or the output that it sets; without a width where it does neither.
struct Signal {
  TextPlace place{0, 0};
  bool output = false;
};

Signal signal_of(const Checker& c, const Block& block, std::int32_t program) {
  if (block.op < Op::Set || block.op == Op::Fault || block.op == Op::EndOfRecord) return {};
  const References of_block = references_of(c.code, block, program);
  const auto holds = [&](const VariableReference& of, bool (*is)(VariableKind)) {
    if (of.number < 0 || of.computed) return false;
    const VariablePlace place = c.code.place(of.number);
    return place.range != nullptr && is(place.kind);
  };
  for (const VariableReference& of : of_block.reads)
    if (holds(of, is_input)) return {of.place, false};
  for (const VariableReference& of : of_block.writes)
    if (holds(of, is_output)) return {of.place, true};
  return {};
}

/// Return the blocks that some path reaches without a limit on reading ahead. `free` says that no
/// limit is in force where the program begins.
std::vector<bool> unlimited(const Checker& c, const ProgramFlow& flow, bool free) {
  std::vector<bool> found(flow.size(), false);
  std::vector<Address> waiting;
  if (free) waiting.push_back(flow.first());
  for (Address at = flow.first(); at < flow.last(); ++at)  // the code without P removes the limit
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

/// Programs that are entered without a limit, each once.
struct Entered {
  std::vector<std::int32_t> waiting;
  std::vector<bool> seen;

  void enter(std::int32_t program) {
    if (seen[static_cast<std::size_t>(program)]) return;
    seen[static_cast<std::size_t>(program)] = true;
    waiting.push_back(program);
  }
};

/// Return by program the blocks without a limit. A program has the limit of the blocks that call
/// it.
std::vector<std::vector<bool>> all_unlimited(const Checker& c) {
  std::vector<std::vector<bool>> free(c.flows.size());
  Entered entered{{}, std::vector<bool>(c.flows.size(), false)};
  std::vector<std::int32_t>& waiting = entered.waiting;
  for (const ProgramFlow& flow : c.flows)
    if (!c.is_called_by_another(flow.program())) entered.enter(flow.program());
  for (std::size_t next = 0; next < c.flows.size() || !waiting.empty();) {
    const bool of_callers = !waiting.empty();
    const auto program = of_callers ? waiting.back() : static_cast<std::int32_t>(next++);
    if (of_callers) waiting.pop_back();
    std::vector<bool>& own = free[static_cast<std::size_t>(program)];
    if (!of_callers && !own.empty()) continue;
    const ProgramFlow& flow = c.flow(program);
    own = unlimited(c, flow, of_callers);
    for (const CallEdge& edge : flow.calls())
      if (own[edge.from - flow.first()]) entered.enter(edge.called);
    if (c.over(flow.size())) break;
  }
  return free;
}

}  // namespace

void check_read_ahead(Checker& c) {
  // A program that never limits it is not meant to be read so closely.
  const int limit = c.g_codes.of(Meaning::LookAheadLimit).code;
  if (limit < 0 || !c.code.g_codes.test(static_cast<std::size_t>(limit))) return;
  const std::vector<std::vector<bool>> free = all_unlimited(c);
  for (const ProgramFlow& flow : c.flows) {
    const std::vector<bool>& own = free[static_cast<std::size_t>(flow.program())];
    if (c.inside(flow) || own.empty()) continue;
    for (Address at = flow.first(); at < flow.last() && !c.over(4); ++at) {
      if (!own[at - flow.first()]) continue;
      const Signal signal = signal_of(c, c.code.blocks[at], flow.program());
      if (signal.place.width == 0) continue;
      c.found(Check::InputAhead, at, signal.place,
              std::string("the control reads blocks ahead: the ") +
                  (signal.output ? "output may be set" : "input may be read") +
                  " before the blocks above have run");
    }
  }
}

}  // namespace cncsub
