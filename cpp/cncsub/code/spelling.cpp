#include "cncsub/code/spelling.hpp"

#include "cncsub/code/block.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

int Spelling::place_of(std::string_view address) const {
  if (address == radius) return 'R' - 'A';
  for (const LongAddress& of : long_addresses)
    if (of.name == address) return of.place;
  if (address.size() == 2 && address[0] == ',') return comma_place(upper(address[1]));
  if (address.size() != 1) return -1;
  if (const auto sign = polar.find(address[0]); sign != std::string_view::npos)
    return kRadius + static_cast<int>(sign);
  return is_letter(address[0]) ? upper(address[0]) - 'A' : -1;
}

namespace {

/// Return whether a place has no letter of its own in a language that has a long address there.
bool is_lent(int place) {
  const bool centre = place >= 'I' - 'A' && place <= 'K' - 'A';
  return place != 'R' - 'A' && !centre;
}

}  // namespace

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
