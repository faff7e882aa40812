#include "cncsub/code/spelling.hpp"

#include "cncsub/code/block.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

int Spelling::place_of(std::string_view address) const {
  if (address == radius) return 'R' - 'A';
  if (address.size() == 2 && address[0] == ',') return comma_place(upper(address[1]));
  if (address.size() != 1) return -1;
  if (const auto sign = polar.find(address[0]); sign != std::string_view::npos)
    return kRadius + static_cast<int>(sign);
  return is_letter(address[0]) ? upper(address[0]) - 'A' : -1;
}

std::string Spelling::address_of(int place) const {
  if (place >= kRadius) return std::string(1, polar[static_cast<std::size_t>(place - kRadius)]);
  if (place >= kCommaC) return {',', kCommaLetters[static_cast<std::size_t>(place - kCommaC)]};
  return place == 'R' - 'A' ? std::string(radius) : std::string(1, static_cast<char>('A' + place));
}

}  // namespace cncsub
