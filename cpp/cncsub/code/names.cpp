#include "cncsub/code/names.hpp"

#include <algorithm>
#include <utility>

namespace cncsub {

std::uint32_t Names::label(const std::string& name) {
  const auto place = static_cast<std::uint32_t>(code_.labels.size());
  const auto [found, is_new] = code_.label_places.try_emplace(name, place);
  if (is_new) code_.labels.push_back(name);
  return found->second;
}

void Names::sort_heads() {
  std::sort(code_.heads.begin(), code_.heads.end(), [](const auto& a, const auto& b) {
    return a.label != b.label ? a.label < b.label : a.address < b.address;
  });
}

namespace {

/// Return the key of a variable among the names: a local and a common may have one name.
std::string key_of(const std::string& name, bool common) { return common ? name + '\n' : name; }

}  // namespace

std::optional<std::uint32_t> place_of_name(const Code& code, const std::string& name, bool common) {
  const auto found = code.named_places.find(key_of(name, common));
  if (found == code.named_places.end()) return std::nullopt;
  return found->second;
}

std::uint32_t Names::variable(const std::string& name, bool common) {
  const auto place = static_cast<std::uint32_t>(code_.named_variables.size());
  const auto [found, is_new] = code_.named_places.try_emplace(key_of(name, common), place);
  if (is_new) {
    const std::int32_t index = common ? code_.commons++ : code_.locals++;
    code_.named_variables.push_back({name, common, index});
    code_.named_at[common ? 1 : 0].emplace(index, place);
  }
  return found->second;
}

std::int32_t Names::returned() {
  if (code_.returned < 0) {
    code_.returned = code_.commons;
    code_.commons += 2;
  }
  return code_.returned;
}

std::int32_t Names::commons(std::int32_t count) {
  code_.commons += count;
  return code_.commons - count;
}

std::int32_t Names::hidden(const std::string& purpose, std::int32_t count) {
  const auto [found, is_new] = code_.hidden_locals.try_emplace(purpose, code_.locals);
  if (is_new) code_.locals += count;
  return found->second;
}

std::uint32_t Names::list(std::vector<double> numbers) {
  code_.lists.push_back(std::move(numbers));
  return static_cast<std::uint32_t>(code_.lists.size() - 1);
}

void Names::first_value(std::int32_t common, double value) {
  code_.first_values.emplace_back(common, value);
}

void Names::elements(std::int32_t count) { code_.elements = std::max(code_.elements, count); }

void Names::defined(DefinedVariable variable, bool shared) {
  if (shared) return code_.shared_variables.push_back(std::move(variable));
  Program& program = code_.programs.back();
  if (program.defined++ == 0)
    program.first_defined = static_cast<std::uint32_t>(code_.defined_variables.size());
  code_.defined_variables.push_back(std::move(variable));
}

std::uint32_t Names::text(std::string name) {
  code_.names.push_back(std::move(name));
  return static_cast<std::uint32_t>(code_.names.size() - 1);
}

}  // namespace cncsub
