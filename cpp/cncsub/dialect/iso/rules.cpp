// The rules that the ISO family asks.
#include <string_view>

#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

const std::string_view iso_rules;  // empty: all rules, for they were made for it

}  // namespace cncsub
