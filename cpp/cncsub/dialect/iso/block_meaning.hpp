// The meaning of a block's words together: a call, a return, an end, or words only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "cncsub/dialect/iso/block_rules.hpp"
#include "cncsub/dialect/iso/word_scanner.hpp"

namespace cncsub {

/// The G or the M codes that a block executes, in the order written.
class CodeWords {
 public:
  /// Add a code; return false if there is no room for it.
  bool add(const Token& token) {
    if (count_ == words_.size()) return false;
    words_[count_++] = &token;
    return true;
  }
  std::size_t size() const { return count_; }
  const Token& operator[](std::size_t place) const { return *words_[place]; }
  const Token* const* begin() const { return words_.data(); }
  const Token* const* end() const { return words_.data() + count_; }

 private:
  std::array<const Token*, 12> words_{};
  std::size_t count_ = 0;
};

struct BlockMeaning {
  const Token* call = nullptr;  // M98, G65, a calling code ...
  const Token* second_call = nullptr;
  CallKind kind = CallKind::Subprogram;
  CodeCallKind code_kind = CodeCallKind::Subprogram;
  const RegisteredCall* registered = nullptr;
  const Token* back = nullptr;    // M99
  const Token* jump = nullptr;    // M97
  bool jump_reads_input = false;  // M96: Q names the input
  const Token* end = nullptr;     // M02, M30
  const Token* cancel = nullptr;  // G67
  CodeWords g, m;
  const Token* alone_word = nullptr;  // an M code that must be alone
  int m_words = 0;

  bool calls() const { return call != nullptr; }
  bool calls_macro() const { return calls() && is_macro(kind, code_kind); }
  bool calls_subprogram() const { return calls() && !is_macro(kind, code_kind); }
  /// Return whether a G code from `first` to `last` is written.
  bool has_g(double first, double last) const {
    return std::any_of(g.begin(), g.end(), [&](const Token* token) {
      return token->operand.value >= first && token->operand.value <= last;
    });
  }
};

/// The reader that finds the meaning of a block's words, or which of them do not go together.
class MeaningReader {
 public:
  /// `calls`: codes may call programs.
  MeaningReader(const BlockRules& rules, const Tokens& tokens, bool calls, BlockMeaning& meaning)
      : rules_(rules),
        control_(rules.control),
        tokens_(tokens),
        may_call_(calls),
        meaning_(meaning) {}
  std::optional<Fault> read();

 private:
  std::optional<Fault> sort(const Token& token);
  std::optional<Fault> sort_g(const Token& token);
  std::optional<Fault> sort_m(const Token& token);
  void sort_letter(const Token& token);
  bool call_by_role(const Token& token, Role role);
  void call(const Token& token, CallKind kind, CodeCallKind code_kind,
            const RegisteredCall* registered);
  Role role_of_m(const Operand& operand) const;

  bool is_odd(const Token& token) const;
  bool is_bad_in_block(const Token& token) const;
  bool names_by_p() const;
  bool may_take_point(const Token& token) const;
  bool takes_point_here(const Token& token) const;
  bool may_drill() const;
  bool is_length_here(const Token& token) const;

  std::optional<Fault> check_count() const;
  std::optional<Fault> check_together() const;
  std::optional<Fault> check_calls() const;
  std::optional<Fault> check_m_codes() const;
  std::optional<Fault> check_g_codes() const;
  std::optional<Fault> check_corner() const;
  std::optional<Fault> check_call_words() const;
  std::optional<Fault> check_repeated() const;

  const BlockRules& rules_;
  const Control& control_;
  const Tokens& tokens_;
  bool may_call_;
  BlockMeaning& meaning_;
};

/// Return whether H may be an increment of C, which takes a point. The machine that runs the block
/// decides.
inline bool may_be_increment(const Token& token) {
  return token.letter == 'H' && !token.comma && token.wrong == Cause::IllegalDecimalPoint;
}

}  // namespace cncsub
