// What is reached, and how programs end.
#include <algorithm>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

bool follows_profile(Meaning meaning) {
  return meaning == Meaning::Finish || meaning == Meaning::RoughTurn ||
         meaning == Meaning::RoughFace || meaning == Meaning::RoughPattern;
}

/// The value of a word that is written as a number, -1 where there is none.
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

bool cuts_profile(const Checker& c, const Block& block) {
  if ((block.mask & bit('P')) == 0 || (block.mask & bit('Q')) == 0) return false;
  bool cuts = false;
  each_g(c.code, block, [&](int g) { cuts = cuts || follows_profile(c.g_codes.find(g).meaning); });
  return cuts;
}

/// The profile that a cycle cuts is executed by the cycle, wherever it stands; it must be there.
void mark_profiles(Checker& c, const ProgramFlow& flow, std::vector<bool>& reached) {
  const Program& program = c.program(flow.program());
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const Block& block = c.code.blocks[at];
    if (!cuts_profile(c, block)) continue;
    const std::int64_t p = written(c.code, block, 'P'), q = written(c.code, block, 'Q');
    const Address from = c.code.first_of(program, p), to = c.code.first_of(program, q);
    if ((p >= 0 && from == kNowhere) || (q >= 0 && to == kNowhere)) {
      Fault fault{.cause = Cause::PqNotFound,
                  .detail = c.code.no_block(from == kNowhere ? p : q, program),
                  .address = from == kNowhere ? 'P' : 'Q'};
      c.refused(Check::TargetMissing, at, std::move(fault));
    }
    if (from == kNowhere || to == kNowhere || to < from || reached[to - flow.first()]) continue;
    std::fill(reached.begin() + (from - flow.first()), reached.begin() + (to - flow.first()) + 1,
              true);
  }
}

/// Whether a block does something that somebody would miss.
bool does_something(const Block& block) {
  switch (block.op) {
    case Op::Words:
      return block.mask != 0 || block.g_count != 0 || block.m_count != 0;
    case Op::EndProgram:
    case Op::Return:
    case Op::EndOfRecord:
    case Op::EndDo:
    case Op::Else:
    case Op::EndIf:
    case Op::Labelled:
      return false;
    default:
      return true;
  }
}

void check_unreached(Checker& c, const ProgramFlow& flow, const std::vector<bool>& reached) {
  const auto is_reached = [&](Address at) { return reached[at - flow.first()]; };
  for (Address at = flow.first(); at < flow.last(); ++at) {
    if (is_reached(at)) continue;
    const Address from = at;
    Address first = kNowhere;
    for (; at < flow.last() && !is_reached(at); ++at)
      if (first == kNowhere && does_something(c.code.blocks[at])) first = at;
    if (first == kNowhere) continue;
    const Block& block = c.code.blocks[first];
    const std::size_t count = at - from;
    c.found(Check::Unreachable, first, {block.text, block.length},
            count == 1 ? "no way leads to this block"
                       : "no way leads to these " + std::to_string(count) + " blocks");
  }
}

/// What runs into its end.
void check_end(Checker& c, const ProgramFlow& flow, bool reached) {
  if (!reached) return;
  const Program& program = c.program(flow.program());
  const bool alarms = c.code.control->reading.missing_end.value == MissingEnd::Alarm;
  const std::string what = c.code.name_of(program) + " ends without M02, M30 or M99";
  if (!alarms && (!c.is_called(flow.program()) || flow.last() == flow.first())) return;
  const Address at = flow.last() > flow.first() ? flow.last() - 1 : flow.last();
  const Block& last = c.code.blocks[at];
  Finding& found = c.found(Check::NoEnd, at, {last.text, last.length}, what);
  if (!alarms) return;
  found.alarm = Fault{Cause::EndOfRecord, program.text_end, 1, what};
  found.alarm_block = flow.last();
}

void check_ends_in_call(Checker& c, const ProgramFlow& flow) {
  if (!c.is_called(flow.program()) || flow.program() == c.main || !flow.ever_ends() ||
      flow.ever_returns())
    return;
  Address at = flow.first();
  while (!flow.ends(at)) ++at;
  const CallEdge& call = c.callers[static_cast<std::size_t>(flow.program())].front();
  const Block& block = c.code.blocks[at];
  c.found(Check::EndsInCall, at, {block.text, block.length},
          c.code.name_of(flow.program()) + " is called from " + c.code.name_of(call.caller))
      .path = {call.from};
}

}  // namespace

void check_reach(Checker& c) {
  bool computed = false, starts = false, labels = false;
  for (const ProgramFlow& flow : c.flows) {
    computed = computed || flow.calls_computed();
    starts = starts || flow.starts_computed();
    labels = labels || flow.has_labels();
  }
  for (const ProgramFlow& flow : c.flows) {
    const Program& program = c.program(flow.program());
    if (c.inside(flow)) continue;
    std::vector<bool> reached = flow.reached();
    if (!labels) check_end(c, flow, reached[flow.last() - flow.first()]);
    mark_profiles(c, flow, reached);
    if (!starts) check_unreached(c, flow, reached);
    check_ends_in_call(c, flow);
    const bool only_called = flow.ever_returns() && !flow.ever_ends();
    if (!computed && only_called && !c.is_called(flow.program()) && flow.program() != c.main &&
        program.duplicate_of == kNoProgram && c.flows.size() > 1 &&
        !c.named[static_cast<std::size_t>(flow.program())])
      c.found(Check::NeverCalled, flow.first(),
              {c.code.blocks[flow.first()].text, c.code.blocks[flow.first()].length},
              "no program here calls " + c.code.name_of(program));
  }
}

}  // namespace cncsub
