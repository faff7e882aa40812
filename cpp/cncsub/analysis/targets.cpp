// Finds calls, jumps and returns whose targets are missing, ambiguous or inside a loop.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kMostReturns = 1 << 20;  // looked up in the callers of a program

/// Return the lines of the blocks that have a number: "lines 3, 9"; empty where only one has it.
std::string lines_of(const Code& code, const Program& program, std::int64_t n) {
  std::string lines;
  int count = 0;
  constexpr int kTold = 4;
  for (Address at = code.first_of(program, n); at != kNowhere; at = code.next_of(program, n, at)) {
    if (++count > kTold) return lines + " ...";
    lines += (count == 1 ? "lines " : ", ") + std::to_string(code.blocks[at].line);
  }
  return count > 1 ? lines : "";
}

/// The loops of a program; each block knows the innermost one around it.
class Loops {
 public:
  Loops(const Code& code, const ProgramFlow& flow) : first_(flow.first()) {
    for (Address at = flow.first(); at < flow.last(); ++at) {
      while (!open_.empty() && at > loops_[open_.back()].end) open_.pop_back();
      const Op op = code.blocks[at].op;
      const bool begins = op == Op::While || op == Op::Do || op == Op::For;
      if (begins && of_.empty()) of_.assign(at - first_, -1);
      if (begins || !of_.empty()) of_.push_back(innermost());
      if (begins) open(at, code.statements[code.blocks[at].aux].end);
    }
  }
  /// Return the end of a loop that contains `to` and not `from`, kNowhere where there is none. The
  /// head of a loop is outside of it.
  Address entered(Address from, Address to) const {
    if (of_.size() <= to - first_) return kNowhere;
    for (int loop = of_[to - first_]; loop >= 0; loop = at(loop).parent)
      if (from <= at(loop).start || from > at(loop).end) return at(loop).end;
    return kNowhere;
  }

 private:
  struct Loop {
    Address start, end;
    int parent;
  };
  int innermost() const { return open_.empty() ? -1 : static_cast<int>(open_.back()); }
  void open(Address start, Address end) {
    if (end == kNowhere || end <= start) return;
    loops_.push_back({start, end, innermost()});
    open_.push_back(loops_.size() - 1);
  }
  const Loop& at(int loop) const { return loops_[static_cast<std::size_t>(loop)]; }

  Address first_;
  std::vector<std::size_t> open_;
  std::vector<int> of_;
  std::vector<Loop> loops_;
};

/// The loops of all programs, each found once.
class AllLoops {
 public:
  explicit AllLoops(const Checker& c) : c_(c), all_(c.flows.size()) {}
  const Loops& of(std::int32_t program) {
    auto& known = all_[static_cast<std::size_t>(program)];
    if (!known) known.emplace(c_.code, c_.flow(program));
    return *known;
  }

 private:
  const Checker& c_;
  std::vector<std::optional<Loops>> all_;
};

class TargetCheck {
 public:
  TargetCheck(Checker& c, const ProgramFlow& flow, AllLoops& all)
      : c_(c),
        flow_(flow),
        program_(c.program(flow.program())),
        loops_(all.of(flow.program())),
        all_(all) {}

  void block(Address at, const Block& block);
  void returns();

 private:
  void jump(Address at, std::int64_t n, Address to, TextPlace place, Cause otherwise);
  void jump(Address at, const Operand& p);
  Finding& into_loop(Address at, TextPlace place, Address end);
  void ambiguous(Address at, const Program& program, std::int64_t n, TextPlace place);
  void go_to(Address at, const Statement& go);
  Finding& no_return_block(const ProgramFlow::ReturnTo& to, const Program& where);
  void restart(const ProgramFlow::ReturnTo& to);
  Address target_in(const Program& caller, const ProgramFlow::ReturnTo& to, Address call) const;
  void one_return(const ProgramFlow::ReturnTo& to);

  Checker& c_;
  const ProgramFlow& flow_;
  const Program& program_;
  const Loops& loops_;
  AllLoops& all_;
  std::set<std::pair<std::int32_t, std::int64_t>> reported_;
  std::size_t looked_up_ = 0;
};

