// Finds locals that are read without a value, and arguments that nobody gives or nobody reads.
#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>

#include "cncsub/analysis/variable_use.hpp"

namespace cncsub {

namespace {

class VacantCheck {
 public:
  VacantCheck(Checker& c, const VariableUses& uses);
  void run();

 private:
  struct Vacant {
    Bits always = 0, sometimes = 0;
    bool reached = false;
  };

  Bits given(const CallEdge& edge) const;
  Bits vacant_in(const CallEdge& edge) const;
  Vacant at_entry(const ProgramFlow& flow) const;
  std::vector<Vacant> vacant(const ProgramFlow& flow) const;
  void pass(const ProgramFlow& flow, Address at, Vacant& state) const;
  void take_conditions(const ProgramFlow& flow);
  bool must_be_alone(Address at) const;
  bool omits_on_purpose(const ProgramFlow& flow) const;
  void tell_vacant(const ProgramFlow& flow);
  void tell_vacant(const ProgramFlow& flow, Address at, Bits locals, Check check);
  void tell_unread();
  void tell_unread(const CallEdge& edge, Bits& reported);

  Checker& c_;
  const VariableUses& uses_;
  std::vector<std::vector<const CallEdge*>> calls_at_;  // of the program that is checked
  std::unordered_map<std::int32_t, int> conditions_;    // by variable: how many conditions read it
  bool computed_calls_ = false;
  Bits locals_;
};

VacantCheck::VacantCheck(Checker& c, const VariableUses& uses) : c_(c), uses_(uses) {
  const std::int32_t last = std::min(c.code.locals, kMostBits) - 1;
  locals_ = (last >= 63 ? ~Bits{0} : (Bits{1} << (last + 1)) - 1) & ~Bits{1};
  for (const ProgramFlow& flow : c.flows)
    computed_calls_ = computed_calls_ || flow.calls_computed();
}

namespace {

/// Return the parameters that a program declares. They have a value at each call.
Bits parameters_of(const Code& code, const Program& program) {
  Bits found = 0;
  for (std::uint32_t i = 0; i < program.parameters; ++i) {
    const std::int32_t variable = code.formal_parameters[program.first_parameter + i].variable;
    if (variable < kMostBits) found |= Bits{1} << variable;
  }
  return found;
}

}  // namespace

/// Return the locals that the arguments of a call set.
Bits VacantCheck::given(const CallEdge& edge) const {
  const CallRecord& record = c_.code.calls[edge.record];
  Bits given = 0;
  for (std::uint32_t i = 0; i < record.arguments; ++i) {
    const std::int16_t variable = c_.code.arguments[record.first_argument + i].variable;
    if (variable >= 0 && variable < kMostBits) given |= Bits{1} << variable;
  }
  return given;
}

/// Return the locals that have no value where a call enters. A subprogram shares those of its
/// caller: they are the ones that a main program never writes.
Bits VacantCheck::vacant_in(const CallEdge& edge) const {
  const CallKind kind = c_.code.calls[edge.record].kind;
  if (edge.macro) {
    const bool own = kind == CallKind::Macro || kind == CallKind::GCode || kind == CallKind::MCode;
    return own && c_.code.calls[edge.record].variable == 0 ? locals_ & ~given(edge) : 0;
  }
  const bool plain = kind == CallKind::Subprogram || kind == CallKind::Local;
  const ProgramFlow& caller = c_.flow(edge.caller);
  const LocalUse& of = uses_.of_program(edge.caller);
  const bool known = plain && !of.any && !c_.is_called(edge.caller) && !c_.is_entry(edge.caller) &&
                     caller.ever_ends();
  return known && c_.code.calls[edge.record].arguments == 0 ? locals_ & ~of.writes : 0;
}

VacantCheck::Vacant VacantCheck::at_entry(const ProgramFlow& flow) const {
  const auto callers = c_.callers_of(flow.program());
  Vacant entry{uses_.named(), uses_.named(), true};
  if (c_.is_entry(flow.program())) return entry;
  if (callers.empty()) {
    // The callers of a subprogram that is not called here are unknown.
    if (flow.ever_ends() || !flow.ever_returns()) entry = {locals_, locals_, true};
    return entry;
  }
  if (computed_calls_ || flow.program() == c_.main) return entry;
  Bits always = locals_, sometimes = 0;
  for (const CallEdge* edge : callers) {
    const Bits vacant = (vacant_in(*edge) | uses_.named()) & ~given(*edge);
    always &= vacant;
    sometimes |= vacant;
  }
  return {always, sometimes, true};
}

/// Change the state by the variables that a block and the programs that it calls set.
void VacantCheck::pass(const ProgramFlow& flow, Address at, Vacant& state) const {
  if (at >= flow.last()) return;
  Bits set = 0;
  if (const VariableUse* own = uses_.of(at)) set = own->any ? ~Bits{0} : own->written_locals;
  for (const CallEdge* edge : calls_at_[at - flow.first()]) {
    if (edge->macro) continue;
    const LocalUse& called = uses_.of_program(edge->called);
    set |= (called.any ? ~Bits{0} : called.writes) & ~uses_.named();
  }
  const Op op = c_.code.blocks[at].op;
  if (op == Op::OWord || op == Op::Select || op == Op::Fault ||  // it may have set any
      (calls_at_[at - flow.first()].empty() && calls_subprogram(c_.code, c_.code.blocks[at])))
    set |= ~uses_.named();
  state.always &= ~set;
  // Trust a variable that is set under a condition if it is read where the condition holds again.
  if (must_be_alone(at)) set &= uses_.of_program(flow.program()).again;
  state.sometimes &= ~set;
}

/// Return whether a block sets something under a condition that no other block tests.
bool VacantCheck::must_be_alone(Address at) const {
  const VariableUse* own = uses_.of(at);
  if (c_.code.blocks[at].op != Op::IfThen || own == nullptr || own->any) return false;
  return std::all_of(own->reads.begin(), own->reads.end(), [&](std::int32_t number) {
    const auto found = conditions_.find(number);
    return found == conditions_.end() || found->second < 2;
  });
}

void VacantCheck::take_conditions(const ProgramFlow& flow) {
  conditions_.clear();
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const Op op = c_.code.blocks[at].op;
    const bool asks =
        op == Op::IfThen || op == Op::IfGoto || op == Op::If || op == Op::While || op == Op::Goto;
    const VariableUse* own = asks ? uses_.of(at) : nullptr;
    if (own == nullptr) continue;
    const std::set<std::int32_t> asked(own->reads.begin(), own->reads.end());
    for (const std::int32_t number : asked) ++conditions_[number];
  }
}

/// Return which locals have no value before each block: on every path to it, on some path.
std::vector<VacantCheck::Vacant> VacantCheck::vacant(const ProgramFlow& flow) const {
  std::vector<Vacant> before(flow.size());
  std::vector<Address> waiting;
  const auto reach = [&](Address at, const Vacant& state) {
    Vacant& own = before[at - flow.first()];
    const Vacant old = own;
    own.always = own.reached ? own.always & state.always : state.always;
    own.sometimes |= state.sometimes;
    own.reached = true;
    if (!old.reached || own.always != old.always || own.sometimes != old.sometimes)
      waiting.push_back(at);
  };
  for (const Address entry : flow.entries()) {
    const bool other = entry < flow.last() && c_.code.program_at(entry) != flow.program();
    reach(entry, {other ? uses_.named() : 0, 0, true});
  }
  const Vacant entry = at_entry(flow);
  const Bits vacant = ~parameters_of(c_.code, c_.program(flow.program()));
  reach(flow.first(), {entry.always & vacant, entry.sometimes & vacant, true});
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Vacant state = before[at - flow.first()];
    pass(flow, at, state);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) reach(exit->to, state);
  }
  return before;
}

