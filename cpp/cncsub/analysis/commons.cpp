// Finds commons that a move uses and that have no value on some path to it.
#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "cncsub/analysis/variable_use.hpp"

namespace cncsub {

namespace {

class CommonCheck {
 public:
  CommonCheck(Checker& c, const VariableUses& uses) : c_(c), uses_(uses) {}
  void run();

 private:
  using Numbers = std::vector<std::int32_t>;

  bool is_cleared(std::int32_t number) const;
  bool moves(Address at) const;
  void add_written(const ProgramFlow& flow, std::unordered_set<std::int32_t>& to);
  void find_written();
  bool find_asked(const ProgramFlow& flow);
  std::vector<Bits> vacant(const ProgramFlow& flow, std::size_t count) const;
  void tell(const ProgramFlow& flow, const Numbers& asked, std::size_t first);
  Bits set_by(Address at, const ProgramFlow& flow) const;

  Checker& c_;
  const VariableUses& uses_;
  std::unordered_set<std::int32_t> written_;          // by any program
  std::vector<std::unordered_set<std::int32_t>> by_;  // by group: written by it and its calls
  std::unordered_map<std::int32_t, int> places_;      // of the variables that are checked now
  std::vector<std::vector<const CallEdge*>> calls_at_;
  Numbers asked_;
};

/// Return whether a variable is a common that has no value when the control is switched on.
bool CommonCheck::is_cleared(std::int32_t number) const {
  const VariablePlace place = c_.code.place(number);
  return place.range != nullptr && place.kind == VariableKind::Common;
}

/// Return whether a block names an end point.
bool CommonCheck::moves(Address at) const {
  const Block& block = c_.code.blocks[at];
  return is_words(block.op) && (block.mask & kEndWords) != 0;
}

void CommonCheck::add_written(const ProgramFlow& flow, std::unordered_set<std::int32_t>& to) {
  for (Address at = flow.first(); at < flow.last() && !c_.over(); ++at) {
    const VariableUse* own = uses_.of(at);
    if (own == nullptr) continue;
    for (const std::int32_t number : own->writes)
      if (is_cleared(number)) {
        to.insert(number);
        written_.insert(number);
      }
  }
}

/// Find what each group of programs that call each other writes, with what it calls.
void CommonCheck::find_written() {
  by_.resize(c_.groups.groups.size());
  for (std::size_t group = 0; group < by_.size() && !c_.over(); ++group)
    for (const std::uint32_t program : c_.groups.groups[group]) {
      const ProgramFlow& flow = c_.flows[program];
      add_written(flow, by_[group]);
      std::unordered_set<std::uint32_t> seen{static_cast<std::uint32_t>(group)};
      for (const CallEdge& edge : flow.calls()) {
        const std::uint32_t called = c_.groups.of[static_cast<std::size_t>(edge.called)];
        if (!c_.over() && seen.insert(called).second)
          by_[group].insert(by_[called].begin(), by_[called].end());
      }
    }
}

/// Find the variables to check in a program that nothing calls: some program writes them, a move of
/// this one uses them, and it does not test whether they have a value. Return whether there are
/// any.
bool CommonCheck::find_asked(const ProgramFlow& flow) {
  asked_.clear();
  std::unordered_set<std::int32_t> tested;
  for (Address at = flow.first(); at < flow.last() && !c_.over(); ++at) {
    const VariableUse* own = uses_.of(at);
    if (own == nullptr) continue;
    if (own->any) return false;
    if (own->tests) tested.insert(own->reads.begin(), own->reads.end());
    if (moves(at))
      for (const std::int32_t number : own->reads)
        if (written_.contains(number)) asked_.push_back(number);
  }
  std::sort(asked_.begin(), asked_.end());
  asked_.erase(std::unique(asked_.begin(), asked_.end()), asked_.end());
  std::erase_if(asked_, [&](std::int32_t number) { return tested.contains(number); });
  return !asked_.empty();
}

/// Return the variables that a block and the programs that it calls set.
Bits CommonCheck::set_by(Address at, const ProgramFlow& flow) const {
  Bits set = 0;
  const auto mark = [&](std::int32_t number) {
    if (const auto found = places_.find(number); found != places_.end())
      set |= Bits{1} << found->second;
  };
  if (const VariableUse* own = uses_.of(at))
    for (const std::int32_t number : own->writes) mark(number);
  for (const CallEdge* edge : calls_at_[at - flow.first()]) {
    const auto& called = by_[c_.groups.of[static_cast<std::size_t>(edge->called)]];
    for (const auto& [number, place] : places_)
      if (called.contains(number)) set |= Bits{1} << place;
  }
  return set;
}

/// Return for each block which of the first `count` checked variables have no value on some path to
/// it.
std::vector<Bits> CommonCheck::vacant(const ProgramFlow& flow, std::size_t count) const {
  std::vector<Bits> vacant(flow.size(), 0);
  std::vector<Address> waiting{flow.first()};
  vacant[0] = ~Bits{0} >> (kMostBits - static_cast<int>(count));
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Bits state = vacant[at - flow.first()];
    if (at < flow.last()) state &= ~set_by(at, flow);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) {
      Bits& next = vacant[exit->to - flow.first()];
      if ((next | state) == next) continue;
      next |= state;
      waiting.push_back(exit->to);
    }
  }
  return vacant;
}

void CommonCheck::tell(const ProgramFlow& flow, const Numbers& asked, std::size_t first) {
  const std::size_t count = std::min<std::size_t>(asked.size() - first, kMostBits);
  places_.clear();
  for (std::size_t i = 0; i < count; ++i) places_.emplace(asked[first + i], static_cast<int>(i));
  const std::vector<Bits> lacking = vacant(flow, count);
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const VariableUse* own = moves(at) ? uses_.of(at) : nullptr;
    if (own == nullptr) continue;
    for (const std::int32_t number : own->reads) {
      const auto found = places_.find(number);
      if (found == places_.end() || (lacking[at - flow.first()] >> found->second & 1) == 0)
        continue;
      const std::string name = uses_.name_of(number);
      c_.found(
          Check::CommonVacant, at, uses_.place_of(at, number),
          name +
              " gets a value only on other paths: here it may be vacant, or hold the value of the "
              "program before");
      places_.erase(found);  // reported once
    }
  }
}

void CommonCheck::run() {
  constexpr std::size_t kMostAsked = std::size_t{16} * kMostBits;
  for (const ProgramFlow& flow : c_.flows)
    if (flow.calls_computed() && !flow.has_labels()) return;  // it may set any
  find_written();
  if (written_.empty()) return;
  for (const ProgramFlow& flow : c_.flows) {
    const bool main = !c_.is_called(flow.program()) && !c_.is_entry(flow.program()) &&
                      (flow.ever_ends() || flow.program() == c_.main);
    if (!main || c_.inside(flow) || flow.has_labels() || !find_asked(flow)) continue;
    calls_at_ = calls_by_block(flow);
    for (std::size_t first = 0; first < std::min(asked_.size(), kMostAsked); first += kMostBits)
      tell(flow, asked_, first);
  }
}

}  // namespace

void check_commons(Checker& c, const VariableUses& uses) { CommonCheck(c, uses).run(); }

}  // namespace cncsub
