// Finds modes that a called program switches on and leaves on for its caller.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "cncsub/analysis/mode_reader.hpp"

namespace cncsub {

namespace {

using namespace modes;

class ModeCheck {
 public:
  explicit ModeCheck(Checker& c) : c_(c), modes_(c) {}

  void run();

 private:
  std::vector<Modes> states_without(const ProgramFlow& flow, std::int32_t but) const;
  template <class Take>
  void each_entry(const ProgramFlow& flow, const Take& take) const;
  std::vector<const CallEdge*> calls_of(const ProgramFlow& flow) const;
  void reach(std::int32_t program, Address at, Modes modes);
  void go_on(std::int32_t program, Address at);
  void leave(std::int32_t program, Modes modes);
  void settle_group(const std::vector<std::uint32_t>& group);
  std::vector<std::uint32_t> moving(const ProgramFlow& flow) const;
  Address moves_with(const ProgramFlow& flow, Address call, int mode,
                     const std::vector<std::uint32_t>& moving) const;
  void leaks(const ProgramFlow& flow);
  void leak(const ProgramFlow& flow, const CallEdge& edge, Modes own,
            const std::vector<std::uint32_t>& moving,
            std::set<std::tuple<std::int32_t, int>>& reported);

  Checker& c_;
  ModeReader modes_;
  // By program:
  std::vector<Modes> left_;                          // what it leaves, 0 while it never returns
  std::vector<std::vector<Modes>> before_;           // what is in force before its blocks
  std::vector<std::vector<const CallEdge*>> calls_;  // of the programs that are worked on
  std::vector<bool> keeps_;                          // whether its return restores its modes
  std::vector<std::pair<std::int32_t, Address>> waiting_;  // program and block to go on from
  std::size_t looked_at_ = 0;  // blocks; those of a loop again for each call
};

/// Return what may be in force before each block if one of the called programs left nothing.
std::vector<Modes> ModeCheck::states_without(const ProgramFlow& flow, std::int32_t but) const {
  std::vector<Modes> before(flow.size(), 0);
  std::vector<Address> waiting;
  const auto reach = [&](Address at, Modes modes) {
    Modes& own = before[at - flow.first()];
    if ((own | modes) == own) return;
    own |= modes;
    waiting.push_back(at);
  };
  each_entry(flow, reach);
  const std::vector<const CallEdge*> calls = calls_of(flow);
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Modes modes = before[at - flow.first()];
    if (at < flow.last()) modes = modes_.after(modes, at);
    const CallEdge* edge = calls[at - flow.first()];
    if (edge != nullptr && edge->called != but)
      modes = through(modes, left_[static_cast<std::size_t>(edge->called)]);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) reach(exit->to, modes);
  }
  return before;
}

/// Call `take` with what is in force at each block where a program may begin.
template <class Take>
void ModeCheck::each_entry(const ProgramFlow& flow, const Take& take) const {
  take(flow.first(), c_.is_called(flow.program()) ? all(kFound) : at_first());
  for (const Address entry : flow.entries()) take(entry, all(kFound));
}

/// Return the calls of a program by their blocks.
std::vector<const CallEdge*> ModeCheck::calls_of(const ProgramFlow& flow) const {
  std::vector<const CallEdge*> calls(flow.size(), nullptr);
  for (const CallEdge& edge : flow.calls()) calls[edge.from - flow.first()] = &edge;
  return calls;
}

/// Add what may be in force before a block of a program that is worked on.
void ModeCheck::reach(std::int32_t program, Address at, Modes modes) {
  Modes& own = before_[static_cast<std::size_t>(program)][at - c_.flow(program).first()];
  if ((own | modes) == own) return;
  own |= modes;
  waiting_.emplace_back(program, at);
}

/// Go on from one block. A call leads nowhere until its program is known to return.
void ModeCheck::go_on(std::int32_t program, Address at) {
  const auto place = static_cast<std::size_t>(program);
  const ProgramFlow& flow = c_.flow(program);
  Modes modes = before_[place][at - flow.first()];
  if (at < flow.last()) modes = modes_.after(modes, at);
  if (at < flow.last() && flow.returns(at)) leave(program, modes);
  if (const CallEdge* edge = calls_[place][at - flow.first()]) {
    const Modes left = left_[static_cast<std::size_t>(edge->called)];
    if (left == 0) return;
    modes = through(modes, left);
  }
  for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
    reach(program, exit->to, modes);
}