void VacantCheck::tell_vacant(const ProgramFlow& flow, Address at, Bits locals, Check check) {
  for (std::int32_t local = 1; local < kMostBits; ++local) {
    if ((locals >> local & 1) == 0) continue;
    const std::int32_t number = uses_.number_of(local);
    const std::string name = uses_.name_of(number);
    Finding& found = c_.found(check, at, uses_.place_of(at, number),
                              check == Check::ArgumentMissing ? "no call gives " + name
                              : check == Check::Vacant        ? name + " has no value here"
                                                              : name + " may have no value here");
    if (check != Check::ArgumentMissing) continue;
    found.path = {c_.callers_of(flow.program()).front()->from};
  }
}

/// Return whether calls of a macro leave out arguments on purpose, where these stand alone in a
/// word: the calls give others, and the macro reads all of those. A letter that it never reads may
/// be meant for a missing one.
bool VacantCheck::omits_on_purpose(const ProgramFlow& flow) const {
  const LocalUse& of = uses_.of_program(flow.program());
  Bits all = 0;
  for (const CallEdge* edge : c_.callers_of(flow.program()))
    if (edge->macro) all |= given(*edge);
  return all != 0 && (all & ~of.reads) == 0;
}

void VacantCheck::tell_vacant(const ProgramFlow& flow) {
  Bits reported = uses_.of_program(flow.program()).tested;
  const std::vector<Vacant> before = vacant(flow);
  const auto callers = c_.callers_of(flow.program());
  const bool macro =
      std::any_of(callers.begin(), callers.end(), [](const CallEdge* edge) { return edge->macro; });
  const bool on_purpose = omits_on_purpose(flow);
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const VariableUse* own = uses_.of(at);
    const Vacant& state = before[at - flow.first()];
    if (own == nullptr || !state.reached || own->read_locals == 0) continue;
    const Bits always = own->read_locals & state.always & ~reported;
    const Bits arguments = macro ? always & ~uses_.named() : 0;
    const Bits missing = arguments & ~(on_purpose ? own->word_locals : 0);
    tell_vacant(flow, at, missing, Check::ArgumentMissing);
    tell_vacant(flow, at, always & ~arguments, Check::Vacant);
    reported |= missing | (always & ~arguments);
    const Bits sometimes =
        own->read_locals & ~own->word_locals & state.sometimes & ~reported & ~uses_.named();
    tell_vacant(flow, at, sometimes, Check::MaybeVacant);
    reported |= sometimes;
  }
}

