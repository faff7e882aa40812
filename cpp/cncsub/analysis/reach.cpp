// Finds blocks that are never reached, and programs that end wrongly.
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/analysis/profiles.hpp"
#include "cncsub/control/spelled.hpp"

namespace cncsub {

namespace {

/// Mark the profile that a cycle cuts: from the block of P, the nearest after the cycle, to that of
/// Q. `begun` counts by block the profiles that begin there less those that end before it.
void mark_profile(Checker& c, const ProgramFlow& flow, Address at, std::vector<int>& begun) {
  const Program& program = c.program(flow.program());
  const auto [p, q, from, to] = profile_of(c.code, program, at);
  if ((p >= 0 && from == kNowhere) || (q >= 0 && to == kNowhere)) {
    Fault fault{.cause = Cause::PqNotFound,
                .detail = c.code.no_block(from == kNowhere ? p : q, program),
                .word = {.addresses = bit(from == kNowhere ? 'P' : 'Q')}};
    c.refused(Check::TargetMissing, at, std::move(fault));
  }
  if (from == kNowhere || to == kNowhere || to < from) return;
  ++begun[from - flow.first()];
  --begun[to - flow.first() + 1];
}

/// Mark the blocks of profiles as reached: the cycle executes its profile wherever it stands. The
/// profile must exist, and no block in it may call.
void mark_profiles(Checker& c, const ProgramFlow& flow, std::vector<bool>& reached) {
  std::vector<int> begun;
  for (Address at = flow.first(); at < flow.last() && !c.over(); ++at) {
    if (!cuts_profile(c.code, c.g_codes, c.code.blocks[at])) continue;
    begun.resize(flow.size(), 0);
    mark_profile(c, flow, at, begun);
  }
  int inside = 0;
  for (std::size_t i = 0; i < begun.size(); ++i) {
    inside += begun[i];
    if (inside == 0) continue;
    reached[i] = true;
    const Address at = flow.first() + static_cast<Address>(i);
    const Block& block = c.code.blocks[at];
    if (!is_call(block.op)) continue;
    const CallRecord& call = c.code.calls[block.aux];
    c.refused(Check::Refused, at,
              {Cause::ProfileCall, call.at, call.width, "a call inside the blocks of the profile"});
  }
}

/// Return the blocks from which some path reaches M99.
std::vector<bool> leading_back(const ProgramFlow& flow) {
  const Arrows back = flow.backwards();
  std::vector<bool> found(flow.size(), false);
  std::vector<std::uint32_t> waiting;
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (flow.returns(at)) waiting.push_back(at - flow.first());
  while (!waiting.empty()) {
    const std::uint32_t place = waiting.back();
    waiting.pop_back();
    if (found[place]) continue;
    found[place] = true;
    waiting.insert(waiting.end(), back.begin(place), back.end(place));
  }
  return found;
}

/// Return whether a block does something that somebody would miss.
bool does_something(const Block& block) {
  if (block.length == 0) return false;  // no text: the end that a reader adds
  switch (block.op) {
    case Op::Words:
      return block.mask != 0 || block.has_codes();
    case Op::EndProgram:
    case Op::Return:
    case Op::EndOfRecord:
    case Op::EndFor:
    case Op::EndDo:
    case Op::Else:
    case Op::EndIf:
    case Op::OWord:
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
            count == 1 ? "no jump or call reaches this block"
                       : "no jump or call reaches these " + std::to_string(count) + " blocks");
  }
}

/// Return whether only a called part of a program, at a block of its own, runs to the end of the
/// text.
bool only_parts_end(const Checker& c, const ProgramFlow& flow) {
  if (flow.entries().empty() || c.is_called_by_another(flow.program())) return false;
  return !flow.calls_computed() && !flow.reached_from(flow.first())[flow.last() - flow.first()];
}

/// Offer a return at the end of a program that is only called, or of its called part: nothing else
/// can be meant.
void mend_end(const Checker& c, const ProgramFlow& flow, Finding& found) {
  const std::string code = return_code(*c.code.control);
  if (code.empty()) return;
  const Program& program = c.program(flow.program());
  const bool called = c.is_called(flow.program()) && flow.program() != c.main && !flow.ever_ends();
  if (!called && !only_parts_end(c, flow)) return;
  const std::string_view text = c.code.files[program.file].text.view();
  const Block& last = c.code.blocks[flow.last() - 1];
  const std::size_t end = std::min(text.find('\n', last.text), text.size());
  if (program.text_end < end) return;  // another program begins in the line
  found.edits.push_back({flow.last() - 1, {static_cast<std::uint32_t>(end), 0}, "\n" + code});
}

/// Report a program that runs into its end.
void check_end(Checker& c, const ProgramFlow& flow, bool reached) {
  if (!reached) return;
  const Program& program = c.program(flow.program());
  const bool alarms = c.code.control->reading.missing_end.value == MissingEnd::Alarm;
  const std::string what =
      c.code.name_of(program) + spelled(" ends without {end-or-return}", *c.code.control);
  if (!alarms && (!c.is_called(flow.program()) || flow.last() == flow.first())) return;
  const bool empty = flow.last() == flow.first();
  const Address at = empty ? flow.last() : flow.last() - 1;
  // The refused block may have been the end.
  if (c.code.blocks[at].op == Op::Fault || means_m99(c, flow)) return;
  const Block& last = c.code.blocks[at];
  Finding& found = c.found(Check::NoEnd, at, {last.text, last.length}, what);
  if (!empty) mend_end(c, flow, found);
  if (!alarms) return;
  found.alarm = Fault{Cause::EndOfRecord, program.text_end, 1, what};
  found.alarm_block = flow.last();
}

/// Return the first reached block that ends the run; kNowhere where none does, or where one
/// returns.
Address only_end(const ProgramFlow& flow, const std::vector<bool>& reached) {
  Address end = kNowhere;
  for (Address at = flow.first(); at < flow.last(); ++at) {
    if (!reached[at - flow.first()]) continue;
    if (flow.returns(at)) return kNowhere;
    if (flow.ends(at) && end == kNowhere) end = at;
  }
  return end;
}

void check_ends_in_call(Checker& c, const ProgramFlow& flow, const std::vector<bool>& reached) {
  if (!c.is_called(flow.program()) || flow.program() == c.main || !flow.ever_ends()) return;
  const Address at = only_end(flow, reached);
  if (at == kNowhere) return;
  const CallEdge& call = *c.callers_of(flow.program()).front();
  const Block& block = c.code.blocks[at];
  Finding& found =
      c.found(Check::EndsInCall, at, {block.text, block.length},
              c.code.name_of(flow.program()) + " is called from " + c.code.name_of(call.caller));
  found.path = {call.from};
  if (begins_with_label(c.code, flow.first())) found.hint = "write a return with its label instead";
}

/// Report parts of a main program that it calls and also runs into.
void check_fallen_into(Checker& c, const ProgramFlow& flow) {
  if (flow.entries().empty() || c.is_called_by_another(flow.program())) return;
  const std::vector<bool> reached = flow.reached_from(flow.first());
  std::vector<bool> back;  // filled when it is first needed
  std::set<Address> reported;
  for (const CallEdge& edge : flow.calls()) {
    const Address start = edge.start;
    const bool part = edge.called == flow.program() && start > flow.first() && start < flow.last();
    if (!part || !reached[start - 1 - flow.first()] || !reported.insert(start).second) continue;
    const bool falls = std::any_of(flow.begin(start - 1), flow.end(start - 1), [&](const Exit& of) {
      return of.to == start && of.kind == ExitKind::Next;
    });
    if (!falls) continue;
    if (back.empty()) back = leading_back(flow);
    if (!back[start - flow.first()]) continue;
    const Block& block = c.code.blocks[start];
    c.found(Check::FallenInto, start, {block.text, block.length},
            "line " + std::to_string(c.code.blocks[edge.from].line) +
                " calls this part, and the block before runs on into it")
        .path = {edge.from};
  }
}

/// Return the programs that a reached block might have led into, were it not refused.
std::vector<bool> unsure_programs(const Checker& c, const std::vector<std::vector<bool>>& reached) {
  std::vector<bool> unsure(c.flows.size(), false);
  for (const auto& [program, because] : c.unsure) {
    const std::int32_t own = c.code.program_at(because);
    const std::size_t place = because - c.flow(own).first();
    const std::vector<bool>& of = reached[static_cast<std::size_t>(own)];
    if (place >= of.size() || of[place]) unsure[static_cast<std::size_t>(program)] = true;
  }
  return unsure;
}

/// Report a program that returns and never ends, and that nothing calls.
void check_never_called(Checker& c, const ProgramFlow& flow) {
  const Program& program = c.program(flow.program());
  const bool only_called = flow.ever_returns() && !flow.ever_ends();
  const bool called = c.is_called(flow.program()) || flow.program() == c.main ||
                      c.is_entry(flow.program()) ||
                      c.named[static_cast<std::size_t>(flow.program())] ||
                      defines_for_all(*c.code.spelling, c.code.files[program.file]);
  if (!only_called || called || program.duplicate_of != kNoProgram || c.flows.size() <= 1) return;
  const Block& first = c.code.blocks[flow.first()];
  c.found(Check::NeverCalled, flow.first(), {first.text, first.length},
          "no program here calls " + c.code.name_of(program));
}

/// Report each reached % that the control refuses.
void check_tape_ends(Checker& c, const ProgramFlow& flow, const std::vector<bool>& reached) {
  if (!flow.has_labels()) return;
  for (Address at = flow.first(); at < flow.last(); ++at) {
    if (!reached[at - flow.first()] || c.code.blocks[at].op != Op::OWord) continue;
    const OWord& own = c.code.o_words[c.code.blocks[at].aux];
    if (own.kind == OWordKind::FileEnd && own.refused != OWord::kNone)
      c.refused(Check::Refused, at, c.code.faults[own.refused]);
  }
}

}  // namespace

