// Reads blocks of words: what the text says, by the control's lexical rules, compiled into code.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <unordered_map>
#include <vector>

#include "cncsub/code.hpp"
#include "cncsub/patience.hpp"
#include "cncsub/scan.hpp"

namespace cncsub {

/// What a code calls.
struct RegisteredCall {
  CodeCallKind kind = CodeCallKind::Subprogram;
  std::int32_t program = 0;
  std::int32_t variable = 0;
  bool refused = false;
  bool ascii = false;
};

class BlockReader {
 public:
  BlockReader(Code& code, Patience& patience);
  /// Compiles what stands between the scanner and its end into `block`, whose text and line are
  /// set. Where patience is over, the block is not what its text says.
  void read(Scanner scanner, Block& block);

 private:
  struct Token {
    char letter = 0;        // '/' for a block-skip slash
    bool comma = false;     // ,C
    std::uint8_t axis = 0;  // X1=
    std::uint16_t skip = 0;
    Operand operand;
    std::string_view name;  // <NAME>, P[NAME]
    bool late = false;      // an N behind other words
    bool odd = false;       // a sign, a point or digits that only an argument may have
    Cause wrong{};
  };
  using Tokens = std::vector<Token>;

  void allow_plain();
  bool plain(const Scanner& s, Block& block);
  static void mark_move(Block& block, int g);
  bool head(Scanner& s, Block& block);
  void conditional_return(Scanner s, Block& block);
  void skip_slash(Scanner& s, std::uint16_t& mask);
  bool sequence_number(Scanner& s, Block& block);
  bool scan_words(Scanner& s, Block& block);
  bool scan_value(Scanner& s, Block& block, Token& token);
  bool scan_name(Scanner& s, Block& block, Token& token, char close);
  bool bracket_name(Scanner& s, Block& block, Token& token);
  bool stray(Scanner& s, Block& block);
  std::optional<Fault> check_number(Token& token, const Number& number) const;
  Fault odd_word(const Token& token) const;

  // What the words say. `calls`: codes may call.
  void build(Block& block, const Tokens& tokens, bool calls);
  void build_slash(Block& block, const Tokens& tokens, std::size_t slash, bool calls);
  struct Meaning {
    const Token* call = nullptr;  // M98, G65, a calling code ...
    const Token* second_call = nullptr;
    CallKind kind = CallKind::M98;
    CodeCallKind code_kind = CodeCallKind::Subprogram;
    const RegisteredCall* registered = nullptr;
    const Token* back = nullptr;    // M99
    const Token* jump = nullptr;    // M97
    const Token* end = nullptr;     // M02, M30
    const Token* cancel = nullptr;  // G67
    std::array<const Token*, 12> g{};
    std::array<const Token*, 12> m{};
    int g_count = 0;
    int m_count = 0;
    const Token* lonely = nullptr;  // an M code that wants to be alone
    int m_words = 0;

    bool calls_macro() const { return call != nullptr && is_macro(kind, code_kind); }
  };
  static bool names_by_p(const Meaning& meaning);
  bool takes_point_in_dwell(const Token& token) const;
  bool is_dwell_time(const Token& token, const Meaning& meaning) const;
  static bool may_be_increment(const Token& token);
  bool is_length_here(const Token& token, const Meaning& meaning) const;
  std::optional<Fault> sort(const Tokens& tokens, bool calls, Meaning& meaning) const;
  std::optional<Fault> sort_g(const Token& token, bool calls, Meaning& meaning) const;
  std::optional<Fault> sort_m(const Token& token, bool calls, Meaning& meaning) const;
  const Token* corner_with_call(const Tokens& tokens, const Meaning& meaning) const;
  std::optional<Fault> check_together(const Tokens& tokens, const Meaning& meaning) const;
  void register_calls();
  const RegisteredCall* registered(char address, double code) const;
  bool cut(const Operand& operand) const;
  std::uint32_t cut_word(const Operand& operand, char address);
  void write_words(Block& block, const Tokens& tokens, const Meaning& meaning);
  void build_call(Block& block, const Tokens& tokens, const Meaning& meaning);
  void build_return(Block& block, const Tokens& tokens, const Meaning& meaning);
  void build_jump(Block& block, const Tokens& tokens, const Meaning& meaning);
  void build_h_code(Block& block, const Tokens& tokens, const Meaning& meaning);
  std::optional<Fault> arguments(CallRecord& call, const Tokens& tokens, const Meaning& meaning);
  void refuse(Block& block, Fault fault);

  /// Ten times a written code, as an index into the sets of codes; 10000 where it is none.
  static std::size_t code_index(const Operand& operand);
  static constexpr std::uint8_t kPoint = 1, kMinus = 2, kLength = 4;  // what an address may have

  Code& code_;
  const Control& control_;
  Patience& patience_;
  Tokens tokens_;
  // Whether the block at this place has a call that takes a name.
  const char* call_file_ = nullptr;
  std::uint32_t call_text_ = 0;
  bool names_call_ = false;
  enum class Plain : std::uint8_t { No, Value, G, N };
  std::array<Plain, 256> plain_{};  // what a character begins in a plain block
  std::array<bool, 4> plain_g_{};   // G00 to G03, where they are what they are everywhere
  std::array<std::uint8_t, 256> letters_{};
  std::bitset<10001> not_with_call_, not_with_return_, not_with_macro_, not_with_modal_,
      m_not_with_macro_;
  std::unordered_map<std::int64_t, RegisteredCall> registered_;  // by address and code
  std::vector<RegisteredCall> switches_;                         // addresses whose every code calls
  std::array<int, 26> switched_{};  // 1 + the place there, 0 = the address does not call
  std::int32_t external_m_ = 198;
  std::string corners_not_with_call_;  // the chamfer and corner words that M98 refuses, ",C L"
};

}  // namespace cncsub
