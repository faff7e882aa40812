// Fuzzes reading: any bytes, as files of the memory and of the external device or as a text typed
// in MDI, become a library on any control, and every question that a library answers is asked.
#include "laws.hpp"

namespace cncsub::fuzz {

namespace {

void check_program(const Code& code, const Program& program) {
  const SourceFile& file = code.files[program.file];
  claim(program.text <= program.text_end && program.text_end <= file.text.size(),
        "a program's text lies in its file");
  claim(program.first <= program.last && program.last < code.blocks.size(),
        "a program's blocks lie in the table");
  claim(code.blocks[program.last].op == Op::EndOfRecord || program.inside >= 0,
        "every program ends that is no part of another");
  std::uint32_t line = program.line;
  for (Address a = program.first; a < program.last; ++a) {
    const Block& block = code.blocks[a];
    claim(block.line >= line, "blocks stand in the order of their lines");
    line = block.line;
    if (block.op == Op::Fault) {
      const Alarm alarm = alarm_of(code, a, code.faults[block.aux]);
      claim(alarm.line >= 1 && alarm.column >= 1, "an alarm has a place");
      claim(!message(alarm).empty(), "an alarm has a message");
    }
    if (block.n >= 0)
      claim(code.first_of(program, block.n) != kNowhere, "a block is found by its number");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Job job = read_job(data, size);
  std::int32_t main = 0;
  const auto code = library_of(job, main);
  check_words(*code);
  for (const Program& program : code->programs) {
    check_program(*code, program);
    const bool external = code->files[program.file].external;
    const std::int32_t by_name = code->find(code->name_of(program), external);
    claim(by_name != kNoProgram || job.texts.mdi.has_value(), "a program is found by its name");
    if (program.number >= 0) code->find(program.number, external);
  }
  return 0;
}

}  // namespace cncsub::fuzz
