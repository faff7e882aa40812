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

Finding& Checker::found(Check check, Address block, TextPlace place, std::string detail) {
  Finding finding;
  finding.check = check;
  finding.block = block;
  finding.place = place;
  finding.detail = std::move(detail);
  findings.push_back(std::move(finding));
  return findings.back();
}

Finding& Checker::refused(Check check, Address block, Fault fault) {
  Finding& finding = found(check, block, {fault.at, fault.width}, fault.detail);
  finding.alarm_block = block;
  finding.alarm = std::move(fault);
  return finding;
}

namespace {

/// The calls that lead from a program that is run to each of the others, on a shortest way.
class Ways {
 public:
  explicit Ways(const Checker& c) : c_(c), by_(c.flows.size()), seen_(c.flows.size(), false) {
    if (c.main != kNoProgram) from(c.main);
    for (const ProgramFlow& flow : c.flows)
      if (!c.is_called(flow.program())) from(flow.program());
  }
  /// Before a finding's own path, those that lead to where it begins.
  void lead(Finding& finding) const {
    const Address first = finding.path.empty() ? finding.block : finding.path.front();
    std::vector<Address> before;
    for (const CallEdge* edge = to(first); edge != nullptr && before.size() < kMostCalls;
         edge = to(edge->from))
      before.push_back(edge->from);
    finding.path.insert(finding.path.begin(), before.rbegin(), before.rend());
  }

 private:
  static constexpr std::size_t kMostCalls = 64;  // the innermost of them

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

std::vector<Finding> check(const Code& code, std::int32_t main, const std::string& machine,
                           const std::function<bool()>& over) {
  const MachineType kind = machine_of(*code.control, machine);
  Checker checker{code, main, kind, GCodes(*code.control, kind), flow_of(code), {}, {}, {}};
  checker.callers.resize(code.programs.size());
  checker.named.resize(code.programs.size());
  for (const ProgramFlow& flow : checker.flows)
    for (const CallEdge& edge : flow.calls())
      checker.callers[static_cast<std::size_t>(edge.called)].push_back(edge);
  for (const auto& part :
       {check_refusals, check_targets, check_reach, check_nesting, check_modes, check_variables,
        check_labels, check_logic, check_values, check_writing}) {
    if (over()) break;
    part(checker);
  }
  const Ways ways(checker);
  for (Finding& finding : checker.findings) ways.lead(finding);
  std::stable_sort(checker.findings.begin(), checker.findings.end(),
                   [](const Finding& a, const Finding& b) {
                     return std::pair(a.block, a.check) < std::pair(b.block, b.check);
                   });
  return std::move(checker.findings);
}

}  // namespace cncsub
