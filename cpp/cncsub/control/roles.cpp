#include "cncsub/control/roles.hpp"

#include <algorithm>
#include <iterator>

namespace cncsub {

namespace {

constexpr std::string_view kRoles[] = {
#define ROLE(name, slug, example, words, causes) slug,
#include "cncsub/control/roles.def"
#undef ROLE
};

}  // namespace

std::string_view to_string(Role role) { return kRoles[static_cast<std::size_t>(role)]; }

Role role_of(std::string_view slug) {
  for (std::size_t i = 0; i < std::size(kRoles); ++i)
    if (kRoles[i] == slug) return static_cast<Role>(i);
  return Role::None;
}

std::vector<std::string_view> role_names() {
  std::vector<std::string_view> names;
  for (std::size_t i = 1; i < std::size(kRoles); ++i) names.push_back(kRoles[i]);
  return names;
}

std::string CodeName::text() const {
  std::string number = std::to_string(tenfold / 10);
  if (number.size() == 1) number = "0" + number;
  if (tenfold % 10 != 0) number += "." + std::to_string(tenfold % 10);
  return letter + number;
}

Role Roles::of_g(int tenfold) const {
  for (const Entry& entry : g_)
    if (entry.code.tenfold == tenfold) return entry.role;
  return Role::None;
}

std::vector<Roles::Entry> Roles::entries() const {
  std::vector<Entry> all = g_;
  for (int m = 0; m < kCodes; ++m)
    if (of_m(m) != Role::None) all.push_back({{'M', m * 10}, of_m(m)});
  return all;
}

std::optional<CodeName> Roles::code_of(Role role) const {
  for (const Entry& entry : entries())
    if (entry.role == role) return entry.code;
  return std::nullopt;
}

void Roles::set(CodeName code, Role role) {
  if (code.letter == 'M') {
    m_[static_cast<std::size_t>(code.tenfold / 10)] = role;
    return;
  }
  std::erase_if(g_, [&](const Entry& entry) { return entry.code == code; });
  if (role == Role::None) return;
  const auto at =
      std::find_if(g_.begin(), g_.end(), [&](const Entry& entry) { return code < entry.code; });
  g_.insert(at, {code, role});
}

bool calls_elsewhere(const Roles& roles, int m) {
  return (m == 97 || m == 98 || m == 99 || m == 198) && roles.of_m(m) == Role::None;
}

Roles family_roles() {
  return {{{'M', 0}, Role::Stop},
          {{'M', 10}, Role::OptionalStop},
          {{'M', 20}, Role::End},
          {{'M', 300}, Role::End},
          {{'M', 30}, Role::SpindleForward},
          {{'M', 40}, Role::SpindleBackward},
          {{'M', 50}, Role::SpindleStop},
          {{'M', 60}, Role::ToolChange},
          {{'M', 290}, Role::RigidTapping},
          {{'M', 980}, Role::Call},
          {{'M', 990}, Role::Return},
          {{'G', 650}, Role::MacroCall},
          {{'G', 660}, Role::ModalCall},
          {{'G', 670}, Role::CancelModal}};
}

}  // namespace cncsub
