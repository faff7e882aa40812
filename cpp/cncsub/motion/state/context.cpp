// Faults of a block.
#include "cncsub/motion/state/context.hpp"

#include <utility>

namespace cncsub {

Fault fault(Cause cause, const BlockWords& block, std::string detail) {
  return fault_at(WordName{}, cause, block.words.at, std::move(detail));
}

Fault fault_at(char address, Cause cause, const BlockWords& block, std::string detail) {
  return fault_at(WordName{.addresses = bit(address)}, cause, block, std::move(detail));
}

Fault fault_at(const WordName& word, Cause cause, const BlockWords& block, std::string detail) {
  return fault_at(word, cause, block.words.at, std::move(detail));
}

Fault fault_at(const WordName& word, Cause cause, Address block, std::string detail) {
  return {.cause = cause, .at = block, .detail = std::move(detail), .word = word};
}

Fault fault_of(int code, Cause cause, const BlockWords& block) {
  return fault_at(WordName{.code = code}, cause, block, code_name(code));
}

}  // namespace cncsub
