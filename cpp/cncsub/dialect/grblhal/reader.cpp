// Files of grblHAL: a file is a program, and its subprograms are parts of it.
#include <algorithm>
#include <memory>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/grblhal/block.hpp"
#include "cncsub/dialect/grblhal/structure.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace grblhal {

namespace {

/// Return the number that G65 and M98 call a file by: P200.macro is 200.
std::int64_t number_of(std::string_view stem) {
  if (stem.size() < 2 || upper(stem.front()) != 'P' || !is_digit(stem[1])) return -1;
  return number_in(stem.substr(1));
}

class FileReader {
 public:
  explicit FileReader(Builder& to) : to_(to), blocks_(to), structure_(to) {
    to_.names().returned();
  }

  void read(std::uint32_t file) {
    const std::string_view text = to_.code().files[file].text.view();
    Program program;
    program.number = number_of(to_.code().files[file].stem);
    program.file = file;
    program.line = 1;
    to_.begin_program(program);
    structure_.begin(file);
    begun_ = tape_ = false;
    std::uint32_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++line;
      const std::string_view said = trimmed(std::string_view(text).substr(at, end - at));
      if (!said.empty()) add(said, static_cast<std::uint32_t>(said.data() - text.data()), line);
      if (to_.interrupt().requested(end + 1 - at)) break;
      at = end + 1;
    }
    if (file > 0 || to_.code().files[file].name.ends_with(".macro"))
      end_of_macro(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
    to_.end_program(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
    structure_.match();
  }

 private:
  void add(std::string_view text, std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    const bool first = !std::exchange(begun_, true);
    if (text == "%") return percent(block, first);
    Flow flow;
    if (!blocks_.read(text, block, flow)) return;
    if (flow.kind == Flow::Kind::ElseIf) {  // the branch before it goes to the end from here
      Block leave = block;
      leave.op = Op::Words;
      leave.aux = 0;
      to_.append(leave);
    }
    structure_.add(flow);
    to_.append(block);
    if (flow.kind == Flow::Kind::Continue) to_.append(block);  // see Structure::next_pass
  }

  /// Let a file that is called return where it ends.
  void end_of_macro(std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    Block back = block;
    to_.words(back, {});
    to_.become(back, Op::Return, CallRecord());
    Statement inside;
    inside.at = at;
    inside.expression = to_.expressions().one({Ins::Level, 0, at, 0}, at, 1);
    inside.then = to_.keep(back);
    to_.become(block, Op::IfThen, inside);
    to_.append(block);
  }

  /// Add a %: it begins the program where it stands first, and ends one that has begun so.
  void percent(Block& block, bool first) {
    if (first) {
      tape_ = true;
      to_.program().opening = block.text + 1;
      return;
    }
    to_.words(block, {});  // without the first one it says nothing [gHg, gc_execute_block]
    if (tape_) block.op = Op::EndProgram;
    to_.append(block);
  }

  Builder& to_;
  BlockReader blocks_;
  Structure structure_;
  bool begun_ = false, tape_ = false;  // a line that is not empty was read; the first was a %
};

}  // namespace

}  // namespace grblhal

FileReader grblhal_reader(Builder& to, const ProgramNames& /*other_mode*/) {
  auto reader = std::make_shared<grblhal::FileReader>(to);
  return [reader](std::uint32_t file) { reader->read(file); };
}

// Null: what a label means depends on the lines before it.
PieceReader (*const grblhal_pieces)(Builder& to) = nullptr;
ProgramNames (*const grblhal_other_mode)(const Code& code) = nullptr;

}  // namespace cncsub
