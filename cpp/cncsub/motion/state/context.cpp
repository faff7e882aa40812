// Faults of a block.
#include "cncsub/motion/state/context.hpp"

#include <utility>

namespace cncsub {

Fault fault(Cause cause, const BlockWords& block, std::string detail) {
  return {cause, block.words.at, 1, std::move(detail)};
}

Fault fault_at(char address, Cause cause, const BlockWords& block, std::string detail) {
  Fault wrong = fault(cause, block, std::move(detail));
  wrong.address = address;
  return wrong;
}

Fault fault_of(int code, Cause cause, const BlockWords& block) {
  Fault wrong = fault_at('G', cause, block, code_name(code));
  wrong.code = code;
  return wrong;
}

}  // namespace cncsub
