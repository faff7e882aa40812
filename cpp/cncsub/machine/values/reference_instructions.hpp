// The computations of the instructions of parameters by reference, and of words that are left out.
#pragma once

#include <vector>

#include "cncsub/machine/values/instructions.hpp"

namespace cncsub::instruction {

/// Fail where the program is left whose variable a parameter stands for.
inline Fallible gone(E e, I at) {
  return fails(e, at, Cause::CodeNotComputed, "the program whose variable this is was left");
}
inline Fallible referenced(E e, I at) {
  const double of = e.places.local(at.index());
  if (is_vacant(of)) return number(e.places.local(at.at()));
  const double* const cell = e.run.state.cell(Reference::of(of));
  if (cell != nullptr) return number(*cell);
  gone(e, at);
  e.trap.at = kNowhere;  // it holds no place
  return std::nullopt;
}
inline Fallible referenced_element(E e, I at, double a) {
  const double of = e.places.local(to_whole<std::uint32_t>(at.value()));
  const double* const cell =
      is_vacant(of) ? nullptr
                    : e.run.state.cell(Reference::of(of).behind(to_whole<std::size_t>(a)));
  return cell == nullptr ? gone(e, at) : number(*cell);
}
inline Fallible index_below(E e, I at, double a, double b) {
  const double index = cncsub::rounded(number(a));
  if (index >= 0 && index < b) return index;
  return fails(e, at, Cause::ArrayElement, "the index is outside the array");
}
inline Fallible listed(E e, I at, double a) {
  const std::vector<double>& list = e.run.code->lists[to_whole<std::size_t>(at.value())];
  const double place = cncsub::rounded(number(a));
  if (place >= 1 && place <= static_cast<double>(list.size()))
    if (const double found = list[to_whole<std::size_t>(place) - 1]; !is_vacant(found))
      return found;
  return fails(e, at, Cause::GroupCodeNotAvailable, "no code of the group has this number");
}
inline double place_in(E e, I at, double a) {
  const std::vector<double>& list = e.run.code->lists[to_whole<std::size_t>(at.value())];
  const auto found = std::find(list.begin(), list.end(), a);
  return found == list.end() ? kVacant : static_cast<double>(found - list.begin()) + 1;
}
/// Leave a word out of its block; the value that it takes instead is vacant.
inline double left_out(E e, I at) {
  e.run.block.left_out.push_back({0, at.at(), to_whole<std::uint32_t>(at.value())});
  return kVacant;
}
inline double of_first(E e, I at, double a, double b) {
  return cncsub::rounded(number(b)) == 1 ? a : left_out(e, at);
}

}  // namespace cncsub::instruction
