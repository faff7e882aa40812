// FANUC Series 0i-D.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

constexpr const char* kCodes0iD =
    "0 1 2 3 4 5 5.1 5.4 7.1 8 9 10 11 12.1 13.1 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 "
    "30.1 31 31.8 32 33 34 "
    "36 37 37.1 37.2 39 40 40.1 41 41.1 42 42.1 43 44 45 46 47 48 49 50 50.1 50.2 50.3 50.4 50.5 "
    "50.6 51 51.1 51.2 51.4 "
    "51.5 51.6 52 53 54 54.1 55 56 57 58 59 60 61 62 63 64 65 66 66.1 67 68 69 70 71 72 73 74 75 "
    "76 77 78 79 80 80.4 81 "
    "81.1 81.4 82 83 84 84.2 85 86 87 88 89 90 91 91.1 92 92.1 93 94 95 96 96.1 96.2 96.3 96.4 97 "
    "98 99 107 112 113 150 "
    "151 152 160 161 250 251";

const AlarmList& alarms_30i() {
  using enum Cause;
  static const AlarmList list = {kAlm,
                                 Secondary,
                                 true,
                                 "general knowledge of the 30i alarm list",
                                 {
#include "controls/fanuc/alarms_30i.def"
                                 }};
  return list;
}

/// The parameters that set rules and that the 16i does not have.
const Parameter kParameters[] = {
    {"6000#0",
     0,
     "G67: G67 without a modal call: 0 = alarm, 1 = ignored",
     kKnown,
     Inferred,
     {bit(rule::cancel_alone, CancelAlone::Alarm, CancelAlone::Ignored)}},
    {"6005#0",
     0,
     "SQC: 1 = M98 Q starts at a sequence number; without P in the own program",
     kWup,
     Secondary,
     {bit(rule::start_word, StartWord::None, StartWord::Q),
      bit(rule::omitted_program, OmittedProgram::Alarm, OmittedProgram::OwnFromStart)}},
    {"6006#0",
     0,
     "MLG: 1 = AND, OR and XOR may join conditions",
     kKnown,
     Inferred,
     {entry(rule::conditions, Condition::Joined)}},
    {"5145",
     0,
     "how far a profile of G71 and G72 may turn back along the first axis of the plane, mm",
     kKnown,
     Inferred,
     {micrometres(rule::first_axis_allowance)}},
    {"5146",
     0,
     "how far it may turn back along the second axis of the plane, mm of the radius",
     kKnown,
     Inferred,
     {micrometres(rule::second_axis_allowance)}},
};

}  // namespace

/// Like the 16i, with deeper nesting, G66.1, M98 Q, joined conditions and the alarm numbers of the
/// 30i.
Control fanuc_0i_d() {
  Control c = family();
  has(c.common.refuses, {Cause::IllegalWordWithReturn}, "ALM PS1093", Secondary);
  c.macros.max_constant_digits = {12, "general knowledge", Inferred};
  c.title = "FANUC Series 0i-D";
  c.reading.g_codes = {kCodes0iD, cite({k0iMd, kReg, "the rest general knowledge"}), Inferred};
  c.calls.max_nesting = {10, kKnown, Inferred};
  c.calls.nesting_counts_macros = {false, kKnown, Inferred};
  c.calls.max_macro_nesting = {5, kKnown, Inferred};
  c.macros.max_modal_calls = {5, cite({kKnown, "ALM PS0122 counts them as other macro calls"}),
                              Inferred};
  c.calls.max_total_nesting = {15, cite({kKnown, "ALM PS0077 speaks of the total number"}),
                               Inferred};
  c.calls.start_word = {StartWord::None,
                        cite({kWup, "M98 Q needs 6005#0 SQC", kGed, "its meaning"}), Secondary};
  c.calls.omitted_program = {OmittedProgram::Alarm, cite({kKnown, "M98 Q with 6005#0 SQC"}),
                             Inferred};
  c.calls.return_with_l = {ReturnWithL::ReplacesCount,
                           cite({kKnown, "unsure; ALM PS1093 lets L stand with M99"}), Inferred};
  has(c.common.refuses, {Cause::CallWithWordsInCycle}, cite({kAlm, "PS5329"}), Secondary);
  lacks(c.macros.conditions, {Condition::Joined}, cite({kKnown, "6006#0 MLG"}), Inferred);
  c.macros.short_functions = {true, "0i-MD shops", Secondary};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW BIN BCD MOD",
                        cite({kAli, "MOD general knowledge, POW unsure"}), Inferred};
  has(c.macros.variable_forms, {VariableForm::Names}, cite({kAlm, "PS1096 to PS1142"}), Secondary);
  give_role(c.calls.roles, "G66.1", Role::ModalCallEveryBlock, cite({kAlm, "PS0129 names it"}),
            Secondary);
  c.macros.cancel_alone = {CancelAlone::Alarm, cite({kAlm, "PS1100; 6000#0"}), Secondary};
  has(c.motion.data_forms, {DataForm::L52}, kKnown, Inferred);

  add_parameters(c, kParameters);
  code_calls(c, 9999, 3, 99999999, 3, 99999999);
  take_list(c, alarms_30i());
  domain_alarms(c, Cause::Overflow);
  c.user_alarm_prefix = "MC";
  c.user_alarm_digits = 4;
  return c;
}

}  // namespace cncsub
