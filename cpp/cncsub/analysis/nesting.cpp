// Finds calls that nest too deep on some path, and circles of calls.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/analysis/paths.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kMostNamed = 12;  // names shown of a circle

/// The number of open calls: of subprograms, of macros, of both.
using Depth = std::array<int, 3>;

/// Return whether the control refuses that a program calls itself, wherever the call begins.
bool is_refused_again(const Checker& c, const CallEdge& edge) {
  const SelfCall rule = c.code.control->calls.self_call.value;
  const CallRecord& record = c.code.calls[edge.record];
  return edge.called == edge.caller && record.kind != CallKind::Local &&
         (rule == SelfCall::Refused || (rule == SelfCall::WithStart && record.target.start_n < 0));
}

/// Return whether a code calls, and not a word of the block.
bool is_by_code(const Checker& c, const CallEdge& edge) {
  const Block& block = c.code.blocks[edge.from];
  return block.op == Op::Select && c.code.selects[block.aux].address != 0;
}

/// Report programs that call themselves where the control refuses it.
void check_self_calls(Checker& c) {
  for (const ProgramFlow& flow : c.flows)
    for (const CallEdge& edge : flow.calls()) {
      if (c.over()) return;
      if (is_by_code(c, edge) || c.inside(flow) || !is_refused_again(c, edge)) continue;
      const CallRecord& record = c.code.calls[edge.record];
      std::string names = c.code.name_of(edge.called) + " > ";
      names += c.code.name_of(edge.called);
      c.refused(Check::CallsOpen, edge.from,
                {Cause::ProgramCallsItself, record.at, record.width, std::move(names)});
    }
}

/// A program from one block on, as a call enters it.
struct Entered {
  std::int32_t program;
  Address start;
};

/// The programs that calls enter and the calls that each of them makes. Where a program is entered
/// at several blocks, only the calls that a path from its start reaches count.
class CallTree {
 public:
  struct Call {
    const CallEdge* edge;
    std::size_t to;
  };

  explicit CallTree(const Checker& c);
  std::size_t size() const { return entered_.size(); }
  const Entered& entered(std::size_t place) const { return entered_[place]; }
  const std::vector<Call>& calls(std::size_t place) const { return calls_[place]; }
  /// Return the groups of entered programs that call each other.
  Groups groups() const;

 private:
  std::size_t enter(std::int32_t program, Address start);
  void take_calls(std::size_t place);

  const Checker& c_;
  std::size_t looked_at_ = 0;  // blocks, for all starts inside programs
  std::map<std::pair<std::int32_t, Address>, std::size_t> inside_;  // programs entered inside
  std::vector<Entered> entered_;
  std::vector<std::vector<Call>> calls_;
};

CallTree::CallTree(const Checker& c) : c_(c) {
  entered_.reserve(c.flows.size());
  for (const ProgramFlow& flow : c.flows) entered_.push_back({flow.program(), flow.first()});
  for (std::size_t place = 0; place < entered_.size(); ++place) take_calls(place);
}

std::size_t CallTree::enter(std::int32_t program, Address start) {
  if (start == kNowhere || start == c_.flow(program).first())
    return static_cast<std::size_t>(program);
  const auto [found, added] = inside_.try_emplace({program, start}, entered_.size());
  if (added) entered_.push_back({program, start});
  return found->second;
}

void CallTree::take_calls(std::size_t place) {
  constexpr std::size_t kMostBlocks = 4'000'000;  // beyond that, starts inside call nothing here
  const Entered from = entered_[place];
  const ProgramFlow& flow = c_.flow(from.program);
  calls_.emplace_back();
  if (flow.calls().empty()) return;
  std::vector<bool> reached;
  if (!flow.entries().empty()) {
    if (looked_at_ > kMostBlocks && from.start != flow.first()) return;
    looked_at_ += flow.size();
    reached = flow.reached_from(from.start);
  }
  c_.over(flow.size());
  for (const CallEdge& edge : flow.calls())
    if (reached.empty() || reached[edge.from - flow.first()])
      calls_[place].push_back({&edge, enter(edge.called, edge.start)});
}

