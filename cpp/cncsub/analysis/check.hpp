// The check of the programs of a memory: what is wrong or will surprise, found without running
// them.
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
  std::string_view control;   // the control of that program
};

const std::vector<CheckInfo>& all_checks();
inline const CheckInfo& info(Check check) { return all_checks()[static_cast<std::size_t>(check)]; }

/// A change of the text that is certain. Without a width, `text` is inserted after the line.
struct CertainEdit {
  Address block = kNowhere;
  TextPlace place;
  std::string text;
};

/// Another place of a finding, with the same cause.
struct FoundAgain {
  Address block = kNowhere;
  TextPlace place;
};

struct Finding {
  Check check{};
  Address block = kNowhere;
  TextPlace place;
  std::string detail;
  std::string hint;  // what to write instead; empty: the hint of the rule
  // The alarm that the control raises, and its block; nothing where it raises none or that is
  // unknown.
  std::optional<Fault> alarm;
  Address alarm_block = kNowhere;
  std::vector<Address> path;       // the blocks that call, the outermost first
  std::vector<CertainEdit> edits;  // at all its places
  std::vector<FoundAgain> again;   // the other places of the same cause, by their blocks
};

/// The programs that start a run: the one that is run first, kNoProgram where none is named, and
/// those that are called from outside of the memory, by a machine or an operator.
struct Starts {
  std::int32_t main = kNoProgram;
  std::vector<std::int32_t> entries;
};

/// Return all findings, by their blocks, one for each cause. `machine` is its kind, empty for the
/// control's own. After an interrupt the findings are not complete.
std::vector<Finding> check(const Code& code, const Starts& starts, const std::string& machine,
                           InterruptCheck& interrupt);

}  // namespace cncsub
