#include "cncsub/code/spelling.hpp"

#include <algorithm>
#include <vector>

#include "cncsub/code/block.hpp"
#include "cncsub/control/edge_datum.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

bool ends_in(std::string_view name, std::string_view ending) {
  const std::size_t size = ending.size() + 1;
  if (name.size() < size) return false;
  const std::string_view last = name.substr(name.size() - size);
  return (last[0] == '.' || last[0] == '_') && same_letters(last.substr(1), ending);
}

namespace {

/// Return what a name begins with on the control: _N_.
std::string_view mark_of(const Spelling& spelling) {
  const std::string_view before = spelling.head.before;
  return before.substr(std::min<std::size_t>(before.size(), 1));
}

}  // namespace

std::string Spelling::folder_of(std::string_view path) const {
  constexpr std::size_t kEnding = 4;  // _DIR
  const std::string_view mark = mark_of(*this);
  std::string folder;
  while (!folders.empty() && !path.empty()) {
    const std::size_t end = std::min(path.find_first_of(kPathSigns), path.size());
    std::string name = capitals(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
    if (name.empty()) continue;
    const bool marked = name.starts_with(mark);
    if (marked) {
      name.erase(0, mark.size());
      if (name.size() > kEnding && name[name.size() - kEnding] == '_')
        name[name.size() - kEnding] = '.';
    }
    const bool own = marked || ends_in(name, folder_ending) ||
                     std::find(folders.begin(), folders.end(), name) != folders.end();
    if (folder.empty() ? own : true) folder += (folder.empty() ? "" : "/") + name;
  }
  return folder;
}

std::string_view Spelling::bare_name(std::string_view name) const {
  const std::string_view mark = mark_of(*this);
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

/// Return the whole numbers in a text, in their order.
std::vector<std::int64_t> numbers_in(std::string_view text) {
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    if (i == 0 || !is_digit(text[i - 1])) numbers.push_back(0);
    numbers.back() = std::min<std::int64_t>(numbers.back() * 10 + (text[i] - '0'), 4'000'000'000);
  }
  return numbers;
}

/// Return the numbers among which that of a variable is, of a range: all of a short one.
std::vector<std::int64_t> candidates(const VariableRange& range,
                                     const std::vector<std::int64_t>& written) {
  constexpr std::int64_t kShort = 2000;
  std::vector<std::int64_t> found;
  if (range.kind == VariableKind::EdgeDatum) {
    if (written.size() == 3) {
      const auto part = [&](std::size_t i) { return static_cast<std::int32_t>(written[i]); };
      found.push_back(range.first + std::int64_t{EdgeDatum{part(0), part(2), part(1)}.number()});
    }
  } else if (range.last - range.first < kShort) {
    for (std::int64_t number = range.first; number <= range.last; ++number) found.push_back(number);
  } else if (!written.empty()) {
    found = {written.back(), range.first + written.back()};
  }
  return found;
}

/// Return whether a name is a number alone or one with the sign of variables: 5, #5, #[5].
bool is_numbered(std::string_view written, const std::string& digits, std::string_view sign) {
  if (written == digits) return true;
  if (!written.starts_with(sign)) return false;
  written.remove_prefix(sign.size());
  return written == digits || written == '[' + digits + ']';
}

/// Return the common variable of this name; nothing where there is none.
std::optional<std::int64_t> common_named(const Control& control, const Spelling& spelling,
                                         std::string_view written) {
  if (spelling.variable_name == nullptr || written.empty()) return std::nullopt;
  for (const Span& commons : control.macros.commons.value)
    for (std::int64_t number = commons.first; number <= commons.last; ++number)
      if (capitals(spelling.variable_name(control, number)) == written) return number;
  return std::nullopt;
}

}  // namespace

std::optional<std::int64_t> Spelling::number_of_variable(const Control& control,
                                                         std::string_view name) const {
  std::string written = capitals(name);
  std::erase_if(written, [](char c) { return is_blank(c); });
  const std::vector<std::int64_t> numbers = numbers_in(written);
  if (numbers.empty() && variable_name == nullptr) return std::nullopt;
  if (numbers.size() == 1) {
    const std::string digits = std::to_string(numbers[0]);
    if (is_numbered(written, digits, variable) &&
        (written == digits ||
         name_of_variable(control, numbers[0]) == std::string(variable).append(digits)))
      return numbers[0];
  }
  for (const VariableRange& range : control.variables)
    for (const std::int64_t number : candidates(range, numbers))
      if (number >= range.first && number <= range.last &&
          capitals(name_of_variable(control, number)) == written)
        return number;
  return common_named(control, *this, written);
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
