#include "controls/facts.hpp"

#include <string_view>
#include <utility>

#include "cncsub/control/alias.hpp"
#include "cncsub/control/source.hpp"

namespace cncsub {

const std::vector<Control>& all_controls() {
  static const auto& list = *new const std::vector<Control>([] {
    std::vector<Control> all;
    const auto take = [&all](std::string_view name, Control control) {
      control.name = name;
      complete(all.emplace_back(std::move(control)));
    };
#define CONTROL(function, name) take(name, function());
#include "controls/list.def"
#undef CONTROL
    return all;
  }());
  return list;
}

const std::vector<Alias>& all_aliases() {
  static const std::vector<Alias> aliases = {
#define ALIAS(name, control, source, evidence) {name, control, source, Evidence::evidence},
#include "controls/aliases.def"
#undef ALIAS
  };
  return aliases;
}

const std::vector<Source>& all_sources() {
  static const std::vector<Source> sources = {
#define SOURCE(key, title, address, about, evidence) \
  {key, title, address, about, Evidence::evidence},
#include "controls/sources.def"
#undef SOURCE
  };
  return sources;
}

std::string cite(std::initializer_list<const char*> sources) {
  std::string text;
  for (const char* source : sources) {
    if (!text.empty()) text += "; ";
    text += source;
  }
  return text;
}

Codes with(Codes codes, const Codes& more) {
  more.for_each([&codes](int code) { codes.put(code); });
  return codes;
}

std::int32_t modal_word_number(char address) {
  switch (address) {
    case 'D':
      return 4107;
    case 'E':
      return 4108;
    case 'F':
      return 4109;
    case 'H':
      return 4111;
    default:
      return 4101 + (address - 'A');
  }
}

}  // namespace cncsub
