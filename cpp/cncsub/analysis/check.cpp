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

std::vector<Finding> check(const Code& code, std::int32_t main, const std::string& machine,
                           const std::function<bool()>& over) {
  const MachineType kind = machine_of(*code.control, machine);
  Checker checker{code, main, kind, GCodes(*code.control, kind), flow_of(code), {}, {}, {}};
  checker.callers.resize(code.programs.size());
  checker.named.resize(code.programs.size());
  for (const ProgramFlow& flow : checker.flows)
    for (const CallEdge& edge : flow.calls())
      checker.callers[static_cast<std::size_t>(edge.called)].push_back(edge);
  for (const auto& part : {check_refusals, check_targets, check_reach, check_nesting, check_modes,
                           check_variables, check_values, check_writing}) {
    if (over()) break;
    part(checker);
  }
  std::stable_sort(checker.findings.begin(), checker.findings.end(),
                   [](const Finding& a, const Finding& b) {
                     return std::pair(a.block, a.check) < std::pair(b.block, b.check);
                   });
  return std::move(checker.findings);
}

}  // namespace cncsub
