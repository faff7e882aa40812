// O words: subprograms, branches and loops.
//
// Nothing is nested here: a statement asks what its label was met with. A part that is not executed
// is skipped, to the next statement of the label.

#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/calls/skip_to_label.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

namespace {

constexpr std::pair<OWordKind, const char*> kKindNames[] = {{OWordKind::Sub, "sub"},
                                                            {OWordKind::Head, ""},
                                                            {OWordKind::EndSub, "endsub"},
                                                            {OWordKind::Return, "return"},
                                                            {OWordKind::Back, "M99"},
                                                            {OWordKind::Call, "call"},
                                                            {OWordKind::Call98, "M98"},
                                                            {OWordKind::FileEnd, "%"},
                                                            {OWordKind::If, "if"},
                                                            {OWordKind::ElseIf, "elseif"},
                                                            {OWordKind::Else, "else"},
                                                            {OWordKind::EndIf, "endif"},
                                                            {OWordKind::While, "while"},
                                                            {OWordKind::EndWhile, "endwhile"},
                                                            {OWordKind::Do, "do"},
                                                            {OWordKind::Repeat, "repeat"},
                                                            {OWordKind::EndRepeat, "endrepeat"},
                                                            {OWordKind::Break, "break"},
                                                            {OWordKind::Continue, "continue"}};

const char* name_of(OWordKind kind) {
  const auto* const found = std::find_if(std::begin(kKindNames), std::end(kKindNames),
                                         [kind](const auto& named) { return named.first == kind; });
  return found == std::end(kKindNames) ? "" : found->second;
}

constexpr std::uint64_t key(std::uint32_t inside, std::uint32_t label) {
  return std::uint64_t{inside} << 32 | label;
}
Fault of_another_kind(const OWord& own, std::string detail) {
  Fault fault{Cause::CallOfAnotherKind, own.at, own.width, std::move(detail)};
  fault.text = own.of_another_kind;
  return fault;
}

/// Subprograms are known everywhere: no subprogram has this label.
constexpr std::uint32_t kEverywhere = 0xffffffff;

Fault labelled_fault(const OWord& own, Cause cause, std::string detail) {
  return {cause, own.at, own.width, std::move(detail)};
}

void put(std::string& text, std::string_view mark, std::string_view what) {
  const std::size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), what);
}

/// Return the fault of a label that was met with another statement, or one that does not belong to
/// this.
Fault misfit(const Run& run, const OWord& own, Cause cause, const Labels::Met& met) {
  const std::string line = std::to_string(run.code->blocks[met.address].line);
  const char* kind = name_of(met.kind);
  Fault fault =
      labelled_fault(own, cause,
                     cause == Cause::LabelGivenTwice ? "line " + line + " already has the label"
                                                     : std::string("the label belongs to ") + kind);
  fault.text = own.of_another_kind;
  fault.name = full_name(run, own.label);
  put(fault.text, "{kind}", kind);
  put(fault.text, "{other}", line);
  return fault;
}

bool own_value(Run& run, const OWord& own, double& value) {
  value = 0;
  if (own.value == OWord::kNone) return true;
  if (own.kind == OWordKind::If || own.kind == OWordKind::ElseIf || own.kind == OWordKind::While)
    return evaluate_condition(run, own.value, value);
  return evaluate(run, own.value, value);
}

/// Find what the label was met with before; alarm where it was not met.
bool met_before(Run& run, const OWord& own, Labels::Met*& met) {
  const auto found = run.state.labels.met.find(key(run.frame().label, own.label));
  if (found == run.state.labels.met.end())
    return alarm(run, labelled_fault(own, Cause::LabelNotFound,
                                     "no statement with the label " + run.code->labels[own.label] +
                                         " was executed before"));
  met = &found->second;
  return true;
}

/// Meet the head of a branch or a loop: its label is new, or was met with this very block.
bool meet(Run& run, const OWord& own, Labels::Met*& met) {
  met = &run.state.labels.met[key(run.frame().label, own.label)];
  if (met->address == kNowhere) *met = {run.state.pc, own.kind, -1};
  const bool end_of_do = own.kind == OWordKind::While && met->kind == OWordKind::Do;
  if (met->address == run.state.pc || end_of_do) return true;
  return alarm(run, misfit(run, own, Cause::LabelGivenTwice, *met));
}

