#include "cncsub/control/variable_groups.hpp"

namespace cncsub {

std::string_view group_of(VariableKind kind) {
  switch (kind) {
    case VariableKind::Vacant:
    case VariableKind::Local:
    case VariableKind::LevelImage:
      return "locals";
    case VariableKind::Common:
    case VariableKind::Kept:
      return "commons";
    case VariableKind::Input:
    case VariableKind::InputWord:
    case VariableKind::Output:
    case VariableKind::OutputWord:
      return "signals";
    case VariableKind::Milliseconds:
    case VariableKind::Hours:
    case VariableKind::Date:
    case VariableKind::Time:
      return "clock";
    case VariableKind::UserAlarm:
    case VariableKind::Control1:
    case VariableKind::Settings:
    case VariableKind::Message:
    case VariableKind::Mirror:
    case VariableKind::Restart:
    case VariableKind::PartsCount:
    case VariableKind::MessageSwitch:
    case VariableKind::ParameterChoice:
    case VariableKind::ParameterValue:
      return "settings";
    case VariableKind::ModalCode:
    case VariableKind::ModalWord:
    case VariableKind::ActiveCode:
    case VariableKind::ActiveWord:
      return "modes";
    case VariableKind::BlockEnd:
    case VariableKind::MachinePosition:
    case VariableKind::WorkPosition:
    case VariableKind::SkipPosition:
    case VariableKind::SkipTouched:
    case VariableKind::ServoError:
      return "position";
    case VariableKind::WorkOffset:
    case VariableKind::AxisWorkOffset:
    case VariableKind::Shift:
    case VariableKind::ReferencePoint:
    case VariableKind::WorkSystem:
    case VariableKind::ExtraWorkOffset:
    case VariableKind::StoredFrame:
    case VariableKind::FrameInForce:
    case VariableKind::FrameNumber:
      return "work offsets";
    case VariableKind::ActiveLength:
    case VariableKind::ToolLength:
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
    case VariableKind::EdgeDatum:
    case VariableKind::ToolName:
      return "tool offsets";
  }
  return "";
}

}  // namespace cncsub
