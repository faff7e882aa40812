// FANUC Series 30i/31i/32i.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

constexpr const char* kCodes30i =
    "0 1 2 2.1 2.2 2.3 2.4 3 3.1 3.2 3.3 3.4 4 4.1 5 5.1 5.4 6.2 7 7.1 8 9 10 10.3 10.6 10.9 11 "
    "12.1 12.4 13.1 13.4 15 "
    "16 17 17.1 18 19 20 21 22 23 24 25 26 27 28 28.2 29 30 30.1 30.2 31 31.8 31.9 32 33 34 35 36 "
    "37 37.1 37.2 37.3 38 39 "
    "40 40.1 41 41.1 41.2 41.3 41.4 41.5 41.6 42 42.1 42.2 42.4 42.5 42.6 43 43.1 43.3 43.4 43.5 "
    "43.7 43.8 43.9 44 44.1 "
    "44.7 45 46 47 48 49 49.1 50 50.1 50.2 50.3 50.4 50.5 50.6 50.9 51 51.1 51.2 51.4 51.5 51.6 52 "
    "53 53.1 53.2 53.6 54 "
    "54.1 54.2 54.3 54.4 55 56 57 58 59 60 61 62 63 64 65 66 66.1 67 68 68.1 68.2 68.3 68.4 69 "
    "69.1 70 70.7 71 71.7 72 "
    "72.1 72.2 72.7 73 73.7 74 74.7 75 75.7 76 76.7 77 78 79 80 80.4 80.5 80.8 81 81.1 81.4 81.5 "
    "81.8 82 83 83.1 83.5 "
    "83.6 84 84.2 84.3 85 86 87 87.5 87.6 88 89 90 91 91.1 92 92.1 93 94 95 96 96.1 96.2 96.3 96.4 "
    "97 98 99 107 112 113 "
    "150 151 152 160 161 250 251";

// What the 30i adds: the running block's modal state, 300 work systems.
constexpr VariableRow kVariables30i[] = {
    {4201, 4230, VariableKind::ActiveCode, kReadOnly, 0, kKnown, Inferred},
    {4302, 4302, VariableKind::ActiveWord, kReadOnly, 'B', kKnown, Inferred},
    {4307, 4307, VariableKind::ActiveWord, kReadOnly, 'D', kKnown, Inferred},
    {4309, 4309, VariableKind::ActiveWord, kReadOnly, 'F', kKnown, Inferred},
    {4311, 4311, VariableKind::ActiveWord, kReadOnly, 'H', kKnown, Inferred},
    {4313, 4313, VariableKind::ActiveWord, kReadOnly, 'M', kKnown, Inferred},
    {4314, 4314, VariableKind::ActiveWord, kReadOnly, 'N', kKnown, Inferred},
    {4315, 4315, VariableKind::ActiveWord, kReadOnly, 'O', kKnown, Inferred},
    {4319, 4319, VariableKind::ActiveWord, kReadOnly, 'S', kKnown, Inferred},
    {4320, 4320, VariableKind::ActiveWord, kReadOnly, 'T', kKnown, Inferred},
    {4330, 4330, VariableKind::ActiveWord, kReadOnly, 'P', kKnown, Inferred},
    {14001, 19988, VariableKind::ExtraWorkOffset, kReadWrite, 0, kKnown, Inferred},
    // The positions once more, for more than 20 axes.
    {100001, 100050, VariableKind::BlockEnd, kReadOnly, 0, kKnown, Inferred},
    {100051, 100100, VariableKind::MachinePosition, kReadOnly, 0, kKnown, Inferred},
    {100101, 100150, VariableKind::WorkPosition, kReadOnly, 0, kKnown, Inferred},
    {100151, 100200, VariableKind::SkipPosition, kReadOnly, 0, k15iM, Secondary},
    {100201, 100250, VariableKind::ActiveLength, kReadOnly, 0, kKnown, Inferred},
    {100251, 100300, VariableKind::ServoError, kReadOnly, 0, kKnown, Inferred},
};

}  // namespace

/// Like the 0i-F, with more variables, repeat counts of eight digits and an alarm for M99 in the
/// main program to choose.
Control fanuc_30i() {
  Control c = fanuc_0i_f();
  c.title = "FANUC Series 30i/31i/32i";
  c.reading.max_sequence_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.calls.max_jump_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.calls.max_repeats = {99999999, kKnown, Inferred};
  c.reading.g_codes = {kCodes30i, cite({kReg, kCncs, kAlm, "the rest general knowledge"}),
                       Inferred};
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