void TargetCheck::ambiguous(Address at, const Program& program, std::int64_t n, TextPlace place) {
  const auto index = static_cast<std::int32_t>(&program - c_.code.programs.data());
  if (!reported_.insert({index, n}).second) return;
  const std::string lines = lines_of(c_.code, program, n);
  if (!lines.empty())
    c_.found(Check::Ambiguous, at, place, "N" + std::to_string(n) + " is in " + lines);
}

void TargetCheck::jump(Address at, std::int64_t n, Address to, TextPlace place, Cause otherwise) {
  if (to == kNowhere) {
    c_.unsure.push_back({flow_.program(), at});
    c_.refused(Check::TargetMissing, at,
               {otherwise, place.at, place.width, c_.code.no_block(n, program_)});
    return;
  }
  if (n >= 0) ambiguous(at, program_, n, place);
  const Address end = loops_.entered(at, to);
  if (end != kNowhere) into_loop(at, place, end);
}

/// Report a jump or a return into a loop that ends at `end`.
Finding& TargetCheck::into_loop(Address at, TextPlace place, Address end) {
  Finding& into = c_.found(Check::IntoLoop, at, place,
                           "the loop ends in line " + std::to_string(c_.code.blocks[end].line));
  const Statement& statement = c_.code.statements[c_.code.blocks[end].aux];
  into.alarm =
      Fault{Cause::MissingDo, statement.at, statement.width, "a jump leads into this loop"};
  into.alarm_block = end;
  return into;
}

void TargetCheck::jump(Address at, const Operand& p) {
  if (p.kind != Operand::Kind::Constant) return;
  const auto n = to_whole<std::int64_t>(p.value);
  jump(at, n, c_.code.first_of(program_, n), {p.at, p.width}, Cause::JumpTargetNotFound);
}

void TargetCheck::go_to(Address at, const Statement& go) {
  const TextPlace place{go.variable_at, go.variable_width};
  if (go.number >= 0 || go.to != kNowhere)
    jump(at, go.number > 0 ? go.number : -1, go.to, place, Cause::JumpTargetNotFound);
  if (go.end != kNowhere && go.to != kNowhere)
    c_.found(Check::Ambiguous, at, place,
             "it leads to line " + std::to_string(c_.code.blocks[go.to].line) + ", and line " +
                 std::to_string(c_.code.blocks[go.end].line) + " has the same label");
}

void TargetCheck::block(Address at, const Block& block) {
  constexpr int kJumpAlways = 80, kLastJump = 86;
  if (block.op == Op::Goto || block.op == Op::IfGoto) {
    go_to(at, c_.code.statements[block.aux]);
  } else if (block.op == Op::Jump) {
    jump(at, c_.code.jumps[block.aux].p);
  } else if (block.op == Op::HCode) {
    const HCode& h = c_.code.h_codes[block.aux];
    if (h.number >= kJumpAlways && h.number <= kLastJump) jump(at, h.p);
  } else if (block.op == Op::Return) {
    const CallRecord& back = c_.code.calls[block.aux];
    if (back.p.kind != Operand::Kind::Constant ||
        c_.code.control->calls.return_with_p.value != ReturnWithP::OwnProgram)
      return;
    const auto n = to_whole<std::int64_t>(back.p.value);
    const Address to = c_.code.first_of(program_, n);
    if (to == kNowhere)
      c_.refused(
          Check::ReturnMissing, at,
          {Cause::ReturnTargetNotFound, back.p.at, back.p.width, c_.code.no_block(n, program_)});
    else
      ambiguous(at, program_, n, {back.p.at, back.p.width});
  }
}

Finding& TargetCheck::no_return_block(const ProgramFlow::ReturnTo& to, const Program& where) {
  return c_.refused(Check::ReturnMissing, to.from,
                    {Cause::ReturnTargetNotFound, to.place.at, to.place.width,
                     to.name.empty() ? c_.code.no_block(to.n, where)
                                     : c_.code.name_of(where) + " has no such block"});
}

