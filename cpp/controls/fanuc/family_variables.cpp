// The variables that the FANUC controls share, and those that a shop buys.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {
namespace {

// The numbers of a mill with tool offset memory C and eight axes.
constexpr VariableRow kVariables[] = {
    {0, 0, VariableKind::Vacant, kReadOnly, 0, kJix, Secondary},
    {1, 33, VariableKind::Local, kReadWrite, 0, kJix, Secondary},
    {1000, 1015, VariableKind::Input, kReadOnly, 0, kA51, Secondary},
    {1032, 1032, VariableKind::InputWord, kReadOnly, 0, kA51, Secondary},
    {1100, 1115, VariableKind::Output, kReadWrite, 0, kKnown, Inferred},
    {1132, 1133, VariableKind::OutputWord, kReadWrite, 0, kKnown, Inferred},
    {2001, 2200, VariableKind::LengthWear, kReadWrite, 0, kKnown, Inferred},
    {2201, 2400, VariableKind::LengthGeometry, kReadWrite, 0, kKnown, Inferred},
    {3000, 3000, VariableKind::UserAlarm, kWriteOnly, 0, kGed, Secondary},
    {3001, 3001, VariableKind::Milliseconds, kReadWrite, 0, kReg, Secondary},
    {3002, 3002, VariableKind::Hours, kReadWrite, 0, kReg, Secondary},
    {3003, 3004, VariableKind::Control1, kReadWrite, 0, kZap, Secondary},
    {3005, 3005, VariableKind::Settings, kReadWrite, 0, kKnown, Inferred},
    {3006, 3006, VariableKind::Message, kWriteOnly, 0, kZap, Secondary},
    {3007, 3007, VariableKind::Mirror, kReadOnly, 0, kKnown, Inferred},
    {3008, 3008, VariableKind::Restart, kReadOnly, 0, kKnown, Inferred},
    {3011, 3011, VariableKind::Date, kReadOnly, 0, kReg, Secondary},
    {3012, 3012, VariableKind::Time, kReadOnly, 0, kReg, Secondary},
    {3901, 3902, VariableKind::PartsCount, kReadWrite, 0, kKnown, Inferred},
    {4001, 4022, VariableKind::ModalCode, kReadOnly, 0, kReg, Secondary},
    {4102, 4102, VariableKind::ModalWord, kReadOnly, 'B', kReg, Secondary},
    {4107, 4107, VariableKind::ModalWord, kReadOnly, 'D', kReg, Secondary},
    {4109, 4109, VariableKind::ModalWord, kReadOnly, 'F', kReg, Secondary},
    {4111, 4111, VariableKind::ModalWord, kReadOnly, 'H', kReg, Secondary},
    {4113, 4113, VariableKind::ModalWord, kReadOnly, 'M', kReg, Secondary},
    {4114, 4114, VariableKind::ModalWord, kReadOnly, 'N', kReg, Secondary},
    {4115, 4115, VariableKind::ModalWord, kReadOnly, 'O', kReg, Secondary},
    {4119, 4119, VariableKind::ModalWord, kReadOnly, 'S', kReg, Secondary},
    {4120, 4120, VariableKind::ModalWord, kReadOnly, 'T', kReg, Secondary},
    {4130, 4130, VariableKind::ModalWord, kReadOnly, 'P', kKnown, Inferred},
    {5001, 5008, VariableKind::BlockEnd, kReadOnly, 0, kZap, Secondary},
    {5021, 5028, VariableKind::MachinePosition, kReadOnly, 0, kZap, Secondary},
    {5041, 5048, VariableKind::WorkPosition, kReadOnly, 0, kZap, Secondary},
    {5061, 5068, VariableKind::SkipPosition, kReadOnly, 0, kZap, Secondary},
    {5081, 5088, VariableKind::ActiveLength, kReadOnly, 0, kZap, Secondary},
    {5101, 5108, VariableKind::ServoError, kReadOnly, 0, kZap, Secondary},
    {5201, 5328, VariableKind::WorkOffset, kReadWrite, 0, kKnown, Inferred},
    {7001, 7948, VariableKind::ExtraWorkOffset, kReadWrite, 0, kKnown, Inferred},
    {10001, 10999, VariableKind::LengthWear, kReadWrite, 0, kKnown, Inferred},
    {11001, 11999, VariableKind::LengthGeometry, kReadWrite, 0, kKnown, Inferred},
    {12001, 12999, VariableKind::RadiusWear, kReadWrite, 0, kKnown, Inferred},
    {13001, 13999, VariableKind::RadiusGeometry, kReadWrite, 0, kKnown, Inferred},
};

/// Add the commons and the other variables that are bought. The addition is fitted here.
void variable_choices(Control& c) {
  c.macros.commons = {"100-199 500-999", cite({kJix, "with the addition"}), Secondary};
  c.macros.variable_options = {"", kPolicy, Inferred};
  c.variable_choices = {
      {"basic-commons",
       "the custom macro without added common variables",
       "100-149 500-531",
       {},
       kXia,
       Secondary},
      {"added-commons",
       "addition of custom macro common variables",
       "100-199 500-999",
       {},
       cite({kJix, "its name general knowledge"}),
       Inferred},
      {"commons-from-100", "common variables from #100 to #999", "100-999", {}, kKnown, Inferred},
  };
  VariableOption work{"work-offsets-by-axis",
                      "the work offsets of a mill by axis, #2500 to #2806",
                      "",
                      {},
                      cite({"real programs", "general knowledge"}),
                      Inferred};
  for (int first = 2500; first <= 2800; first += 100)
    work.variables.push_back(
        {first, first + 6, VariableKind::AxisWorkOffset, kReadWrite, 0, work.source, Inferred});
  c.variable_choices.push_back(std::move(work));
}

}  // namespace

void add_variable(Control& c, const VariableRow& row) {
  c.variables.push_back(
      {row.first, row.last, row.kind, row.access, row.address, row.source, row.evidence});
}

void add_family_variables(Control& c) {
  for (const VariableRow& row : kVariables) add_variable(c, row);
  variable_choices(c);
}

}  // namespace cncsub::fanuc
