// Reading a library on several cores. The text is cut into jobs: some small files, or lines of a
// large one. A free thread reads the next job into a code of its own. One thread appends the codes
// in the order of the text, and itself reads what cannot be read apart. The result is what one
// thread alone would have made.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/code.hpp"
#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

struct Sharing {
  std::size_t threads = 0;                   // 0: one for each core
  std::size_t piece = std::size_t{1} << 17;  // bytes of a job
};

/// End each line with one line feed. A run of line feeds and carriage returns ends as many lines as
/// it has line feeds, or, if it has none, carriage returns: LF, CR, CR LF, and the LF CR CR that
/// FANUC punches [B-63524EN p.649], are one end each. Blanks replace the rest.
void unify_line_ends(char* at, char* end, InterruptCheck& interrupt);

/// The code that the files go into, and how another code is prepared for a part of them.
struct SharedReading {
  Code& code;
  Builder& to;
  const FileReader& read;
  const Dialect& dialect;
  const ProgramNames& other_mode;  // the programs that are read in the other mode of the language
  const std::function<void(Code&)>& prepare;
};

/// Read the files, which are moved into the code; stop early if an interrupt is requested.
void read_files(const SharedReading& reading, std::vector<SourceFile>& files,
                const Sharing& sharing);

}  // namespace cncsub