/// Check M99 P of a main program that starts over: it leads into itself.
void TargetCheck::restart(const ProgramFlow::ReturnTo& to) {
  const bool over = c_.code.control->calls.main_return.value == MainReturn::Restarts;
  if (!over || flow_.program() != c_.main) return;
  if (c_.code.first_of(program_, to.n) == kNowhere)
    no_return_block(to, program_);
  else
    ambiguous(to.from, program_, to.n, to.place);
}

/// Return the block of a caller to which a return leads; kNowhere: it has none.
Address TargetCheck::target_in(const Program& caller, const ProgramFlow::ReturnTo& to,
                               Address call) const {
  return to.name.empty() ? c_.code.return_target(caller, to.n, call)
                         : c_.code.named_return_target(caller, to.name, call);
}

/// Check M99 P in each program that calls.
void TargetCheck::one_return(const ProgramFlow::ReturnTo& to) {
  const auto callers = c_.callers_of(flow_.program());
  if (callers.empty()) return restart(to);
  std::int32_t before = kNoProgram;  // calls of one caller are adjacent
  const CallEdge* lacks = nullptr;   // the first call whose program lacks the block
  const CallEdge* enters = nullptr;  // the first call that returns into a loop
  std::size_t lacking = 0;
  for (const CallEdge* edge : callers) {
    if (++looked_up_ > kMostReturns || c_.over()) break;
    if (edge->caller == before) continue;
    before = edge->caller;
    const Program& caller = c_.program(edge->caller);
    const Address found = target_in(caller, to, edge->from);
    if (found == kNowhere) {
      if (lacks == nullptr) lacks = edge;
      ++lacking;
      continue;
    }
    if (to.name.empty()) ambiguous(to.from, caller, to.n, to.place);
    const Address end = all_.of(edge->caller).entered(edge->from, found);
    if (end == kNowhere || enters != nullptr) continue;
    enters = edge;
    into_loop(to.from, to.place, end).path = {edge->from};
  }
  if (lacks == nullptr) return;
  Finding& reported = no_return_block(to, c_.program(lacks->caller));
  reported.path = {lacks->from};
  if (lacking < 2 || !reported.alarm) return;
  reported.detail += ", nor in " + std::to_string(lacking - 1) + " more callers";
  reported.alarm->detail = reported.detail;
}

void TargetCheck::returns() {
  for (const ProgramFlow::ReturnTo& to : flow_.return_numbers())
    if (to.n >= 0 || (!to.name.empty() && !to.over_levels)) one_return(to);
  for (const CallEdge& edge : flow_.calls()) {
    const CallRecord& record = c_.code.calls[edge.record];
    if (record.target.start_n >= 0)
      ambiguous(edge.from, c_.program(edge.called), record.target.start_n,
                {record.start().at, record.start().width});
  }
}

/// Return the head of a program, or its first block where its file names it.
TextPlace head_of(const Code& code, const Program& program) {
  const Block& block = code.blocks[program.first];
  if (program.name_length == Program::kOfFile) return {block.text, block.length};
  const std::string_view text = code.files[program.file].text.view();
  std::uint32_t at = program.name_at;
  if (at > 0 && (is_letter(text[at - 1]) || text[at - 1] == ':')) --at;  // the O of O2
  return {at, program.name_at + program.name_length - at};
}

}  // namespace

void check_targets(Checker& c) {
  AllLoops loops(c);
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    TargetCheck targets(c, flow, loops);
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
      each_variant(c.code, c.code.blocks[at],
                   [&](const Block& block) { targets.block(at, block); });
    targets.returns();
    const Program& program = c.program(flow.program());
    if (program.duplicate_of == kNoProgram || program.first >= program.last) continue;
    const Program& first = c.program(program.duplicate_of);
    const TextPlace head = head_of(c.code, program);
    const std::string files = std::to_string(program.file) + " " + std::to_string(first.file);
    if (c.known(Check::Duplicate, files, program.first, head))
      continue;  // another file has the same contents
    c.found(Check::Duplicate, program.first, head,
            c.code.name_of(program) + " is also in " + c.code.files[first.file].name + ", line " +
                std::to_string(first.line) + ", and that one runs");
  }
}

}  // namespace cncsub
