// Files of a SINUMERIK: a file is one program, or several in punched tape format.
#include <algorithm>
#include <memory>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/sinumerik/block.hpp"
#include "cncsub/dialect/sinumerik/structure.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace sinumerik {

namespace {

class FileReader {
 public:
  explicit FileReader(Builder& to) : to_(to), blocks_(to), structure_(to) {}

  void read(std::uint32_t file) {
    const std::string_view text = to_.code().files[file].text.view();
    bool begun = false;
    std::uint32_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++line;
      const std::string_view said = trimmed(std::string_view(text).substr(at, end - at));
      const auto place = static_cast<std::uint32_t>(said.data() - text.data());
      const bool head = said.starts_with('%');
      if (head || (!begun && !said.empty() && said[0] != ';')) {
        if (begun) end_program(place, line);
        begin_program(file, line, head ? said : std::string_view(), place);
        begun = true;
      }
      if (!head && begun && !said.empty()) add(said, place, line);
      if (to_.interrupt().requested(end + 1 - at)) break;
      at = end + 1;
    }
    if (!begun) begin_program(file, 1, {}, 0);
    end_program(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
  }

 private:
  /// Begin a program: %_N_SHAFT_MPF is SHAFT. Without a head the file gives the name. [SONE p.43]
  void begin_program(std::uint32_t file, std::uint32_t line, std::string_view head,
                     std::uint32_t at) {
    Program program;
    program.file = file;
    program.line = line;
    program.text = at;
    std::string_view rest;
    if (!head.empty()) {
      const std::string_view said = trimmed(head.substr(1));
      const std::size_t before = said.starts_with("_N_") || said.starts_with("_n_") ? 3 : 0;
      std::string_view name = said.substr(before, name_in(said.substr(before)).size());
      rest = trimmed(said.substr(before + name.size()));
      const std::string capital = capitals(name);
      if (capital.ends_with("_MPF") || capital.ends_with("_SPF")) name.remove_suffix(4);
      program.name_at = at + static_cast<std::uint32_t>(name.data() - head.data());
      program.name_length = static_cast<std::uint32_t>(name.size());
    }
    to_.begin_program(program);
    structure_.begin();
    blocks_.begin_program();
    if (!rest.empty() && rest[0] != ';')
      drop(rest, at + static_cast<std::uint32_t>(rest.data() - head.data()), line);
  }

  void end_program(std::uint32_t text_end, std::uint32_t line) {
    to_.end_program(text_end, line);
    structure_.match();
  }

  /// Add a block that says what of the head is no name: the control reads it and does not obey it.
  void drop(std::string_view text, std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    to_.drop(at, static_cast<std::uint32_t>(text.size()));
    to_.words(block, {});
    to_.append(block);
  }

  void add(std::string_view text, std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    std::string label;
    Link link;
    if (!blocks_.read(text, block, label, link)) return;
    structure_.add(label, link);
    to_.append(block);
  }

  Builder& to_;
  BlockReader blocks_;
  Structure structure_;
};

}  // namespace

}  // namespace sinumerik

FileReader sinumerik_reader(Builder& to) {
  auto reader = std::make_shared<sinumerik::FileReader>(to);
  return [reader](std::uint32_t file) { reader->read(file); };
}

// Null: what a label means depends on the blocks before it.
PieceReader (*const sinumerik_pieces)(Builder& to) = nullptr;

}  // namespace cncsub
