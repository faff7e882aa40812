#include "cncsub/dialect/ngc_lines.hpp"

namespace cncsub {

bool ngc_take_word(std::string_view& text, std::string_view word) {
  const bool same =
      text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(),
                                               [](char a, char b) { return a == upper(b); });
  if (same) text.remove_prefix(word.size());
  return same;
}

int ngc_take_format(const NgcFormat& format, std::string_view& text, std::string& plain,
                    int decimals) {
  const auto at = [&text](std::size_t place) { return place < text.size() ? text[place] : '\0'; };
  if (at(1) == 'd' || at(1) == 'f') {
    decimals = at(1) == 'd' ? 0 : format.of_f;
    text.remove_prefix(2);
  } else if (at(1) == '.' && is_digit(at(2)) && at(3) == 'f') {
    decimals = at(2) - '0';
    text.remove_prefix(4);
  } else {
    const bool lost = format.loses_percent && at(1) == '.';
    plain += lost ? '.' : '%';
    text.remove_prefix(lost ? 2 : 1);
  }
  return decimals;
}

}  // namespace cncsub
