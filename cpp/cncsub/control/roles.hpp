// What the codes of a control are to the order of its blocks: which one calls, returns, ends.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/codes.hpp"
#include "cncsub/text/literal.hpp"

namespace cncsub {

/// What a code is to the order of blocks; `None`: nothing.
enum class Role : std::uint8_t {
#define ROLE(name, slug, example, words, causes) name,
#include "cncsub/control/roles.def"
#undef ROLE
};

std::string_view to_string(Role role);
/// Return the role of a slug; `None` where there is none.
Role role_of(std::string_view slug);
/// Return the roles by their slugs, in order, without `None`.
std::vector<std::string_view> role_names();

/// A G or an M code, ten times its number. A literal such as "G66.1" is checked when it is
/// compiled.
struct CodeName {
  char letter = 'M';
  int tenfold = 0;

  constexpr CodeName() = default;
  constexpr CodeName(char of_letter, int ten_times) : letter(of_letter), tenfold(ten_times) {}
  consteval CodeName(const char* literal) {  // NOLINT(misc-explicit-constructor)
    const std::optional<CodeName> code = read(literal);
    code ? void(*this = *code) : literal_is_wrong();
  }

  /// Read M98 or G66.1; nothing where the text is none.
  static constexpr std::optional<CodeName> read(std::string_view text) {
    if (text.empty() || (text[0] != 'G' && text[0] != 'M')) return std::nullopt;
    const std::optional<int> tenfold = read_code(text.substr(1));
    if (!tenfold || (text[0] == 'M' && *tenfold % 10 != 0)) return std::nullopt;
    return CodeName(text[0], *tenfold);
  }
  std::string text() const;
  auto operator<=>(const CodeName&) const = default;
};

/// The role of each code.
class Roles {
 public:
  struct Entry {
    CodeName code;
    Role role = Role::None;
    bool operator==(const Entry&) const = default;
  };

  Roles() = default;
  Roles(std::initializer_list<Entry> entries) {
    for (const Entry& entry : entries) set(entry.code, entry.role);
  }

  Role of(CodeName code) const {
    return code.letter == 'M' ? of_m(code.tenfold / 10) : of_g(code.tenfold);
  }
  Role of_m(int m) const {
    return m >= 0 && m < kCodes ? m_[static_cast<std::size_t>(m)] : Role::None;
  }
  Role of_g(int tenfold) const;
  /// Give a code a role; `None` takes it away.
  void set(CodeName code, Role role);
  /// Return the first code of a role, where there is one.
  std::optional<CodeName> code_of(Role role) const;
  bool has(Role role) const { return code_of(role).has_value(); }
  /// Return the codes that have a role, by letter and number.
  std::vector<Entry> entries() const;
  bool operator==(const Roles&) const = default;

 private:
  static constexpr int kCodes = 1000;

  std::array<Role, kCodes> m_{};
  std::vector<Entry> g_;  // by code; they are few
};

/// Return whether an M code without a role is one that calls, returns or jumps on other controls.
bool calls_elsewhere(const Roles& roles, int m);

/// Return the roles that a family has where a control's file says nothing.
Roles family_roles();

}  // namespace cncsub