Groups CallTree::groups() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::size_t place = 0; place < calls_.size(); ++place)
    for (const Call& call : calls_[place])
      all.emplace_back(static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(call.to));
  return Groups(Arrows(size(), all));
}

/// All entered programs, each before those that it calls, except for the calls that close a circle.
class CallOrder {
 public:
  CallOrder(Checker& c, const CallTree& tree)
      : c_(c),
        tree_(tree),
        groups_(tree.groups()),
        state_(tree.size(), Walked::New),
        times_open_(c.flows.size(), 0),
        depth_of_(tree.size(), 0),
        reported_(c.code.blocks.size() + 1, false) {
    for (std::size_t i = 0; i < state_.size(); ++i)
      if (state_[i] == Walked::New) walk(i);
    std::reverse(order_.begin(), order_.end());
    std::sort(closing_.begin(), closing_.end());
  }
  const std::vector<std::size_t>& order() const { return order_; }
  /// Return whether a call leads back to an open program.
  bool closes(std::size_t from, const CallEdge& edge) const {
    return std::binary_search(closing_.begin(), closing_.end(), std::pair(from, &edge));
  }

 private:
  enum class Walked : std::uint8_t { New, Open, Done };
  static constexpr std::ptrdiff_t kUnknown = -2;
  struct Open {
    std::size_t place;
    std::size_t call = 0;
    std::vector<bool> passed{};  // the blocks on every path to an end; empty: not known yet
    std::ptrdiff_t last_avoided = kUnknown;  // see the function of this name
  };

  bool is_told(Address at);
  bool is_avoided(Open& open);
  std::ptrdiff_t last_avoided();
  std::string group_of(std::size_t place) const { return std::to_string(groups_.of[place]); }
  void circle_from(std::vector<Open>::const_iterator first, std::string& names,
                   std::vector<Address>& path) const;
  void walk(std::size_t from);
  void circle(const CallTree::Call& call);
  std::string name(std::size_t place) const;
  bool is_of_open_caller(const CallEdge& edge) const;
  void refuse(const CallEdge& edge);

  Checker& c_;
  const CallTree& tree_;
  Groups groups_;
  std::vector<Walked> state_;
  std::vector<std::uint32_t> times_open_;  // by program
  std::vector<Open> open_;
  std::vector<std::size_t> depth_of_;  // by entered program: its place among the open ones
  std::vector<std::size_t> order_;
  std::vector<std::pair<std::size_t, const CallEdge*>> closing_;
  std::vector<bool> reported_;  // by block
};

/// Return whether some path through an entered program reaches its end without its open call.
bool CallOrder::is_avoided(Open& open) {
  const Address call = tree_.calls(open.place)[open.call - 1].edge->from;
  if (c_.code.blocks[call].op == Op::IfThen || c_.code.blocks[call].can_be_skipped()) return true;
  const ProgramFlow& flow = c_.flow(tree_.entered(open.place).program);
  if (open.passed.empty()) open.passed = passed_by_all(c_, flow, tree_.entered(open.place).start);
  return !open.passed[call - flow.first()];
}

/// Return the innermost open program whose open call a path avoids, or -1. What is known of the
/// callers holds until they make their next call.
std::ptrdiff_t CallOrder::last_avoided() {
  std::size_t next = open_.size();
  while (next > 0 && open_[next - 1].last_avoided == kUnknown) --next;
  for (; next < open_.size(); ++next) {
    Open& open = open_[next];
    open.last_avoided = next == 0 ? -1 : open_[next - 1].last_avoided;
    if (is_avoided(open)) open.last_avoided = static_cast<std::ptrdiff_t>(next);
  }
  return open_.back().last_avoided;
}

/// Return whether a block was reported before, and mark it.
bool CallOrder::is_told(Address at) {
  if (reported_[at]) return true;
  reported_[at] = true;
  return false;
}

