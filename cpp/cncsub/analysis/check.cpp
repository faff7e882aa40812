#include "cncsub/analysis/check.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

const std::vector<CheckInfo>& all_checks() {
  static const std::vector<CheckInfo> all = {
#define Error "error"
#define Warning "warning"
#define Note "note"
#define CHECK(name, number, slug, severity, meaning, hint, example, control) \
  {number, slug, severity, meaning, hint, example, control},
#include "cncsub/analysis/checks.def"
#undef CHECK
#undef Error
#undef Warning
#undef Note
  };
  return all;
}

namespace {

/// Return the calls between programs, as far as they are known.
Arrows calls_of(const std::vector<ProgramFlow>& flows) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const ProgramFlow& flow : flows)
    for (const CallEdge& edge : flow.calls())
      all.emplace_back(static_cast<std::uint32_t>(edge.caller),
                       static_cast<std::uint32_t>(edge.called));
  return {flows.size(), all};
}

/// Return whether the cause of a finding lies in the control or in the whole memory, not in one
/// program.
bool is_of_memory(Check check) {
  switch (check) {
    case Check::Refused:
    case Check::CodeMissing:
    case Check::VariableMissing:
    case Check::NotComputed:
    case Check::ProgramMissing:
    case Check::Dropped:
    case Check::PlainCode:
      return true;
    default:
      return false;
  }
}

}  // namespace

Callers::Callers(const std::vector<ProgramFlow>& flows) : first_(flows.size() + 1, 0) {
  for (const ProgramFlow& flow : flows)
    for (const CallEdge& edge : flow.calls()) ++first_[static_cast<std::size_t>(edge.called) + 1];
  for (std::size_t i = 0; i < flows.size(); ++i) first_[i + 1] += first_[i];
  edges_.resize(first_.back());
  std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
  for (const ProgramFlow& flow : flows)
    for (const CallEdge& edge : flow.calls())
      edges_[place[static_cast<std::size_t>(edge.called)]++] = &edge;
}

Checker::Checker(const Code& code, const Starts& starts, const std::string& machine,
                 InterruptCheck& interrupt)
    : code(code),
      main(starts.main),
      machine(machine_of(*code.control, machine)),
      g_codes(*code.control, this->machine),
      flows(flow_of(code, interrupt)),
      groups(calls_of(flows)),
      named(code.programs.size()),
      interrupt_(interrupt),
      callers_(flows),
      called_by_another_(code.programs.size()),
      entered_(code.programs.size()) {
  for (const std::int32_t entry : starts.entries)
    entered_.at(static_cast<std::size_t>(entry)) = true;
  for (const ProgramFlow& flow : flows)
    for (const CallEdge& edge : flow.calls())
      if (edge.caller != edge.called)
        called_by_another_[static_cast<std::size_t>(edge.called)] = true;
  for (const SourceFile& file : code.files) ignored_.emplace_back(file.text.view());
}

bool Checker::ignored(Check check, Address block, TextPlace place) {
  const Program& of = program(code.program_at(block));
  if (code.files[of.file].system) return true;
  const std::size_t at = std::max(place.at, code.blocks[block].text);
  return ignored_[of.file].holds(check, at);
}

void Checker::keep_edits() {
  if (spare_of_ != 0) {
    auto& edits = findings_[spare_of_ - 1].edits;
    edits.insert(edits.end(), spare_.edits.begin(), spare_.edits.end());
  }
  spare_ = {};
  spare_of_ = 0;
}

Finding& Checker::add(Check check, const std::string& cause, Address block, TextPlace place) {
  keep_edits();
  if (ignored(check, block, place)) return spare_;
  const auto [known, added] = causes_.try_emplace(cause, findings_.size());
  if (!added) {
    findings_[known->second].again.push_back({block, place});
    spare_of_ = known->second + 1;
    return spare_;
  }
  findings_.emplace_back();
  Finding& finding = findings_.back();
  finding.check = check;
  finding.block = block;
  finding.place = place;
  return finding;
}

/// Return where a finding counts as found again: in its program, or in the memory.
std::string Checker::scope_of(Check check, Address block) const {
  std::string scope = std::to_string(static_cast<int>(check)) + " ";
  if (!is_of_memory(check)) scope += std::to_string(code.program_at(block));
  return scope + " ";
}