/// Report arguments of one call that its macro, and the subprograms that share its locals, never
/// read. Each is reported at the first call that gives it.
void VacantCheck::tell_unread(const CallEdge& edge, Bits& reported) {
  const LocalUse& of = uses_.of_program(edge.called);
  const CallRecord& record = c_.code.calls[edge.record];
  for (std::uint32_t i = 0; i < record.arguments; ++i) {
    const Argument& argument = c_.code.arguments[record.first_argument + i];
    if (argument.variable <= 0 || argument.variable >= kMostBits) continue;
    const Bits own = Bits{1} << argument.variable;
    if (((of.reads | reported) & own) != 0) continue;
    reported |= own;
    c_.found(Check::ArgumentUnread, edge.from, {argument.operand.at, argument.operand.width},
             c_.code.name_of(edge.called) + " never reads #" + std::to_string(argument.variable));
  }
}

void VacantCheck::tell_unread() {
  std::vector<Bits> reported(c_.flows.size(), 0);
  for (const ProgramFlow& flow : c_.flows)
    for (const CallEdge& edge : flow.calls()) {
      if (c_.over()) return;
      const bool known = edge.macro && edge.start != kNowhere &&
                         !uses_.of_program(edge.called).any &&
                         !c_.flow(edge.called).calls_computed();
      if (known) tell_unread(edge, reported[static_cast<std::size_t>(edge.called)]);
    }
}

void VacantCheck::run() {
  for (const ProgramFlow& flow : c_.flows) {
    if (c_.over(flow.size())) return;
    if (c_.inside(flow) || uses_.of_program(flow.program()).reads == 0) continue;
    calls_at_ = calls_by_block(flow);
    take_conditions(flow);
    tell_vacant(flow);
  }
  tell_unread();
}

}  // namespace

void check_vacant(Checker& c, const VariableUses& uses) { VacantCheck(c, uses).run(); }

}  // namespace cncsub
