// Brackets around what an expression joins first, so that it reads as it is done.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cncsub {

/// How tightly operators bind; of two alike the left one comes first.
struct Binding {
  int conjunction = 2, disjunction = 1;  // AND; OR and XOR
  int comparison = 0, sum = 1, product = 2;
};
constexpr Binding kLogicAsArithmetic{};
constexpr Binding kLogicLast{0, 0, 1, 2, 3};

/// The expression with brackets wherever logic stands beside another operation, or beside other
/// logic where `apart` says so. Nothing where it is no plain expression, or where brackets would
/// stand more than `most` deep.
std::optional<std::string> with_brackets(std::string_view written, const Binding& binding,
                                         bool apart, int most);

}  // namespace cncsub
