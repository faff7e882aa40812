// How a language reads a written number.
#pragma once

#include <string_view>

namespace cncsub {

using NumberReader = double (*)(std::string_view digits);

/// Return how the language of this name reads a number without a sign; null where it takes the
/// nearest one of 64 bits. The languages define it.
NumberReader number_reader(std::string_view dialect);

}  // namespace cncsub
