// Syntec 22MA, the control of Syil mills: its ISO programs, and those in its own language, which
// begin with %@MACRO.
#include <tuple>
#include <utility>

#include "cncsub/control/at_variables.hpp"
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

namespace {

using enum Evidence;

/// Set the variables: all locals of a level, and the commons. None of those beyond #999 is the
/// Mitsubishi's. Of the commons @, those that are registers of the PLC are not known.
void variables(Control& c) {
  constexpr const char* kSources =
      "SYM: #1 to #400 are of the level, #401 to #999 kept; @1 to @400, @656 to @999 and @1001 to "
      "@1999 hold numbers";
  c.variables = {{0, 0, VariableKind::Vacant, Access::ReadOnly, 0, "SYM: #0 is vacant", Secondary},
                 {1, 400, VariableKind::Local, Access::ReadWrite, 0, kSources, Secondary},
                 {kAtVariables, kAtVariables, VariableKind::Vacant, Access::ReadOnly, 0,
                  "SYM: @0 is vacant", Secondary}};
  c.variable_choices.clear();
  c.macros.commons = {"401-999 1000001-1000400 1000656-1000999 1001001-1001999", kSources,
                      Secondary};
  c.macros.unlisted_variables = {UnlistedVariable::NotKnown,
                                 "SYM: system variables from #1000 on, and registers of the PLC "
                                 "as @401 to @655 and from @10000 on, which are not known here",
                                 Secondary};
}

void calling(Control& c) {
  c.calls.start_word = {StartWord::H, "SYP, M98 H9000; PWR p.149, M98 P H L", Secondary};
  c.calls.omitted_program = {OmittedProgram::Own,
                             "SYP: M98 H9000 calls what N9000 heads in its own program; PWR p.149",
                             Secondary};
  c.calls.mdi_calls = {MdiCalls::Allowed, "PWR p.149: without P in memory and MDI", Secondary};
  c.calls.return_with_p = {c.calls.return_with_p.value,
                           "PWR p.150: M99 P is a block of the caller; in which pass nobody says",
                           Inferred};
  c.calls.return_to_line = {true, "SYM: M99 Q is a line number of the file", Secondary};
  c.calls.end_in_subprogram = {EndInSubprogram::Returns,
                               "SYM: M02 and M30 in a subprogram return to the caller", Secondary};
  c.calls.jump_search = {JumpSearch::FromHead, "SYM: of two equal N, GOTO goes to the first",
                         Secondary};
  c.calls.zero_repeats = {ZeroRepeats::Skip, "SYM: L0 calls nothing", Secondary};
  give_role(c.calls.roles, "M198", Role::ExternalCall,
            "SYM: M198 P H L, as M98, and the file is read anew", Secondary);
  give_role(c.calls.roles, "G65", Role::MacroCall, "SYP: G65 P9810 Z; SYM: G65 P L", Secondary);
  give_role(c.calls.roles, "G66", Role::ModalCall, "SYM: G66 P L, after each block that moves",
            Secondary);
  give_role(c.calls.roles, "G66.1", Role::ModalCallEveryBlock,
            "SYM: G66.1 P L, after each block, which itself is executed", Secondary);
  c.macros.modal_locals = {ModalLocals::Kept, "SYM: the locals of G66 are kept until G67",
                           Secondary};
  c.macros.argument_sets = {ArgumentSets::First, "SYM: I, J and K are #4, #5 and #6", Secondary};
}

/// Set the codes that call programs, each by its name: G0200, M0050, T0000.
void calling_codes(Control& c) {
  using Form = CodeCall::Form;
  CodeCall extension;
  extension.address = 'G';
  extension.kind = CodeCallKind::Macro;
  extension.first_code = 200;
  extension.last_code = 999;
  extension.source = "SYM: G200 to G999 call the programs G0200 to G0999, G200.1 calls G200001";
  extension.evidence = Secondary;
  extension.program = -1;  // of the code's name
  CodeCall m = extension;
  m.address = 'M';
  m.parameter = 3601;
  m.count = 10;
  m.first_code = 1;
  m.last_code = 9999;
  m.refused = "0 1 2 30 96 97 98 99";
  m.source = "SYM: Pr3601 to Pr3610 register ten M codes, M50 calls M0050";
  CodeCall t = extension;
  t.form = Form::Switch;
  t.address = 'T';
  t.first_code = 0;
  t.last_code = 99999999;
  t.enable = "3215";
  t.parameter = 2;
  t.source = "SYM: Pr3215: 1 calls T0000 as a subprogram, 2 as a macro";
  CodeCall subprogram = t;
  subprogram.kind = CodeCallKind::Subprogram;
  subprogram.parameter = 1;
  c.code_calls = {extension, m, t, subprogram};
  c.macros.code_cascade = {
      CodeCascade::OtherKind,
      "SYM: in a macro of an M code no other M or T code calls; the G codes of "
      "a macro of a G code are ordinary",
      Secondary};
  c.reading.unlisted_codes = {UnlistedCode::NotKnown, "which G codes it has beyond those of SYM",
                              Inferred};
}

/// Set the parameters by which codes are registered.
void registering(Control& c) {
  c.parameters.clear();
  add_parameter(c, {"3215", 0, "T code calls T0000: 1 as a subprogram, 2 as a macro",
                    "SYM: Pr3215; its default", Secondary});
  for (int i = 3601; i <= 3610; ++i)
    add_parameter(c, {std::to_string(i), 0, "M code that calls the macro of its name, 0 = none",
                      "SYM: Pr3601 to Pr3610", Secondary});
  c.calls.registered_codes = {"", "SYM: Pr3601 to Pr3610 are 0 as delivered", Secondary};
}

/// Set the language of programs that begin with %@MACRO.
void language(Control& c) {
  c.dialect = "syntec";
  c.macros.statements = {"# [",
                         "SYM: an ISO file has no statements, but of #1=5 and X#1 in one the "
                         "sources differ",
                         Inferred};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN ATAN2 SQRT ABS ROUND EXP LN POW SIGN MOD",
                        "SYM, functions", Secondary};
  c.macros.atan_range = {AngleRange::Signed, "SYM: ATAN -90 to 90, ATAN2 -180 to 180", Secondary};
  c.macros.asin_range = {AngleRange::Signed, "SYM: ASIN -90 to 90", Secondary};
  c.macros.max_ifs = {10, "SYM: ten structures inside each other, COM-007", Secondary};
  c.macros.max_loops = {10, "SYM: ten structures inside each other, COM-007", Secondary};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, "SYM: #0 is not equal to 0",
                                Secondary};
}

