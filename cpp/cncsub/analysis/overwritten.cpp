// Variables that a program uses as its own, and that a program it calls uses as its own too.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "cncsub/analysis/variable_use.hpp"

namespace cncsub {

namespace {

using Numbers = std::vector<std::int32_t>;

/// As many numbers from one on as there are bits.
Numbers some_of(const Numbers& all, std::size_t first) {
  const std::size_t last = std::min(all.size(), first + kMostBits);
  return {all.begin() + static_cast<std::ptrdiff_t>(first),
          all.begin() + static_cast<std::ptrdiff_t>(last)};
}

class OverwrittenCheck {
 public:
  OverwrittenCheck(Checker& c, const VariableUses& uses)
      : c_(c), uses_(uses), scratch_(c.flows.size()) {}
  void run();

 private:
  /// Variables that have a value of the program's own, and those that a called program has taken.
  struct State {
    Bits own = 0, lost = 0;
    bool reached = false;
  };

  Numbers read_and_written(const ProgramFlow& flow) const;
  bool is_argument(std::int32_t program, std::int32_t number) const;
  const Numbers& scratch(std::int32_t program);
  void find_taken();
  bool hand_on(const CallEdge& edge);
  Bits handed_over(const ProgramFlow& flow, const Numbers& both) const;
  Bits overwrites(const CallEdge& edge, const Numbers& candidates);
  State behind(Address at, const ProgramFlow& flow, State state, const Numbers& candidates,
               Bits& read);
  void tell_overwritten(const ProgramFlow& flow);
  void tell_overwritten(const ProgramFlow& flow, const Numbers& candidates);
  void tell_lost(const ProgramFlow& flow, Address at, std::int32_t number);

  Checker& c_;
  const VariableUses& uses_;
  std::vector<std::optional<Numbers>> scratch_;
  std::vector<Numbers> taken_;  // by program: what it and those that it calls use as their own
  std::vector<std::vector<const CallEdge*>> calls_at_;  // of the program that is looked at
};

/// The variables that a program both reads and writes; none where it may use any.
Numbers OverwrittenCheck::read_and_written(const ProgramFlow& flow) const {
  std::map<std::int32_t, std::pair<bool, bool>> seen;  // number: read, written
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const VariableUse* own = uses_.of(at)) {
      if (own->any) return {};
      for (const std::int32_t number : own->reads) seen[number].first = true;
      for (const std::int32_t number : own->writes) seen[number].second = true;
    }
  Numbers both;
  for (const auto& [number, how] : seen)
    if (how.first && how.second) both.push_back(number);
  return both;
}

/// Whether some call gives the local as an argument: then it is the program's own from the start.
bool OverwrittenCheck::is_argument(std::int32_t program, std::int32_t number) const {
  for (const CallEdge& edge : c_.callers[static_cast<std::size_t>(program)]) {
    const CallRecord& record = c_.code.calls[edge.record];
    for (std::uint32_t i = 0; edge.macro && i < record.arguments; ++i)
      if (c_.code.arguments[record.first_argument + i].variable == number) return true;
  }
  return false;
}

/// The variables that a program uses as its own: it writes each before it reads it, or has it as an
/// argument, and reads it.
const Numbers& OverwrittenCheck::scratch(std::int32_t program) {
  auto& known = scratch_[static_cast<std::size_t>(program)];
  if (known) return *known;
  known.emplace();
  const ProgramFlow& flow = c_.flow(program);
  const Numbers all = read_and_written(flow);
  for (std::size_t first = 0; first < all.size(); first += kMostBits) {
    const Numbers both = some_of(all, first);
    const Bits handed = handed_over(flow, both);
    for (std::size_t i = 0; i < both.size(); ++i)
      if ((handed >> i & 1) == 0 || (uses_.is_local(both[i]) && is_argument(program, both[i])))
        known->push_back(both[i]);
  }
  return *known;
}

/// Which of these variables some way reads before it writes them.
Bits OverwrittenCheck::handed_over(const ProgramFlow& flow, const Numbers& both) const {
  std::vector<Bits> unwritten(flow.size(), 0);
  std::vector<Address> waiting{flow.first()};
  unwritten[0] = both.empty() ? 0 : ~Bits{0} >> (kMostBits - static_cast<int>(both.size()));
  Bits handed = 0;
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Bits state = unwritten[at - flow.first()];
    if (const VariableUse* own = at < flow.last() ? uses_.of(at) : nullptr) {
      handed |= state & bits_of(both, own->reads);
      state &= ~bits_of(both, own->writes);
    }
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) {
      Bits& next = unwritten[exit->to - flow.first()];
      if ((next | state) == next) continue;
      next |= state;
      waiting.push_back(exit->to);
    }
  }
  return handed;
}

/// What the called program of a call takes, its caller takes too; whether that is more.
bool OverwrittenCheck::hand_on(const CallEdge& edge) {
  Numbers& own = taken_[static_cast<std::size_t>(edge.caller)];
  Numbers more;
  for (const std::int32_t number : taken_[static_cast<std::size_t>(edge.called)]) {
    const bool shared = !edge.macro || !uses_.is_local(number);
    if (shared && !std::binary_search(own.begin(), own.end(), number)) more.push_back(number);
  }
  own.insert(own.end(), more.begin(), more.end());
  std::sort(own.begin(), own.end());
  return !more.empty();
}