bool Checker::known(Check check, const std::string& cause, Address block, TextPlace place) {
  std::string whole = std::to_string(static_cast<int>(check)) + ":" + cause;
  if (causes_.contains(whole)) {
    add(check, whole, block, place);
    return true;
  }
  next_cause_ = std::move(whole);
  return false;
}

Finding& Checker::found(Check check, Address block, TextPlace place, std::string detail) {
  std::string cause = std::move(next_cause_);
  next_cause_.clear();
  if (cause.empty()) {
    cause = scope_of(check, block);
    // The first loop that is not closed, or crosses, causes the findings that follow it.
    if (check != Check::LoopUnclosed) cause += detail;
  }
  Finding& finding = add(check, cause, block, place);
  finding.detail = std::move(detail);
  return finding;
}

Finding& Checker::refused(Check check, Address block, Fault fault) {
  if (next_cause_.empty()) {
    next_cause_ = scope_of(check, block);
    if (check != Check::LoopUnclosed)
      next_cause_ += std::to_string(static_cast<int>(fault.cause)) + " " + fault.detail;
    if (fault.detail.starts_with("{}")) {  // add the word to the cause
      const std::string_view text = code.files[program(code.program_at(block)).file].text.view();
      next_cause_ += text.substr(std::min<std::size_t>(fault.at, text.size()), fault.width);
    }
  }
  Finding& finding = found(check, block, {fault.at, fault.width}, fault.detail);
  finding.alarm_block = block;
  finding.alarm = std::move(fault);
  return finding;
}

namespace {

/// The calls that lead to each program from one that is run, on a shortest path.
class Ways {
 public:
  explicit Ways(const Checker& c) : c_(c), by_(c.flows.size()), seen_(c.flows.size(), false) {
    if (c.main != kNoProgram) from(c.main);
    for (const ProgramFlow& flow : c.flows)
      if (!c.is_called(flow.program())) from(flow.program());
  }
  /// Put the calls that lead to the start of a finding's path before it.
  void lead(Finding& finding) const {
    const Address first = finding.path.empty() ? finding.block : finding.path.front();
    std::vector<Address> before;
    for (const CallEdge* edge = to(first); edge != nullptr && before.size() < kMostCalls;
         edge = to(edge->from))
      before.push_back(edge->from);
    finding.path.insert(finding.path.begin(), before.rbegin(), before.rend());
  }

 private:
  static constexpr std::size_t kMostCalls = 64;  // the innermost calls

  const CallEdge* to(Address block) const {
    return by_[static_cast<std::size_t>(c_.code.program_at(block))];
  }
  void from(std::int32_t root) {
    std::vector<std::int32_t> waiting{root};
    seen_[static_cast<std::size_t>(root)] = true;
    for (std::size_t next = 0; next < waiting.size(); ++next)
      for (const CallEdge& edge : c_.flow(waiting[next]).calls()) {
        const auto called = static_cast<std::size_t>(edge.called);
        if (seen_[called]) continue;
        seen_[called] = true;
        by_[called] = &edge;
        waiting.push_back(edge.called);
      }
  }

  const Checker& c_;
  std::vector<const CallEdge*> by_;
  std::vector<bool> seen_;
};

}  // namespace

std::vector<Finding> Checker::take() {
  keep_edits();
  const Ways ways(*this);
  for (Finding& finding : findings_) {
    if (over()) break;
    ways.lead(finding);
    std::sort(finding.again.begin(), finding.again.end(),
              [](const FoundAgain& a, const FoundAgain& b) {
                return std::pair(a.block, a.place.at) < std::pair(b.block, b.place.at);
              });
  }
  std::stable_sort(findings_.begin(), findings_.end(), [](const Finding& a, const Finding& b) {
    return std::pair(a.block, a.check) < std::pair(b.block, b.check);
  });
  return std::move(findings_);
}

std::vector<Finding> check(const Code& code, const Starts& starts, const std::string& machine,
                           InterruptCheck& interrupt) {
  Checker checker(code, starts, machine, interrupt);
  for (const auto& part : {check_refusals, check_targets, check_reach, check_nesting, check_modes,
                           check_variables, check_labels, check_logic, check_values, check_drilling,
                           check_counting, check_read_ahead, check_writing}) {
    if (checker.over()) break;
    part(checker);
  }
  return checker.take();
}

}  // namespace cncsub
