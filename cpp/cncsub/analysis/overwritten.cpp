// Finds variables that a program uses as its own, and that a program it calls uses as its own too.
#include <algorithm>
#include <bit>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "cncsub/analysis/variable_use.hpp"

namespace cncsub {

namespace {

using Numbers = std::vector<std::int32_t>;

constexpr std::size_t kMostWords = 16;  // words of bits: variables beyond them are not checked

/// Variables as bits, by their places in the numbering.
using Set = std::vector<Bits>;

/// A variable that has a bit.
struct Numbered {
  std::int32_t number;
  bool local;
};

/// The variables that some program both reads and writes.
class Numbering {
 public:
  std::size_t count() const { return all_.size(); }
  std::size_t words() const { return (all_.size() + kMostBits - 1) / kMostBits; }
  const Numbered& of(std::size_t place) const { return all_[place]; }
  void add(std::int32_t number, bool local) {
    if (all_.size() >= kMostWords * kMostBits || !places_.try_emplace(number, all_.size()).second)
      return;
    all_.push_back({number, local});
  }
  void mark(Set& set, std::int32_t number) const {
    if (const auto found = places_.find(number); found != places_.end())
      set[found->second / kMostBits] |= Bits{1} << (found->second % kMostBits);
  }
  /// Return the bits of those variables of `numbers` that stand in one word.
  Bits bits(const Numbers& numbers, std::size_t word) const {
    Bits found = 0;
    for (const std::int32_t number : numbers) {
      const auto at = places_.find(number);
      if (at != places_.end() && at->second / kMostBits == word)
        found |= Bits{1} << (at->second % kMostBits);
    }
    return found;
  }

 private:
  std::vector<Numbered> all_;
  std::unordered_map<std::int32_t, std::size_t> places_;
};

class OverwrittenCheck {
 public:
  OverwrittenCheck(Checker& c, const VariableUses& uses) : c_(c), uses_(uses) {}
  void run();

 private:
  /// The variables that hold a value of the program's own, and those that a called program
  /// overwrote.
  struct State {
    Bits own = 0, lost = 0;
    bool reached = false;
  };

  void number_all();
  void add_both(const ProgramFlow& flow, Numbers& both) const;
  Set written(const ProgramFlow& flow) const;
  Set read_and_written(const ProgramFlow& flow) const;
  Set arguments(std::int32_t program) const;
  void find_scratch(const ProgramFlow& flow);
  Bits handed_over(const ProgramFlow& flow, std::size_t word) const;
  void find_taken();
  void take_until_settled(std::vector<std::uint32_t> waiting);
  bool take_called(std::uint32_t program);
  void share_commons(const std::vector<std::uint32_t>& group);
  Bits taken_by(const CallEdge& edge, std::size_t word) const;
  State behind(Address at, const ProgramFlow& flow, State state, std::size_t word, Bits& read);
  void tell_overwritten(const ProgramFlow& flow);
  void tell_overwritten(const ProgramFlow& flow, std::size_t word);
  void tell_lost(const ProgramFlow& flow, Address at, std::size_t place);

  Checker& c_;
  const VariableUses& uses_;
  Numbering numbering_;
  std::vector<Bits> locals_;                            // by word, the bits of the locals
  std::vector<Set> scratch_;                            // by program: what it uses as its own
  std::vector<Set> taken_;                              // by program: with what it calls too
  std::vector<std::vector<const CallEdge*>> calls_at_;  // of the program that is checked
};

/// Add the numbers of the variables that a program both reads and writes.
void OverwrittenCheck::add_both(const ProgramFlow& flow, Numbers& both) const {
  std::unordered_set<std::int32_t> read, written;
  for (Address at = flow.first(); at < flow.last() && !c_.over(); ++at)
    if (const VariableUse* own = uses_.of(at)) {
      read.insert(own->reads.begin(), own->reads.end());
      written.insert(own->writes.begin(), own->writes.end());
    }
  for (const std::int32_t number : written)
    if (read.contains(number)) both.push_back(number);
}

/// Give bits to the variables that some program both reads and writes.
void OverwrittenCheck::number_all() {
  Numbers both;
  for (const ProgramFlow& flow : c_.flows) add_both(flow, both);
  std::sort(both.begin(), both.end());
  for (const std::int32_t number : both) numbering_.add(number, uses_.is_local(number));
  locals_.resize(numbering_.words());
  for (std::size_t i = 0; i < numbering_.count(); ++i)
    if (numbering_.of(i).local) locals_[i / kMostBits] |= Bits{1} << (i % kMostBits);
}

Set OverwrittenCheck::written(const ProgramFlow& flow) const {
  Set found(numbering_.words());
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const VariableUse* own = uses_.of(at))
      for (const std::int32_t number : own->writes) numbering_.mark(found, number);
  return found;
}

/// Return the variables that a program both reads and writes; none where it may use any.
Set OverwrittenCheck::read_and_written(const ProgramFlow& flow) const {
  Set read(numbering_.words());
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const VariableUse* own = uses_.of(at)) {
      if (own->any) return Set(numbering_.words());
      for (const std::int32_t number : own->reads) numbering_.mark(read, number);
    }
  const Set written = this->written(flow);
  for (std::size_t i = 0; i < read.size(); ++i) read[i] &= written[i];
  return read;
}