void check_reach(Checker& c) {
  bool computed = false, starts = false, labels = false;
  for (const ProgramFlow& flow : c.flows) {
    computed = computed || flow.calls_computed();
    starts = starts || flow.starts_computed();
    labels = labels || flow.has_labels();
  }
  std::vector<std::vector<bool>> all_reached(c.flows.size());
  for (const ProgramFlow& flow : c.flows) {
    if (c.over(flow.size())) return;
    all_reached[static_cast<std::size_t>(flow.program())] = flow.reached();
  }
  const std::vector<bool> unsure = unsure_programs(c, all_reached);
  for (const ProgramFlow& flow : c.flows) {
    if (c.over(flow.size())) return;
    std::vector<bool>& reached = all_reached[static_cast<std::size_t>(flow.program())];
    check_ends_in_call(c, flow, reached);
    if (c.inside(flow)) continue;
    if (!labels) check_end(c, flow, reached[flow.last() - flow.first()]);
    mark_profiles(c, flow, reached);
    if (!starts && !unsure[static_cast<std::size_t>(flow.program())])
      check_unreached(c, flow, reached);
    check_tape_ends(c, flow, reached);
    check_fallen_into(c, flow);
    if (!computed) check_never_called(c, flow);
  }
}

}  // namespace cncsub
