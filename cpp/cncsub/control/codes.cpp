#include "cncsub/control/codes.hpp"

namespace cncsub {

std::string code_text(int tenfold) {
  std::string text = std::to_string(tenfold / 10);
  if (tenfold % 10 != 0) text += "." + std::to_string(tenfold % 10);
  return text;
}

std::string Codes::text() const {
  std::string text;
  for_each([&text](int tenfold) { text += (text.empty() ? "" : " ") + code_text(tenfold); });
  return text;
}

}  // namespace cncsub
