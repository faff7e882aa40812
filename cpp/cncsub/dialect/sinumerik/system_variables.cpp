// System variables in expressions, as far as the motion knows them.
#include "cncsub/code/motion_value.hpp"
#include "cncsub/dialect/sinumerik/expression.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr std::string_view kAxes = "XYZABCUVW";  // in the order of the axes of a mill

/// A G group whose number in $P_GG is not the number of the group on other controls.
struct GGroup {
  std::string_view number;
  int modal;  // among #4001 and up
  int first;  // the code before the first one of the group
};
constexpr GGroup kGroups[] = {
    {"6", 2, 16}, {"7", 7, 39}, {"14", 3, 89}};  // the plane, G40 to G42, G90 and G91 [NCI groups]

}  // namespace

/// Read $P_GG[6], the place of the code in force in its G group; $P_EP[X], the last programmed end
/// on an axis; $P_F or $P_S.
bool ExpressionReader::read_system_variable() {
  const std::uint32_t at = line_.offset();
  line_.pass(1);
  const std::string name = capitals(line_.name());
  line_.pass(name.size());
  constant_.reset();
  if (name == "P_F" || name == "P_S") {
    emit(Ins::MotionValue, motion_value_operand(MotionValue::ModalWord, name[2]));
    return true;
  }
  if ((name != "P_GG" && name != "P_EP") || !line_.take('['))
    return not_computed("a system variable", at);
  line_.peek();
  const std::string index(name == "P_GG" ? line_.take_digits() : line_.name());
  if (name == "P_EP") line_.pass(index.size());
  if (!line_.take(']')) return not_computed("a system variable", at);
  for (const GGroup& group : kGroups) {
    if (name != "P_GG" || index != group.number) continue;
    emit(Ins::MotionValue, motion_value_operand(MotionValue::ModalCode, group.modal));
    emit(Ins::Constant, group.first);
    emit(Ins::Subtract);
    return true;
  }
  const std::size_t axis = index.size() == 1 ? kAxes.find(capitals(index)) : kAxes.npos;
  if (name != "P_EP" || axis == kAxes.npos) return not_computed("a system variable", at);
  emit(Ins::MotionValue, motion_value_operand(MotionValue::BlockEnd, static_cast<int>(axis)));
  return true;
}

}  // namespace cncsub::sinumerik
