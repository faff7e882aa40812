#include "controls/facts.hpp"

namespace cncsub {

std::string cite(std::initializer_list<const char*> sources) {
  std::string text;
  for (const char* source : sources) {
    if (!text.empty()) text += "; ";
    text += source;
  }
  return text;
}

std::int32_t modal_word_number(char address) {
  switch (address) {
    case 'D':
      return 4107;
    case 'E':
      return 4108;
    case 'F':
      return 4109;
    case 'H':
      return 4111;
    default:
      return 4101 + (address - 'A');
  }
}

}  // namespace cncsub
