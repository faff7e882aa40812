// Files of an OSP: a main program, subprograms, or both, each with its name at its head.
#include <algorithm>
#include <memory>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/okuma/block.hpp"
#include "cncsub/dialect/okuma/jumps.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace okuma {

namespace {

/// Return whether a line is the name of a file on a tape, $NAME.MIN%, or the end of one.
bool is_tape(std::string_view said) { return said == "%" || said.front() == '$'; }

/// Return whether a line is the head of a program.
bool is_head(std::string_view said) { return upper(said.front()) == 'O'; }

class FileReader {
 public:
  explicit FileReader(Builder& to) : to_(to), blocks_(to), jumps_(to) {}

  void read(std::uint32_t file) {
    file_ = file;
    const std::string_view text = to_.code().files[file].text.view();
    begun_ = drawing_ = ended_ = false;
    jumps_.begin();
    std::uint32_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++line;
      const std::string_view said = trimmed(text.substr(at, end - at));
      if (!said.empty() && !is_tape(said)) read_line(said, line);
      if (to_.interrupt().requested(end + 1 - at)) break;
      at = end + 1;
    }
    if (!begun_) begin_program({}, 1);
    to_.end_program(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
    jumps_.resolve();
  }

 private:
  std::uint32_t place_of(std::string_view text) const {
    return static_cast<std::uint32_t>(text.data() - to_.code().files[file_].text.view().data());
  }

  void read_line(std::string_view said, std::uint32_t line) {
    if (is_head(said)) return read_head(said, line);
    if (!begun_) {
      Line look;
      look.set(said, 0);
      if (look.at_end() && !look.has_open_comment()) return;
      begin_program({}, line);
    }
    Block block = block_of(said, line);
    if (drawing_ || begins_drawing(said)) {
      drawing_ = !ends_drawing(said);
      to_.drop(block.text, static_cast<std::uint32_t>(said.size()));
      to_.words(block, {});
      to_.append(block);
      return;
    }
    add(said, block);
  }

  static std::uint16_t length_of(std::string_view text) {
    return static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
  }

  Block block_of(std::string_view said, std::uint32_t line) const {
    Block block;
    block.text = place_of(said);
    block.line = line;
    block.length = length_of(said);
    return block;
  }

  void add(std::string_view text, Block block) {
    std::string name;
    Jump jump;
    if (!blocks_.read(text, block, name, jump)) return;
    jumps_.add(name, jump);
    to_.append(block);
    ended_ = block.skip == 0 &&
             (block.op == Op::EndProgram || block.op == Op::Return || block.op == Op::Goto);
  }

  /// Begin the program of a head: O100, or OSUB (a comment).
  void read_head(std::string_view said, std::uint32_t line) {
    if (begun_) {
      if (!ended_) refuse_run(said, line);
      to_.end_program(place_of(said), line);
    }
    const std::string_view name = name_in(said);
    begin_program(said.substr(0, name.size()), line);
    drawing_ = ended_ = false;
    if (name.size() < 2 || name.size() > 1 + kLongestProgram) return refuse_name(said, line);
    const std::string_view rest = trimmed(said.substr(name.size()));
    if (!rest.empty()) add(rest, block_of(rest, line));
  }

  /// Refuse the head of a program where a run comes to it from the program before. [OKA 2290]
  void refuse_run(std::string_view said, std::uint32_t line) {
    Block block = block_of(said, line);
    const auto width = static_cast<std::uint32_t>(name_in(said).size());
    to_.refuse(block, Fault{.cause = Cause::EndOfRecord,
                            .at = block.text,
                            .width = width,
                            .detail = "the run comes to the head of another program",
                            .kind = kOtherName});
    to_.append(block);
  }

  void refuse_name(std::string_view said, std::uint32_t line) {
    Block block = block_of(said, line);
    const auto width = static_cast<std::uint32_t>(name_in(said).size());
    Fault fault{Cause::IllegalProgramName, block.text, width,
                "a name is O and 1 to 4 letters or digits"};
    if (width > 1 + kLongestProgram) fault.kind = kTooLong;
    to_.refuse(block, std::move(fault));
    to_.append(block);
  }

  void begin_program(std::string_view name, std::uint32_t line) {
    Program program;
    program.file = file_;
    program.line = line;
    if (!name.empty()) {
      program.text = program.name_at = place_of(name);
      program.name_length = static_cast<std::uint32_t>(name.size());
    }
    to_.begin_program(program);
    begun_ = true;
  }

  Builder& to_;
  BlockReader blocks_;
  Jumps jumps_;
  std::uint32_t file_ = 0;
  bool begun_ = false;
  bool drawing_ = false;  // between DEF and END
  bool ended_ = false;    // no run goes on after the last block
};

}  // namespace

}  // namespace okuma

FileReader okuma_reader(Builder& to, const ProgramNames& /*other_mode*/) {
  auto reader = std::make_shared<okuma::FileReader>(to);
  return [reader](std::uint32_t file) { reader->read(file); };
}

// Null: a jump goes to a block of any line.
PieceReader (*const okuma_pieces)(Builder& to) = nullptr;
ProgramNames (*const okuma_other_mode)(const Code& code) = nullptr;

}  // namespace cncsub
