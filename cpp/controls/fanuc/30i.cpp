// FANUC Series 30i/31i/32i.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

/// The codes that the 30i has and the 0i-F does not.
constexpr const char* kMoreCodes =
    "2.1 2.3 2.4 3.1 3.3 3.4 4.1 6.2 7 10.3 12.4 13.4 28.2 30.2 31.9 37.3 41.2 41.3 41.4 41.5 "
    "41.6 42.2 42.4 42.5 42.6 43.1 43.3 43.4 43.5 43.8 43.9 44.1 44.7 49.1 50.9 53.2 54.3 54.4 "
    "70.7 71.7 72.7 73.7 74.7 75.7 76.7 80.8 81.8 84.3";

// The variables that the 30i adds: the running block's modal state, 300 work systems.
constexpr VariableRow kVariables30i[] = {
    {4201, 4230, VariableKind::ActiveCode, kReadOnly, 0, kKnown, Inferred},
    {4330, 4330, VariableKind::ActiveWord, kReadOnly, 'P', kKnown, Inferred},
    {14001, 19988, VariableKind::ExtraWorkOffset, kReadWrite, 0, kKnown, Inferred},
    // The positions again, for more than 20 axes.
    {100001, 100050, VariableKind::BlockEnd, kReadOnly, 0, kKnown, Inferred},
    {100051, 100100, VariableKind::MachinePosition, kReadOnly, 0, kKnown, Inferred},
    {100101, 100150, VariableKind::WorkPosition, kReadOnly, 0, kKnown, Inferred},
    {100151, 100200, VariableKind::SkipPosition, kReadOnly, 0, k15iM, Secondary},
    {100201, 100250, VariableKind::ActiveLength, kReadOnly, 0, kKnown, Inferred},
    {100251, 100300, VariableKind::ServoError, kReadOnly, 0, kKnown, Inferred},
};

}  // namespace

/// Like the 0i-F, with more variables, repeat counts of eight digits and an optional alarm for M99
/// in the main program.
Control fanuc_30i() {
  Control c = fanuc_0i_f();
  c.title = "FANUC Series 30i/31i/32i";
  c.reading.max_sequence_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.calls.max_jump_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.calls.max_repeats = {99999999, kKnown, Inferred};
  c.reading.g_codes = {with(c.reading.g_codes.value, kMoreCodes),
                       cite({kReg, kCncs, kAlm, "the rest general knowledge"}), Inferred};
  add_parameter(c, {"7712#4",
                    0,
                    "AMM: M99 in the main program: 0 = starts it over, 1 = alarm",
                    kAlm,
                    Secondary,
                    {bit(rule::main_return, MainReturn::Restarts, MainReturn::Alarm)}});
  add_parameter(c, {"19607#2",
                    0,
                    "the radius offset goes round an acute corner 0 = on lines, 1 = on an arc",
                    kKnown,
                    Inferred,
                    {bit(rule::acute_corner, AcuteCorner::Lines, AcuteCorner::Arc)}});
  c.motion.idle_blocks = {3, "30iM p.166, 15iM p.419", Manual};
  for (const VariableRow& row : kVariables30i) add_variable(c, row);
  for (const char word : {'B', 'D', 'F', 'H', 'M', 'N', 'O', 'S', 'T'}) {
    const int number = modal_word_number(word) + 200;
    add_variable(c, {number, number, VariableKind::ActiveWord, kReadOnly, word, kKnown, Inferred});
  }
  c.macros.commons = {"100-199 500-999 98000-98499", cite({kJix, "#98000 general knowledge"}),
                      Inferred};
  for (VariableRange& range : c.variables) {
    if (range.kind == VariableKind::Date || range.kind == VariableKind::Time)
      range.access = Access::ReadWrite;
    if (range.kind == VariableKind::InputWord) range.last = 1035;  // general knowledge, as #4030
    if (range.kind == VariableKind::ModalCode) range.last = 4030;
    // Positions of 20 axes. [15iM p.564: #5061 to #5080]
    if (range.first % 20 == 1 && range.first >= 5001 && range.first <= 5101) {
      range.last = range.first + 19;
      if (range.kind == VariableKind::SkipPosition) range.source = k15iM;
    }
  }
  return c;
}

}  // namespace cncsub
