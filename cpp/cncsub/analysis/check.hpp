// What is wrong with the programs of a memory, or will surprise, told without running them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/code/references.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

enum class Check : std::uint8_t {
#define CHECK(name, number, slug, severity, meaning, hint, example, control) name,
#include "cncsub/analysis/checks.def"
#undef CHECK
};

struct CheckInfo {
  std::string_view number;    // "CS201"
  std::string_view slug;      // "program-missing"
  std::string_view severity;  // error, warning, note
  std::string_view meaning;   // what it finds
  std::string_view hint;      // what to write instead
  std::string_view example;   // a program in which it is found
  std::string_view control;   // and its control
};

const std::vector<CheckInfo>& all_checks();
inline const CheckInfo& info(Check check) { return all_checks()[static_cast<std::size_t>(check)]; }

/// A change of the text that is certain; where it has no width, `text` is put behind the line.
struct CertainEdit {
  Address block = kNowhere;
  TextPlace place;
  std::string text;
};

/// Where a finding is found again for the same cause.
struct FoundAgain {
  Address block = kNowhere;
  TextPlace place;
};

struct Finding {
  Check check{};
  Address block = kNowhere;
  TextPlace place;
  std::string detail;
  std::string hint;  // what to write instead; empty: what the rule says
  // What the control raises, and in which block; nothing where it raises nothing, or nobody knows.
  std::optional<Fault> alarm;
  Address alarm_block = kNowhere;
  std::vector<Address> path;       // the blocks that call, the outermost first
  std::vector<CertainEdit> edits;  // of all its places
  std::vector<FoundAgain> again;   // the other places of the same cause, by their blocks
};

/// All findings, by their blocks: one for each cause. `main`: the program that is run first,
/// kNoProgram where nobody says so. `machine`: its kind, empty for the control's own. What is
/// interrupted gives findings that are not complete.
std::vector<Finding> check(const Code& code, std::int32_t main, const std::string& machine,
                           InterruptCheck& interrupt);

}  // namespace cncsub