// ---- subprograms ----

Fault head_again(const Run& run, const OWord& own, Address met) {
  const bool same = met == run.state.pc;
  Fault fault = labelled_fault(own, Cause::SubprogramGivenTwice,
                               same ? "the program has reached a sub that was called before"
                                    : "line " + std::to_string(run.code->blocks[met].line) +
                                          " already is the head of this sub");
  fault.name = run.code->labels[own.label];
  if (same && own.refused != OWord::kNone) fault.text = run.code->faults[own.refused].text;
  return fault;
}

/// Execute a head. One that is met while the main program runs begins what is skipped; one that a
/// call leads to is entered.
bool head(Run& run, const OWord& own) {
  const bool sub = own.kind == OWordKind::Sub;
  const OpenFrame& open = run.frame();
  if (run.state.frames.size() > 1 && sub != (open.kind == CallKind::OWord))
    return alarm(run, of_another_kind(own, sub ? "M98 has called a sub: call it by O call"
                                               : "O call has called a program: call it by M98"));
  const bool searched = std::exchange(run.state.labels.searching, false);
  if (run.state.labels.defining)
    return alarm(run,
                 labelled_fault(own, Cause::SubprogramInSubprogram, "a sub inside another sub"));
  if (!searched && (!sub || run.state.frames.size() > 1)) return true;
  auto& met = run.state.labels.met[key(kEverywhere, own.label)];
  if (met.address != kNowhere) return alarm(run, head_again(run, own, met.address));
  met = {run.state.pc, own.kind, -1};
  if (searched) return true;
  run.state.labels.defining = true;
  return skip_over(run, own, run.code->labels[own.label]);
}

bool end_of_subprogram(Run& run, const OWord& own) {
  double value = 0;
  const bool back = own.kind == OWordKind::Back;
  if (!own_value(run, own, value)) return false;
  if (run.state.labels.defining) {
    set_returned(run, value, own.value != OWord::kNone);
    if (own.kind != OWordKind::EndSub) return skip_over(run, own, run.code->labels[own.label]);
    run.state.labels.defining = run.state.labels.back = false;
    return true;
  }
  if (run.state.frames.size() == 1) {
    if (back) return return_now(run, run.code->calls[own.call], kVacant, kVacant);
    set_returned(run, value, own.value != OWord::kNone);
    if (run.state.labels.back && own.kind == OWordKind::Return) return true;
    if (run.state.labels.back) return alarm(run, run.code->faults[own.refused]);
    return alarm(run, labelled_fault(own, Cause::ReturnInMainProgram, "no subprogram is open"));
  }
  if (back != (run.frame().kind == CallKind::Subprogram))
    return alarm(run,
                 of_another_kind(own, back ? "M99 in a sub that O call has called"
                                           : "the end of a sub in a program that M98 has called"));
  if (back && own.refused != OWord::kNone) return alarm(run, run.code->faults[own.refused]);
  set_returned(run, value, own.value != OWord::kNone);
  record_step(run);
  run.state.labels.back = run.state.frames.size() == 2;
  return leave(run, run.frame().return_to);
}

/// Find where a label leads: the head that was met last, the file of its name, or the next head
/// after the call.
bool find_label(Run& run, const OWord& own, std::uint32_t label, const std::string& name,
                Target& target, Address& on_the_way) {
  const auto met = run.state.labels.met.find(key(kEverywhere, label));
  if (label != OWord::kNone && met != run.state.labels.met.end()) {
    target.start = met->second.address;
  } else {
    run.state.labels.searching = true;
    const std::int32_t file = run.code->find(name);
    const bool of_file =
        file != kNoProgram &&
        run.code->programs[static_cast<std::size_t>(file)].inside == kNoProgram &&
        run.code->programs[static_cast<std::size_t>(file)].name_length == Program::kOfFile;
    if (of_file && !may_be_read(run, own, file, name)) return false;
    const Address from =
        of_file ? run.code->programs[static_cast<std::size_t>(file)].first : run.state.pc;
    if (label != OWord::kNone) target.start = run.code->head_from(label, from);
    on_the_way =
        of_file ? run.code->head_from(kOnTheWay, from) : run.code->head_behind(kOnTheWay, from);
    if (target.start == kNowhere && !read_skipped_blocks(run, on_the_way, kNowhere, name))
      return false;
  }
  if (target.start == kNowhere) {
    Fault fault = labelled_fault(own, Cause::ProgramNotFound, "the program has no such label");
    fault.name = name;
    return alarm(run, fault);
  }
  target.program = run.code->program_at(target.start);
  return true;
}

