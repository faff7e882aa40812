// The rules that the ISO family asks.
#include <string_view>

#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

const std::string_view iso_rules;  // all: they were made for it

}  // namespace cncsub
