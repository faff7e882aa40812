// Many threads on one library at once. Each runs it with its own options, types in MDI, copies one
// machine and reads one finished run, and gets what one thread alone gets. Many threads also read
// one text. Built with the thread sanitizer, this also shows that no two of them touch the same
// data.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "cncsub/dialect/library.hpp"
#include "cncsub/machine/machine.hpp"
#include "cncsub/text/words.hpp"

namespace {

using namespace cncsub;

constexpr int kThreads = 16;
constexpr int kRounds = 20;

constexpr const char* kProgram = R"(O1
N10 G21 G54 G0 X0 Z5.
N20 M98 P2 L3
N30 G65 P3 A1. B#100
/N40 G1 X5. F200
/3 N50 #101=#101+10
N60 #102=SIN[30]+SQRT[#101]
#5221=#100
N70 G2 X10. Z-5. R5. F100
N80 M1
N90 WHILE[#103 LT 20]DO1
#103=#103+1
G1 X#103 Z-#103
END1
N100 M98 P9
N110 M30
O2
N210 #101=#101+#100
N220 G1 X[#101/10] Z-1. F150
N230 M99
O3
N310 G66 P4 A#1
N320 G0 X#2
N330 G67
N340 M99
O4
N410 #104=#104+#1
N420 M99
)";

Options options_of(int number) {
  Options options;
  options.max_blocks = 100 + 40 * (number % 4);
  options.trace = static_cast<Trace::Depth>(number % 2 == 0 ? 3 : number % 4);
  options.optional_stop = number % 3 == 0;
  options.skips = static_cast<std::uint16_t>((number & 3) << 1 | (number & 4) << 1);
  options.variables[100] = number;
  options.setup.start['X'] = number;
  options.setup.work_offsets["G54"]['Z'] = -number;
  options.setup.length_offsets[1] = number;
  options.inputs.operator_given = number % 5 == 0;
  return options;
}

/// Return the outcome of a run as one text.
std::string outcome(const Machine& machine) {
  std::string text(to_string(machine.stop()));
  text +=
      ' ' + std::to_string(machine.blocks()) + ' ' + std::to_string(machine.trace().calls.size());
  if (machine.alarm()) text += ' ' + message(*machine.alarm());
  for (const auto& [number, value] : machine.variables(0))
    text += " #" + std::to_string(number) + '=' + std::to_string(value);
  for (const auto& [axis, value] : position(machine.motion().view()))
    text += ' ' + axis + std::to_string(value);
  for (const auto& [group, code] : modal(machine.motion().view())) text += ' ' + group + ' ' + code;
  const Moves& moves = machine.trace().moves;
  text += ' ' + std::to_string(moves.size()) + ' ' + std::to_string(moves.time());
  return text;
}

std::string run(const std::shared_ptr<const Code>& code, int number) {
  Machine machine(code, 0, options_of(number));
  machine.run({});
  return outcome(machine);
}

std::string type_in(const Code& code, int number) {
  const auto with = compile_mdi(code, "M98 P2 L" + std::to_string(number % 3 + 1));
  Options options = options_of(number);
  options.mdi = true;
  Machine machine(with, static_cast<std::int32_t>(with->programs.size() - 1), options);
  machine.run({});
  return outcome(machine);
}

std::string go_on(const Machine& half_way) {
  Machine copy = half_way;
  copy.run({});
  copy.reset();
  while (copy.step()) {
  }
  return outcome(copy);
}

std::string read(const Machine& finished) {
  std::vector<double> x(finished.trace().moves.size());
  finished.trace().moves.columns({"mx"}, {x.data()});
  std::string text = outcome(finished);
  for (const double value : x) text += ' ' + std::to_string(value);
  const auto& arguments = finished.trace().arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    text += " #" + std::to_string(arguments[i].variable) + '=' + std::to_string(arguments[i].value);
  const Code& code = finished.code();
  for (const Program& program : code.programs)
    for (Address a = program.first; a < program.last; ++a)
      for (const WrittenWord& word :
           written_words(code.read_word, code.text_of(code.blocks[a], program)))
        text += word.text;
  return text;
}

/// A library and the machines that the threads share.
struct Shared {
  std::shared_ptr<const Code> code;
  Machine half_way, finished;

  explicit Shared(const Control& control)
      : code(compile(std::make_shared<const Control>(control),
                     {{"O1", "O1", FileText(kProgram), false}}, false)),
        half_way(code, 0, options_of(2)),
        finished(code, 0, options_of(2)) {
    for (int i = 0; i < 10; ++i) half_way.step();
    finished.run({});
  }

  std::vector<std::string> everything(int number) const {
    return {run(code, number), type_in(*code, number), go_on(half_way), read(finished)};
  }
};

/// Return the programs as several threads read them, in pieces of `piece` bytes, as one text.
std::string read_by(const Control& control, std::size_t threads, std::size_t piece) {
  std::string large;
  for (int i = 0; i < 20; ++i) large += kProgram;
  std::vector<SourceFile> files{{"large", "large", FileText(large), false}};
  for (int i = 0; i < 20; ++i)
    files.push_back({std::to_string(i), "", FileText(kProgram), i % 2 == 0});
  Sharing sharing;
  sharing.threads = threads;
  sharing.piece = piece;
  const auto code =
      compile(std::make_shared<const Control>(control), std::move(files), true, {}, sharing);
  std::string text = run(code, 0) + run(code, 3);
  for (const Program& program : code->programs) {
    text += ' ' + code->name_of(program) + ' ' + std::to_string(program.line);
    for (Address a = program.first; a < program.last; ++a)
      text += ' ' + std::to_string(code->blocks[a].line) + ':' + std::to_string(code->blocks[a].n);
  }
  return text;
}

/// Return how many ways of sharing the reading give other programs than one thread does.
int reads_wrong(const Control& control) {
  const std::string alone = read_by(control, 1, 1);
  int wrong = 0;
  for (const std::size_t threads : {2, 5})
    for (const std::size_t piece : {1, 100, 700})
      if (read_by(control, threads, piece) != alone) ++wrong;
  return wrong;
}

}  // namespace

int main() {
  std::atomic<int> wrong = 0;
  for (const Control& control : all_controls()) {
    wrong += reads_wrong(control);
    const Shared shared(control);
    std::vector<std::vector<std::string>> alone;
    for (int number = 0; number < kThreads; ++number) alone.push_back(shared.everything(number));
    std::vector<std::thread> threads;
    for (int number = 0; number < kThreads; ++number)
      threads.emplace_back([&, number] {
        for (int round = 0; round < kRounds; ++round)
          if (shared.everything(number) != alone[static_cast<std::size_t>(number)]) ++wrong;
      });
    for (std::thread& thread : threads) thread.join();
  }
  std::printf("%zu controls, %d threads, %d rounds each: %d runs differ from those of one thread\n",
              all_controls().size(), kThreads, kRounds, wrong.load());
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
