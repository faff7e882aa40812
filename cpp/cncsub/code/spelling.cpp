#include "cncsub/code/spelling.hpp"

#include <algorithm>

#include "cncsub/code/block.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

bool ends_in(std::string_view name, std::string_view ending) {
  const std::size_t size = ending.size() + 1;
  if (name.size() < size) return false;
  const std::string_view last = name.substr(name.size() - size);
  return (last[0] == '.' || last[0] == '_') && same_letters(last.substr(1), ending);
}

std::string_view Spelling::bare_name(std::string_view name) const {
  const std::string_view mark = head.before.substr(std::min<std::size_t>(head.before.size(), 1));
  const std::size_t before = same_letters(name.substr(0, mark.size()), mark) ? mark.size() : 0;
  std::size_t around = before;
  for (const std::string_view ending : {main_ending, called_ending})
    if (!ending.empty() && ends_in(name, ending)) around += ending.size() + 1;
  return name.size() > around ? name.substr(before, name.size() - around) : name;
}

std::string Spelling::name_of_variable(const Control& control, std::int64_t number) const {
  std::string name = variable_name == nullptr ? "" : variable_name(control, number);
  return name.empty() ? std::string(variable) + std::to_string(number) : name;
}

namespace {

/// Return whether a place has no letter of its own in a language that has a long address there.
bool is_lent(int place) {
  const bool centre = place >= 'I' - 'A' && place <= 'K' - 'A';
  return place != 'R' - 'A' && !centre;
}

}  // namespace

int Spelling::place_of(std::string_view address) const {
  for (const IndexedAddress& of : indexed_addresses)  // POS[X]
    if (address.size() == of.name.size() + 3 && address.starts_with(of.name) &&
        address[of.name.size()] == '[' && is_letter(address[of.name.size() + 1]))
      return upper(address[of.name.size() + 1]) - 'A' + of.after;
  if (address == radius) return 'R' - 'A';
  for (const LongAddress& of : long_addresses)
    if (of.name == address) return of.place;
  if (address.size() == 2 && address[0] == ',') return comma_place(upper(address[1]));
  if (address.size() != 1) return -1;
  if (const auto sign = polar.find(address[0]); sign != std::string_view::npos)
    return kRadius + static_cast<int>(sign);
  const int place = is_letter(address[0]) ? upper(address[0]) - 'A' : -1;
  if (lends(place)) return -1;
  return place == 'R' - 'A' && radius.size() > 1 ? -1 : place;  // the place is that of CR
}

bool Spelling::lends(int place) const {
  return is_lent(place) && std::any_of(long_addresses.begin(), long_addresses.end(),
                                       [place](const auto& of) { return of.place == place; });
}

std::string Spelling::address_of(int place) const {
  for (const LongAddress& of : long_addresses)
    if (of.place == place && is_lent(place)) return std::string(of.name);
  if (place >= kRadius) {
    const auto sign = static_cast<std::size_t>(place - kRadius);
    return sign < polar.size() ? std::string(1, polar[sign]) : "";
  }
  if (place >= kCommaC) return {',', kCommaLetters[static_cast<std::size_t>(place - kCommaC)]};
  return place == 'R' - 'A' ? std::string(radius) : std::string(1, static_cast<char>('A' + place));
}

}  // namespace cncsub