/// Add the names of the open programs from `first` on, without those in the middle of a long
/// circle, and the calls between them.
void CallOrder::circle_from(std::vector<Open>::const_iterator first, std::string& names,
                            std::vector<Address>& path) const {
  const auto count = static_cast<std::size_t>(open_.end() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const Open& at = *(first + static_cast<std::ptrdiff_t>(i));
    const bool reported = count <= kMostNamed || i < kMostNamed / 2 || i + kMostNamed / 2 >= count;
    if (reported) names += name(at.place) + " > ";
    if (!reported && i == kMostNamed / 2)
      names += "... " + std::to_string(count - kMostNamed) + " more ... > ";
    if (reported && i + 1 < count) path.push_back(tree_.calls(at.place)[at.call - 1].edge->from);
  }
}

void CallOrder::circle(const CallTree::Call& call) {
  const CallEdge& edge = *call.edge;
  closing_.emplace_back(open_.back().place, &edge);
  // The call of the own program lost a word that it drops, such as where it begins.
  const bool dropped =
      edge.called == edge.caller && (c_.code.blocks[edge.from].flags & Block::kDrops) != 0;
  // A code does not call in the program that it calls.
  if (is_by_code(c_, edge) || dropped || is_refused_again(c_, edge) || is_told(edge.from)) return;
  const auto depth = static_cast<std::ptrdiff_t>(depth_of_[call.to]);
  if (last_avoided() >= depth) return;  // a condition ends the circle
  const CallRecord& record = c_.code.calls[edge.record];
  if (c_.known(Check::Recursion, group_of(call.to), edge.from, {record.at, record.width})) return;
  std::string names;
  std::vector<Address> path;
  circle_from(open_.cbegin() + depth, names, path);
  names += name(call.to);
  c_.found(Check::Recursion, edge.from, {record.at, record.width}, names).path = std::move(path);
}

/// Return whether the control refuses a call because its program is already open.
bool CallOrder::is_of_open_caller(const CallEdge& edge) const {
  const CallerCall rule = c_.code.control->calls.caller_call.value;
  const bool started = c_.code.calls[edge.record].target.start_n >= 0;
  if (edge.called == edge.caller || rule == CallerCall::Allowed ||
      (rule == CallerCall::WithStart && started) ||
      (rule == CallerCall::MainRefused && edge.called != c_.main))
    return false;
  return times_open_[static_cast<std::size_t>(edge.called)] > 0;
}

void CallOrder::refuse(const CallEdge& edge) {
  if (is_told(edge.from)) return;
  const CallRecord& record = c_.code.calls[edge.record];
  const std::string group = group_of(static_cast<std::size_t>(edge.called));
  if (c_.known(Check::CallsOpen, group, edge.from, {record.at, record.width})) return;
  auto first = open_.cbegin();
  while (tree_.entered(first->place).program != edge.called) ++first;
  std::string names;
  std::vector<Address> path;
  circle_from(first, names, path);
  c_.refused(
        Check::CallsOpen, edge.from,
        {Cause::ProgramCallsCaller, record.at, record.width, names + c_.code.name_of(edge.called)})
      .path = std::move(path);
}

/// Return "O2", or "O2 N100" where the program is entered inside.
std::string CallOrder::name(std::size_t place) const {
  const Entered& of = tree_.entered(place);
  std::string program = c_.code.name_of(of.program);
  if (of.start == c_.flow(of.program).first() || of.start >= c_.code.blocks.size()) return program;
  const std::int32_t n = c_.code.blocks[of.start].n;
  return n < 0 ? program : program + " N" + std::to_string(n);
}

void CallOrder::walk(std::size_t from) {
  const auto enter = [this](std::size_t place) {
    depth_of_[place] = open_.size();
    open_.push_back({place});
    state_[place] = Walked::Open;
    ++times_open_[static_cast<std::size_t>(tree_.entered(place).program)];
  };
  enter(from);
  while (!open_.empty() && !c_.over()) {
    Open& top = open_.back();
    if (top.call == tree_.calls(top.place).size()) {
      state_[top.place] = Walked::Done;
      order_.push_back(top.place);
      --times_open_[static_cast<std::size_t>(tree_.entered(top.place).program)];
      open_.pop_back();
      continue;
    }
    top.last_avoided = kUnknown;
    const CallTree::Call& call = tree_.calls(top.place)[top.call++];
    if (is_of_open_caller(*call.edge)) refuse(*call.edge);
    Walked& state = state_[call.to];
    if (state == Walked::Open) circle(call);
    if (state == Walked::New) enter(call.to);
  }
}