/// Return whether there is a pass after this: a block that calls `times` is executed for each.
bool another_pass(std::int32_t& left, double times) {
  if (left < 0) left = to_whole<std::int32_t>(std::clamp(std::nearbyint(times), 0.0, 1e9));
  if (--left > 0) return true;
  left = -1;
  return false;
}

/// Begin the called level with the numbered locals of its caller.
void hand_on_locals(Run& run) {
  const auto first = [&](int level) {
    return run.state.locals.begin() + static_cast<std::ptrdiff_t>(run.local_at(level, 0));
  };
  std::vector<double>& own = run.block.arguments;
  own.assign(first(run.state.level), first(run.state.level + 1));
  std::fill(own.begin() + run.code->locals_per_level + 1, own.end(), kVacant);
}

bool labelled_call(Run& run, const OWord& own) {
  const CallRecord& record = run.code->calls[own.call];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  if (!uses_words_beside(run, own)) return false;
  double p = 0, l = kVacant;
  std::uint32_t label = own.label;
  if (!read_98(run, record, p, l)) return false;
  const auto number = to_whole<std::int64_t>(std::clamp(is_vacant(p) ? 0 : p, -1e9, 1e9));
  if (label == OWord::kNone) label = run.code->label(number);
  Target target;
  Address on_the_way = kNowhere;  // what a search reads, with the variables of the new level
  bool again = false;
  if (!is_vacant(l)) again = another_pass(run.frame().passes_left, l);
  if (!is_vacant(l) && l == 0) {  // nothing is called, but the level is open [rs274 2.9]
    target.start = run.block.next;
    target.program = run.frame().program;
  } else {
    const bool known = label != OWord::kNone;
    const std::string name = known ? run.code->labels[label] : std::to_string(number);
    if (!find_label(run, own, label, name, target, on_the_way)) return false;
  }
  if (again) run.block.next = run.state.pc;
  if (record.locals == CallRecord::Locals::OwnByName)
    hand_on_locals(run);
  else if (!evaluate_arguments(run, record))
    return false;
  if (!enter(run, own.call, target, -1)) return false;
  run.frame().label = label;
  if (on_the_way == kNowhere) return true;
  return read_skipped_blocks(run, on_the_way, target.start, run.code->labels[label]);
}

// ---- branches ----

bool branch_of_if(Run& run, const OWord& own) {
  double value = 0;
  if (!own_value(run, own, value)) return false;
  const bool skipping = std::exchange(run.state.labels.skipping, false);
  Labels::Met* met = nullptr;
  if (own.kind == OWordKind::If) {
    if (!meet(run, own, met)) return false;
    run.state.labels.entered = value != 0;
    run.block.failed = value == 0;
    return run.state.labels.entered || skip_to_label(run, own);
  }
  if (!met_before(run, own, met)) return false;
  if (met->kind != OWordKind::If)
    return alarm(run, misfit(run, own, Cause::LabelOfAnotherKind, *met));
  if (own.kind == OWordKind::EndIf) {
    run.state.labels.entered = true;
    return true;
  }
  run.block.failed = own.kind == OWordKind::ElseIf && (run.state.labels.entered || value == 0);
  if (run.state.labels.entered) return skip_to_label(run, own);
  if (own.kind == OWordKind::Else) {
    run.state.labels.entered = run.state.labels.entered || skipping;
    return true;
  }
  run.state.labels.entered = value != 0;
  return run.state.labels.entered || skip_to_label(run, own);
}

// ---- loops ----