/// Add what a program leaves where it returns; its callers go on where that is new.
void ModeCheck::leave(std::int32_t program, Modes modes) {
  if (keeps_[static_cast<std::size_t>(program)]) put(modes, kKept, false);
  if (c_.program(program).keeps_modes) modes = all(kFound);
  Modes& left = left_[static_cast<std::size_t>(program)];
  if ((left | modes) == left) return;
  left |= modes;
  const std::uint32_t group = c_.groups.of[static_cast<std::size_t>(program)];
  for (const CallEdge* edge : c_.callers_of(program))
    if (c_.groups.of[static_cast<std::size_t>(edge->caller)] == group)
      waiting_.emplace_back(edge->caller, edge->from);
}

/// Work until nothing new may be in force anywhere in the programs of a group.
void ModeCheck::settle_group(const std::vector<std::uint32_t>& group) {
  for (const std::uint32_t program : group) {
    const ProgramFlow& flow = c_.flows[program];
    before_[program].assign(flow.size(), 0);
    calls_[program] = calls_of(flow);
    keeps_[program] = modes_.keeps(flow);
    each_entry(flow, [&](Address at, Modes modes) { reach(flow.program(), at, modes); });
  }
  const auto work = [this] {
    while (!waiting_.empty() && !c_.over()) {
      const auto [program, at] = waiting_.back();
      waiting_.pop_back();
      if (before_[static_cast<std::size_t>(program)][at - c_.flow(program).first()] != 0)
        go_on(program, at);
    }
  };
  work();
  for (const std::uint32_t program : group)  // one that never returns leaves what it found
    if (left_[program] == 0) leave(static_cast<std::int32_t>(program), all(kFound));
  work();
  for (const std::uint32_t program : group) calls_[program] = {};
}

/// Return by block the modes with which some path from there moves before it sets them.
std::vector<std::uint32_t> ModeCheck::moving(const ProgramFlow& flow) const {
  const Arrows back = flow.backwards();
  std::vector<std::uint32_t> found(flow.size(), 0);
  std::vector<std::uint32_t> waiting;
  const auto add = [&](std::uint32_t place, std::uint32_t modes) {
    if ((found[place] | modes) == found[place]) return;
    found[place] |= modes;
    waiting.push_back(place);
  };
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (modes_.moves(at)) add(at - flow.first(), ~modes_.set_at(at));
  while (!waiting.empty() && !c_.over()) {
    const std::uint32_t to = waiting.back();
    waiting.pop_back();
    for (const std::uint32_t* from = back.begin(to); from != back.end(to); ++from) {
      const Address at = flow.first() + *from;
      if (at < flow.last() && modes_.leads_on(at)) add(*from, found[to] & ~modes_.set_at(at));
    }
  }
  return found;
}

/// Return the first block after a call that moves in a mode, where there is one.
Address ModeCheck::moves_with(const ProgramFlow& flow, Address call, int mode,
                              const std::vector<std::uint32_t>& moving) const {
  std::unordered_set<Address> seen;
  std::vector<Address> waiting;
  const auto go_on = [&](Address at) {
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      if ((moving[exit->to - flow.first()] >> mode & 1) != 0) waiting.push_back(exit->to);
  };
  go_on(call);
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (at >= flow.last() || !seen.insert(at).second) continue;
    if (modes_.moves(at)) return at;
    go_on(at);
  }
  return kNowhere;
}

/// Return the rule of a mode: modes that a program may leave on for good reasons are only noted.
Check rule_of(int mode) {
  if (mode == Length) return Check::LeavesLength;
  return mode == Work || mode == Origin ? Check::LeavesWork : Check::LeavesOn;
}

