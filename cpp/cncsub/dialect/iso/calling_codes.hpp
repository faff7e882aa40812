// Codes that call programs, as parameters or a rule of the control register them.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// The program that a code calls, and how.
struct RegisteredCall {
  CodeCallKind kind = CodeCallKind::Subprogram;
  std::int32_t program = 0;
  std::int32_t variable = 0;  // takes the code's value, 0 = none
  bool refused = false;       // the code may not call
  bool ascii = false;         // its letter calls because a parameter holds it
  bool by_name = false;       // the program has the name of the code
};

class CallingCodes {
 public:
  explicit CallingCodes(const Code& code);
  /// Return what a code calls; null if it calls nothing.
  const RegisteredCall* find(char address, double code) const;
  /// Return whether every code of an address calls, and the same program.
  bool whole_letter(char address) const { return letters_[place(address)] != 0; }
  /// Return whether any code of an address calls.
  bool any(char address) const;

 private:
  void add_registered(const Code& code, const RegisteredCodes::Entry& entry);
  /// Add a code by its `number` as a parameter holds it: negative if it calls modally.
  void add_code(const Code& code, const CodeCall& list, std::int32_t number, std::int32_t program);
  void add_letter(char address, const RegisteredCall& call);
  static std::size_t place(char address) { return static_cast<std::size_t>(address - 'A'); }
  static constexpr int kAddress = 48;  // the bits of a key below the address
  static std::int64_t key(char address, std::int64_t tenths) {
    return (static_cast<std::int64_t>(address) << kAddress) | tenths;
  }

  /// All codes from one to another, with those between whole numbers.
  struct AllCodes {
    char address;
    double first, behind;
    RegisteredCall call;
  };

  std::vector<AllCodes> all_;
  std::unordered_map<std::int64_t, RegisteredCall> codes_;  // by address and tenths of a code
  std::vector<RegisteredCall> of_letters_;
  std::array<std::size_t, 26> letters_{};  // 1 + the index in of_letters_; 0 = not every code calls
};

}  // namespace cncsub