// The numbers of causes. [SYM, alarms]
constexpr std::pair<Cause, const char*> kNumbers[] = {
    {Cause::StatementNotAvailable, "COM-003"},
    {Cause::StatementFormat, "COM-003"},
    {Cause::ExpressionFormat, "COM-003"},
    {Cause::LoopsTooDeep, "COM-007"},
    {Cause::IfTooDeep, "COM-007"},
    {Cause::IllegalVariable, "COR-016"},
    {Cause::UserAlarm, "COR-027"},
    {Cause::TypeMismatch, "COR-054"},
    {Cause::MissingEquals, "COM-003"},
    {Cause::IllegalCharacter, "COM-003"},
    {Cause::WholeNumberExpected, "COR-054"},
    {Cause::PowerOfNegative, "COR-122"},
    {Cause::CodeMayNotCall, "OP-020"},
};

// The number of a cause in one kind of structure, or of function.
constexpr std::tuple<Cause, const char*, const char*> kOfKinds[] = {
    {Cause::IllegalCharacter, "NA", "COM-027"}, {Cause::ProgramNumberMissing, "EX", "COR-052"},
    {Cause::StatementFormat, "FO", "COM-013"},  {Cause::StatementFormat, "CA", "COM-022"},
    {Cause::StatementFormat, "UN", "COM-016"},  {Cause::StatementFormat, "CO", "COM-025"},
    {Cause::IfFormat, "NI", "COM-019"},         {Cause::WhileFormat, "WH", "COM-017"},
    {Cause::MissingEnd, "FO", "COM-014"},       {Cause::MissingEnd, "RE", "COM-015"},
    {Cause::MissingEnd, "WH", "COM-018"},       {Cause::MissingDo, "FO", "COM-013"},
    {Cause::MissingDo, "WH", "COM-017"},        {Cause::MissingDo, "RE", "COM-034"},
    {Cause::IfWithoutEnd, "NI", "COM-019"},     {Cause::IfWithoutEnd, "IF", "COM-020"},
    {Cause::IfWithoutEnd, "EL", "COM-021"},     {Cause::IfWithoutEnd, "NC", "COM-022"},
    {Cause::IfWithoutEnd, "CA", "COM-023"},     {Cause::IfWithoutEnd, "CE", "COM-024"},
};

/// Set the numbers of alarms. What no source gives has a cause and no number.
void alarms(Control& c) {
  c.alarms.clear();
  const auto take = [&c](Cause cause, const char* number) {
    c.alarms[cause].number = number;
    c.alarms[cause].source = "SYM, alarms";
    c.alarms[cause].evidence = Secondary;
  };
  for (const auto& [cause, number] : kNumbers) take(cause, number);
  for (const auto& [cause, kind, number] : kOfKinds) {
    if (c.alarms[cause].source.empty()) take(cause, "");
    c.alarms[cause].directed.push_back({kind, number, ""});
  }
  c.user_alarm_number = "COR-027";
}

}  // namespace

/// Calls as a Mitsubishi makes them, but for what its maker says otherwise. What no source says is
/// as on the Mitsubishi, except for all that has a number there.
Control syntec_22ma() {
  Control c = mitsubishi::family();
  c.title = "Syntec 22MA mill";
  calling(c);
  c.motion.g_meanings = {"31.1=skip 31.2=skip 31.3=skip 37=not-computed 37.1=measuring",
                         "policy: as on the Mitsubishi", Inferred};
  lacks(c.common.refuses, {Cause::ArcFeedZero, Cause::CornerNextShort},
        "policy: the numbers of Mitsubishi's list alone tell them from a missing feed and a long "
        "corner",
        Inferred);
  variables(c);
  calling_codes(c);
  registering(c);
  language(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