/// Return whether a called program leaves on modes that its caller may not have set.
bool may_leak(Modes left) {
  for (int mode = 0; mode < kModes; ++mode)
    if ((value(left, mode) & counted(mode)) != 0) return true;
  return false;
}

/// Return whether some block of a program leads back.
bool leads_back(const ProgramFlow& flow) {
  for (Address at = flow.first(); at < flow.last(); ++at)
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      if (exit->to <= at) return true;
  return false;
}

void ModeCheck::leaks(const ProgramFlow& flow) {
  constexpr std::size_t kMostCalled = 64;         // the program is visited once for each
  constexpr std::size_t kMostBlocks = 4'000'000;  // of all programs, in these visits
  const bool loops = leads_back(flow);
  const std::vector<Modes>& before = before_[static_cast<std::size_t>(flow.program())];
  std::map<std::int32_t, std::vector<Modes>> without;  // by called program, for loops
  std::vector<std::uint32_t> moving;
  std::set<std::tuple<std::int32_t, int>> reported;
  for (const CallEdge& edge : flow.calls()) {
    if (c_.over()) return;
    const Modes left = left_[static_cast<std::size_t>(edge.called)];
    if (before[edge.from - flow.first()] == 0 || !may_leak(left)) continue;
    if (moving.empty()) moving = this->moving(flow);
    const std::vector<Modes>* found = &before;
    const bool again = without.size() < kMostCalled && looked_at_ < kMostBlocks;
    if (loops && (without.contains(edge.called) || again)) {
      std::vector<Modes>& own = without[edge.called];
      if (own.empty()) {
        own = states_without(flow, edge.called);
        looked_at_ += flow.size();
      }
      found = &own;
    }
    leak(flow, edge, modes_.after((*found)[edge.from - flow.first()], edge.from), moving, reported);
  }
}

/// Report the modes that one call leaves on and that its caller had not set. Each is reported at
/// the first call that leaves it on.
void ModeCheck::leak(const ProgramFlow& flow, const CallEdge& edge, Modes own,
                     const std::vector<std::uint32_t>& moving,
                     std::set<std::tuple<std::int32_t, int>>& reported) {
  const Modes left = left_[static_cast<std::size_t>(edge.called)];
  std::uint32_t with = 0;  // the modes with which the blocks after the call move
  for (const Exit* exit = flow.begin(edge.from); exit != flow.end(edge.from); ++exit)
    with |= moving[exit->to - flow.first()];
  for (int mode = 0; mode < kModes; ++mode) {
    const Modes leak = value(left, mode) & counted(mode) & ~value(own, mode);
    if (leak == 0 || (with >> mode & 1) == 0 || (value(own, mode) & kFound) != 0 ||
        !reported.insert({edge.called, mode}).second)
      continue;
    const CallRecord& record = c_.code.calls[edge.record];
    const TextPlace place{record.at, record.width};
    const std::string cause = std::to_string(edge.called) + " " + std::to_string(mode);
    if (c_.known(rule_of(mode), cause, edge.from, place)) continue;
    const Address moves = moves_with(flow, edge.from, mode, moving);
    Finding& found = c_.found(rule_of(mode), edge.from, place,
                              c_.code.name_of(edge.called) + " leaves " + modes_.name(mode, leak) +
                                  " on, and line " + std::to_string(c_.code.blocks[moves].line) +
                                  " moves with it");
    if (begins_with_label(c_.code, c_.flow(edge.called).first()))
      found.hint = "switch it off before endsub, or set the mode again in the caller";
  }
}

void ModeCheck::run() {
  const std::size_t count = c_.flows.size();
  left_.resize(count);
  before_.resize(count);
  calls_.resize(count);
  keeps_.resize(count);
  for (const auto& group : c_.groups.groups) settle_group(group);
  for (const ProgramFlow& flow : c_.flows)
    if (!flow.calls().empty() && !c_.over()) leaks(flow);
}

}  // namespace

void check_modes(Checker& c) {
  const bool calls = std::any_of(c.flows.begin(), c.flows.end(),
                                 [](const ProgramFlow& flow) { return !flow.calls().empty(); });
  if (calls) ModeCheck(c).run();
}

}  // namespace cncsub