/// Return the locals that some call gives as an argument: they are the program's own from the
/// start.
Set OverwrittenCheck::arguments(std::int32_t program) const {
  Set found(numbering_.words());
  for (const CallEdge* edge : c_.callers_of(program)) {
    const CallRecord& record = c_.code.calls[edge->record];
    for (std::uint32_t i = 0; edge->macro && i < record.arguments; ++i)
      numbering_.mark(found, c_.code.arguments[record.first_argument + i].variable);
  }
  for (std::size_t i = 0; i < found.size(); ++i) found[i] &= locals_[i];
  return found;
}

/// Find the variables that a program uses as its own: it writes each before it reads it, or gets it
/// as an argument, and reads it.
void OverwrittenCheck::find_scratch(const ProgramFlow& flow) {
  Set& known = scratch_[static_cast<std::size_t>(flow.program())];
  known = read_and_written(flow);
  if (std::all_of(known.begin(), known.end(), [](Bits bits) { return bits == 0; })) return;
  const Set given = arguments(flow.program());
  for (std::size_t word = 0; word < known.size(); ++word)
    if (known[word] != 0) known[word] &= ~handed_over(flow, word) | given[word];
}

/// Return those of the program's own variables that some path reads before it writes them.
Bits OverwrittenCheck::handed_over(const ProgramFlow& flow, std::size_t word) const {
  std::vector<Bits> unwritten(flow.size(), 0);
  std::vector<Address> waiting{flow.first()};
  unwritten[0] = scratch_[static_cast<std::size_t>(flow.program())][word];
  Bits handed = 0;
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Bits state = unwritten[at - flow.first()];
    if (const VariableUse* own = at < flow.last() ? uses_.of(at) : nullptr) {
      handed |= state & numbering_.bits(own->reads, word);
      state &= ~numbering_.bits(own->writes, word);
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

/// Return the variables of its caller that the called program of a call takes.
Bits OverwrittenCheck::taken_by(const CallEdge& edge, std::size_t word) const {
  const Bits taken = taken_[static_cast<std::size_t>(edge.called)][word];
  return edge.macro ? taken & ~locals_[word] : taken;
}

/// Add what the called programs of a program take to what it takes; return whether that is new.
bool OverwrittenCheck::take_called(std::uint32_t program) {
  Set& own = taken_[program];
  bool more = false;
  for (const CallEdge& edge : c_.flows[program].calls())
    for (std::size_t word = 0; edge.called != edge.caller && word < own.size(); ++word) {
      const Bits all = own[word] | taken_by(edge, word);
      more = more || all != own[word];
      own[word] = all;
    }
  return more;
}

/// Give each program of a group the commons that any of them takes: they call each other.
void OverwrittenCheck::share_commons(const std::vector<std::uint32_t>& group) {
  Set all(numbering_.words());
  for (const std::uint32_t program : group) {
    take_called(program);
    for (std::size_t word = 0; word < all.size(); ++word)
      all[word] |= taken_[program][word] & ~locals_[word];
  }
  for (const std::uint32_t program : group)
    for (std::size_t word = 0; word < all.size(); ++word) taken_[program][word] |= all[word];
}

/// Take what the waiting programs of one group call, then what their callers in the group call,
/// until nothing is new.
void OverwrittenCheck::take_until_settled(std::vector<std::uint32_t> waiting) {
  std::unordered_set<std::uint32_t> waits(waiting.begin(), waiting.end());
  while (!waiting.empty() && !c_.over()) {
    const std::uint32_t program = waiting.back();
    waiting.pop_back();
    waits.erase(program);
    c_.over(c_.flows[program].calls().size());
    if (!take_called(program)) continue;
    for (const CallEdge* edge : c_.callers_of(static_cast<std::int32_t>(program))) {
      const auto caller = static_cast<std::uint32_t>(edge->caller);
      if (c_.groups.of[caller] == c_.groups.of[program] && waits.insert(caller).second)
        waiting.push_back(caller);
    }
  }
}

/// Find what each program takes. Called programs come before their callers, so that only programs
/// that call each other are visited again.
void OverwrittenCheck::find_taken() {
  taken_.assign(c_.flows.size(), Set(numbering_.words()));
  for (const auto& group : c_.groups.groups) {
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t program : group)
      if (c_.is_called(static_cast<std::int32_t>(program))) {
        taken_[program] = scratch_[program];
        waiting.push_back(program);
      }
    if (group.size() > 1) share_commons(group);
    take_until_settled(std::move(waiting));
  }
}

void OverwrittenCheck::tell_overwritten(const ProgramFlow& flow) {
  Set called(numbering_.words());
  for (const CallEdge& edge : flow.calls())
    for (std::size_t word = 0; edge.called != flow.program() && word < called.size(); ++word)
      called[word] |= taken_by(edge, word);
  const Set own = written(flow);
  for (std::size_t word = 0; word < called.size(); ++word)
    if ((called[word] & own[word]) != 0 && !c_.over()) tell_overwritten(flow, word);
}

/// Return the state of the variables after a block and the programs that it calls. Adds to `read`
/// those that the program reads as its own.
OverwrittenCheck::State OverwrittenCheck::behind(Address at, const ProgramFlow& flow, State state,
                                                 std::size_t word, Bits& read) {
  if (const VariableUse* of = at < flow.last() ? uses_.of(at) : nullptr) {
    read |= state.own & numbering_.bits(of->reads, word);
    const Bits set = numbering_.bits(of->writes, word);
    state.own = of->any ? 0 : state.own | set;
    state.lost = of->any ? 0 : state.lost & ~set;
  }
  for (const CallEdge* edge : calls_at_[at - flow.first()]) {
    const Bits lost = state.own & taken_by(*edge, word);
    state.own &= ~lost;
    state.lost |= lost;
  }
  return state;
}

/// Report, for one word of variables, those that the program reads as its own and reads again after
/// a called program has used them.
void OverwrittenCheck::tell_overwritten(const ProgramFlow& flow, std::size_t word) {
  std::vector<State> before(flow.size());
  std::vector<Address> waiting{flow.first()};
  before[0].reached = true;
  Bits read = 0;
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    const State state = behind(at, flow, before[at - flow.first()], word, read);
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
    Bits lost = numbering_.bits(of->reads, word) & before[at - flow.first()].lost & read;
    read &= ~lost;  // reported once
    for (; lost != 0; lost &= lost - 1)
      tell_lost(flow, at, word * kMostBits + static_cast<std::size_t>(std::countr_zero(lost)));
  }
}

void OverwrittenCheck::tell_lost(const ProgramFlow& flow, Address at, std::size_t place) {
  const std::size_t word = place / kMostBits;
  const Bits own = Bits{1} << (place % kMostBits);
  const Numbered& variable = numbering_.of(place);
  for (const CallEdge& edge : flow.calls()) {
    if ((taken_by(edge, word) & own) == 0) continue;
    const bool itself = (scratch_[static_cast<std::size_t>(edge.called)][word] & own) != 0;
    c_.found(variable.local ? Check::SharedLocal : Check::SharedCommon, at,
             uses_.place_of(at, variable.number),
             c_.code.name_of(edge.called) + ", called in line " +
                 std::to_string(c_.code.blocks[edge.from].line) +
                 (itself ? ", has overwritten " : ", and what it calls have overwritten ") +
                 uses_.name_of(variable.number))
        .path = {edge.from};
    return;
  }
}

void OverwrittenCheck::run() {
  number_all();
  if (numbering_.words() == 0) return;
  scratch_.assign(c_.flows.size(), Set(numbering_.words()));
  for (const ProgramFlow& flow : c_.flows)
    if (c_.is_called(flow.program())) find_scratch(flow);
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