class NestingCheck {
 public:
  NestingCheck(Checker& c, const CallTree& tree)
      : c_(c),
        tree_(tree),
        limits_{limits(false), limits(true)},
        deepest_(tree.size()),
        from_(tree.size()),
        reported_(c.code.blocks.size() + 1, false) {}

  void call(std::size_t from, const CallTree::Call& call);

 private:
  struct Limit {
    int measure;
    int most;
    Cause cause;
    const char* what;
  };
  std::vector<Limit> limits(bool macro) const;
  std::vector<Address> path(std::size_t to, std::size_t measure) const;

  /// The call that makes an entered program deepest.
  struct By {
    std::size_t caller = 0;
    const CallEdge* edge = nullptr;
  };

  Checker& c_;
  const CallTree& tree_;
  std::array<std::vector<Limit>, 2> limits_;  // for calls of subprograms, of macros
  std::vector<Depth> deepest_;
  std::vector<std::array<By, 3>> from_;
  std::vector<bool> reported_;  // by block
};

std::vector<NestingCheck::Limit> NestingCheck::limits(bool macro) const {
  const CallRules& rules = c_.code.control->calls;
  std::vector<Limit> all;
  if (macro)
    all.push_back(
        {1, rules.max_macro_nesting.value, Cause::MacroNestingTooDeep, " levels of macro calls"});
  const bool both = rules.nesting_counts_macros.value;
  if (both || !macro)
    all.push_back(
        {both ? 2 : 0, rules.max_nesting.value, Cause::NestingTooDeep, " levels of calls"});
  if (rules.max_total_nesting.value > 0)
    all.push_back({2, rules.max_total_nesting.value, Cause::NestingTooDeep,
                   " levels of calls of both kinds"});
  return all;
}

std::vector<Address> NestingCheck::path(std::size_t to, std::size_t measure) const {
  std::vector<Address> blocks;
  for (By at = from_[to][measure]; at.edge != nullptr && blocks.size() < tree_.size();
       at = from_[at.caller][measure])
    blocks.push_back(at.edge->from);
  std::reverse(blocks.begin(), blocks.end());
  return blocks;
}

void NestingCheck::call(std::size_t from, const CallTree::Call& call) {
  Depth deeper = deepest_[from];
  const CallEdge& edge = *call.edge;
  const CallRecord& record = c_.code.calls[edge.record];
  ++deeper[record.macro ? 1 : 0];
  ++deeper[2];
  for (const Limit& limit : limits_[record.macro ? 1 : 0]) {
    const auto measure = static_cast<std::size_t>(limit.measure);
    if (deeper[measure] != limit.most + 1 || reported_[edge.from]) continue;
    reported_[edge.from] = true;
    c_.refused(Check::TooDeep, edge.from,
               {limit.cause, record.at, record.width,
                "the control allows " + std::to_string(limit.most) + limit.what})
        .path = path(from, measure);
    break;
  }
  for (std::size_t i = 0; i < deeper.size(); ++i)
    if (deeper[i] > deepest_[call.to][i]) {
      deepest_[call.to][i] = deeper[i];
      from_[call.to][i] = {from, &edge};
    }
}

}  // namespace

void check_nesting(Checker& c) {
  check_self_calls(c);
  const CallTree tree(c);
  const CallOrder order(c, tree);
  NestingCheck nesting(c, tree);
  for (const std::size_t from : order.order())
    for (const CallTree::Call& call : tree.calls(from)) {
      if (c.over()) return;
      if (!order.closes(from, *call.edge)) nesting.call(from, call);
    }
}

}  // namespace cncsub