bool loop_head(Run& run, const OWord& own) {
  double value = 0;
  if (!own_value(run, own, value)) return false;
  run.state.labels.skipping = false;
  Labels::Met* met = nullptr;
  if (own.kind == OWordKind::Do) {
    met = &run.state.labels.met[key(run.frame().label, own.label)];
    if (met->address == kNowhere) *met = {run.state.pc, own.kind, -1};
    return true;
  }
  if (!meet(run, own, met)) return false;
  if (own.kind == OWordKind::Repeat) {
    if (met->repeats == -1)
      met->repeats = to_whole<std::int32_t>(std::clamp(std::nearbyint(value), -1e9, 1e9));
    if (met->repeats > 0) {
      --met->repeats;
      return true;
    }
    met->repeats = -1;
    run.block.failed = true;
    return skip_to_label(run, own);
  }
  run.block.failed = value == 0 || (met->kind == OWordKind::Do && run.state.labels.breaks);
  if (met->kind != OWordKind::Do) return value != 0 || skip_to_label(run, own);
  if (value != 0 && !run.state.labels.breaks)
    run.block.next = met->address;
  else
    run.state.labels.breaks = false;
  return true;
}

bool end_of_loop(Run& run, const OWord& own) {
  Labels::Met* met = nullptr;
  const bool skipping = std::exchange(run.state.labels.skipping, false);
  if (!met_before(run, own, met)) return false;
  const OWordKind wanted = own.kind == OWordKind::EndWhile ? OWordKind::While : OWordKind::Repeat;
  if (met->kind != wanted) return alarm(run, misfit(run, own, Cause::LabelOfAnotherKind, *met));
  if (skipping && !std::exchange(run.state.labels.continues, false)) return true;
  run.block.next = met->address;
  return true;
}

/// Execute break or continue. Where the loop that they stand in is skipped, they are met as well.
bool leave_loop(Run& run, const OWord& own) {
  Labels::Met* met = nullptr;
  if (!met_before(run, own, met)) return false;
  if (met->kind != OWordKind::While && met->kind != OWordKind::Do)
    return alarm(run, misfit(run, own, Cause::LabelOfAnotherKind, *met));
  if (own.kind == OWordKind::Break)
    run.state.labels.breaks = true;
  else if (!run.state.labels.skipping)
    run.state.labels.continues = true;
  return skip_to_label(run, own);
}

}  // namespace

namespace {

bool obey(Run& run, const OWord& own) {
  switch (own.kind) {
    case OWordKind::Sub:
    case OWordKind::Head:
      return head(run, own);
    case OWordKind::EndSub:
    case OWordKind::Return:
    case OWordKind::Back:
      return end_of_subprogram(run, own);
    case OWordKind::Call:
    case OWordKind::Call98:
      return labelled_call(run, own);
    case OWordKind::FileEnd:
      if (own.refused != OWord::kNone) return alarm(run, run.code->faults[own.refused]);
      record_step(run);
      return end_run(run, Stop::End);
    case OWordKind::If:
    case OWordKind::ElseIf:
    case OWordKind::Else:
    case OWordKind::EndIf:
      return branch_of_if(run, own);
    case OWordKind::While:
    case OWordKind::Do:
    case OWordKind::Repeat:
      return loop_head(run, own);
    case OWordKind::EndWhile:
    case OWordKind::EndRepeat:
      return end_of_loop(run, own);
    case OWordKind::Break:
    case OWordKind::Continue:
      return leave_loop(run, own);
  }
  return true;
}

}  // namespace

bool run_labelled(Run& run, const Block& block) {
  const OWord& own = run.code->o_words[block.aux];
  const std::size_t depth = run.state.frames.size();
  const std::int64_t before = run.state.executed;
  const bool passed = run.state.labels.skipping &&
                      (own.kind == OWordKind::Break || own.kind == OWordKind::Continue);
  run.block.failed = false;
  if (!obey(run, own)) return false;
  if (run.state.executed != before || run.state.frames.size() != depth)
    return true;  // a call or a return
  if (block.n >= 0) run.state.last_n = block.n;
  ++run.state.changes;
  if (!passed) record_step(run, run.block.failed);
  run.state.pc = run.block.next;
  return true;
}

}  // namespace cncsub