void OverwrittenCheck::find_taken() {
  taken_.resize(c_.flows.size());
  std::vector<std::int32_t> waiting;
  for (const ProgramFlow& flow : c_.flows) {
    const std::int32_t program = flow.program();
    if (!c_.is_called(program)) continue;
    taken_[static_cast<std::size_t>(program)] = scratch(program);
    if (!scratch(program).empty()) waiting.push_back(program);
  }
  while (!waiting.empty()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    for (const CallEdge& edge : c_.callers[static_cast<std::size_t>(program)])
      if (c_.is_called(edge.caller) && edge.caller != program && hand_on(edge))
        waiting.push_back(edge.caller);
  }
}

void OverwrittenCheck::tell_overwritten(const ProgramFlow& flow) {
  Numbers own, called;
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const VariableUse* of = uses_.of(at))
      own.insert(own.end(), of->writes.begin(), of->writes.end());
  std::sort(own.begin(), own.end());
  for (const CallEdge& edge : flow.calls()) {
    if (edge.called == flow.program()) continue;
    for (const std::int32_t number : taken_[static_cast<std::size_t>(edge.called)]) {
      const bool shared = !edge.macro || !uses_.is_local(number);
      if (shared && std::binary_search(own.begin(), own.end(), number)) called.push_back(number);
    }
  }
  std::sort(called.begin(), called.end());
  called.erase(std::unique(called.begin(), called.end()), called.end());
  for (std::size_t first = 0; first < called.size(); first += kMostBits)
    tell_overwritten(flow, some_of(called, first));
}

/// What a call of a program makes of its caller's variables.
Bits OverwrittenCheck::overwrites(const CallEdge& edge, const Numbers& candidates) {
  Bits found = 0;
  const Numbers& of = taken_[static_cast<std::size_t>(edge.called)];
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool shared = !edge.macro || !uses_.is_local(candidates[i]);
    if (shared && std::binary_search(of.begin(), of.end(), candidates[i])) found |= Bits{1} << i;
  }
  return found;
}

/// What a block and the programs it calls make of the variables; `read` are those that the program
/// reads as its own anywhere.
OverwrittenCheck::State OverwrittenCheck::behind(Address at, const ProgramFlow& flow, State state,
                                                 const Numbers& candidates, Bits& read) {
  if (const VariableUse* of = at < flow.last() ? uses_.of(at) : nullptr) {
    read |= state.own & bits_of(candidates, of->reads);
    const Bits set = bits_of(candidates, of->writes);
    state.own = of->any ? 0 : state.own | set;
    state.lost = of->any ? 0 : state.lost & ~set;
  }
  for (const CallEdge* edge : calls_at_[at - flow.first()]) {
    const Bits lost = state.own & overwrites(*edge, candidates);
    state.own &= ~lost;
    state.lost |= lost;
  }
  return state;
}

/// Of these variables those that the program reads as its own, and reads again as its own after a
/// called program has used them.
void OverwrittenCheck::tell_overwritten(const ProgramFlow& flow, const Numbers& candidates) {
  std::vector<State> before(flow.size());
  std::vector<Address> waiting{flow.first()};
  before[0].reached = true;
  Bits read = 0;
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    const State state = behind(at, flow, before[at - flow.first()], candidates, read);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) {
      State& next = before[exit->to - flow.first()];
      const State old = next;
      next = {next.own | state.own, next.lost | state.lost, true};
      if (!old.reached || next.own != old.own || next.lost != old.lost) waiting.push_back(exit->to);
    }
  }
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const VariableUse* of = uses_.of(at);
    if (of == nullptr) continue;
    const Bits lost = bits_of(candidates, of->reads) & before[at - flow.first()].lost & read;
    read &= ~lost;  // told once
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if ((lost >> i & 1) != 0) tell_lost(flow, at, candidates[i]);
  }
}

void OverwrittenCheck::tell_lost(const ProgramFlow& flow, Address at, std::int32_t number) {
  for (const CallEdge& edge : flow.calls()) {
    if (overwrites(edge, {number}) == 0) continue;
    const bool local = uses_.is_local(number);
    const Numbers& own = scratch(edge.called);
    const bool itself = std::binary_search(own.begin(), own.end(), number);
    c_.found(local ? Check::SharedLocal : Check::SharedCommon, at, uses_.place_of(at, number),
             c_.code.name_of(edge.called) + ", called in line " +
                 std::to_string(c_.code.blocks[edge.from].line) +
                 (itself ? ", has overwritten " : ", and what it calls have overwritten ") +
                 uses_.name_of(number))
        .path = {edge.from};
    return;
  }
}

void OverwrittenCheck::run() {
  find_taken();
  for (const ProgramFlow& flow : c_.flows) {
    if (flow.calls().empty()) continue;
    calls_at_ = calls_by_block(flow);
    tell_overwritten(flow);
  }
}

}  // namespace

void check_overwritten(Checker& c, const VariableUses& uses) { OverwrittenCheck(c, uses).run(); }

}  // namespace cncsub
