#include "generator.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

namespace cncsub::fuzz {

namespace {

constexpr std::size_t kMostLines = 60;

/// A writer of the texts of one program.
class Writer {
 public:
  Writer(std::uint64_t seed, const std::vector<std::string>& lines)
      : random_(seed), lines_(lines) {}

  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
  bool chance(int percent) { return below(100) < static_cast<std::size_t>(percent); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
  template <class List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }

  std::string number() {
    const std::size_t kind = below(100);
    const std::string sign = chance(35) ? "-" : "";
    if (kind < 35) return sign + std::to_string(below(60)) + ".";
    if (kind < 55) return sign + std::to_string(below(90)) + "." + std::to_string(below(1000));
    if (kind < 68) return sign + std::to_string(below(12));
    if (kind < 78) return sign + std::to_string(below(20'000));
    if (kind < 88) return sign + "#" + std::to_string(100 + below(6));
    if (kind < 92) return "[" + expression(2) + "]";
    return edge();
  }

  /// Return a number at the edge of a type, of the controls' digits or of sense.
  std::string edge() {
    static constexpr std::array<const char*, 36> kEdges = {
        "0",          "-0",         "0.",          "-0.0",        "0.001",
        "-0.001",     "0.0004",     "0.0001",      "0.000000001", "1",
        "99",         "100",        "127",         "128",         "255",
        "256",        "9999",       "10000",       "32767",       "32768",
        "65536",      "99999.999",  "-99999.999",  "99999999",    "-99999999",
        "999999999",  "999999.999", "2147483647",  "2147483648",  "-2147483649",
        "4294967295", "4294967296", "99999999999", "9999999999.", "999999999999999999999",
        "90.0000001"};
    if (chance(3)) return std::string(400, '9');
    return one_of(kEdges);
  }

  std::string expression(int depth) {
    static constexpr std::array<const char*, 14> kFunctions = {
        "SIN",   "COS", "TAN", "ASIN", "ACOS", "SQRT", "ABS",
        "ROUND", "FIX", "FUP", "LN",   "EXP",  "BIN",  "BCD"};
    static constexpr std::array<const char*, 9> kOperators = {"+", "-", "*", "/",    " MOD ",
                                                              "*", "*", "/", " AND "};
    if (depth == 0 || chance(40))
      return chance(50)   ? "#" + std::to_string(chance(70) ? 100 + below(6) : below(34))
             : chance(80) ? std::to_string(below(400)) + "."
                          : edge();
    if (chance(25)) return std::string(one_of(kFunctions)) + "[" + expression(depth - 1) + "]";
    return expression(depth - 1) + one_of(kOperators) + "[" + expression(depth - 1) + "]";
  }

  std::string word(char letter) { return letter + number(); }

  /// Return some of these letters, each with a number.
  std::string some(std::string_view letters, int percent) {
    std::string text;
    for (const char letter : letters)
      if (chance(percent)) text += ' ' + word(letter);
    return text;
  }

  std::string move() {
    static constexpr std::array<const char*, 9> kCodes = {"G0", "G1", "G1", "G1", "G2",
                                                          "G3", "",   "G1", "G33"};
    const std::string code = one_of(kCodes);
    const bool round = code == "G2" || code == "G3";
    return code + some(chance(70) ? "XYZ" : "XYZUVWABC", 50) + (round ? some("IJKR", 45) : "") +
           (chance(35) ? " F" + std::to_string(below(500)) : "");
  }

  std::string code() {
    static constexpr std::array<const char*, 104> kCodes = {
        "0",  "1",  "2",  "3",    "4",    "5",    "6.2", "7",  "9",  "10",  "11",   "12",   "13",
        "15", "16", "17", "18",   "19",   "20",   "21",  "22", "23", "24",  "25",   "26",   "27",
        "28", "29", "30", "31",   "32",   "33",   "34",  "36", "37", "38",  "39",   "40",   "41",
        "42", "43", "44", "45",   "46",   "47",   "48",  "49", "50", "51",  "50.1", "51.1", "52",
        "53", "54", "55", "56",   "59",   "54.1", "60",  "61", "62", "63",  "64",   "65",   "66",
        "67", "68", "69", "68.1", "69.1", "70",   "71",  "72", "73", "74",  "75",   "76",   "77",
        "78", "79", "80", "81",   "82",   "83",   "84",  "85", "86", "87",  "88",   "89",   "90",
        "91", "92", "93", "94",   "95",   "96",   "97",  "98", "99", "110", "115",  "12.1", "13.1"};
    return "G" + std::string(one_of(kCodes));
  }

  std::string any_block() {
    static constexpr std::array<const char*, 16> kM = {
        "0", "1", "2", "3", "4", "5", "6", "8", "19", "29", "30", "97", "98", "99", "198", "17"};
    std::string text;
    for (std::size_t left = below(3); left > 0; --left) text += code() + ' ';
    text += some("XYZABCUVWIJKRPQLFSTHDE", 18);
    if (chance(25)) text += " M" + std::string(one_of(kM));
    if (chance(6)) text += " G" + number();
    if (chance(4)) text += " M" + number();
    return text;
  }

  std::string cycle() {
    static constexpr std::array<const char*, 24> kCycles = {
        "73", "74", "76", "81", "82", "83", "84", "85", "86", "87", "88", "89",
        "90", "92", "94", "77", "78", "79", "70", "71", "72", "75", "33", "34"};
    std::string text = (chance(30) ? (chance(50) ? "G98 " : "G99 ") : "");
    text += "G" + std::string(one_of(kCycles)) + some("XYZ", 70) + some("RQPF", 55);
    return text + some("KLIJDUWACEHBS", 15);
  }

  /// Write G71 to G73 with their profile, and G70.
  void rough() {
    const std::string code = "G" + std::to_string(71 + below(3));
    const std::size_t first = 100 + 10 * below(4), last = first + 90;
    line(code + some("UWR", 75));
    line(code + " P" + std::to_string(first) + " Q" + std::to_string(last) + some("UWF", 65) +
         some("DIKR", 8));
    lines_out_.push_back("N" + std::to_string(first) + " " + (chance(60) ? "G0" : "G1") +
                         some("XZ", 80));
    for (std::size_t left = below(6); left > 0; --left)
      line(chance(80) ? "G1" + some("XZUW", 50) + corner() : move());
    lines_out_.push_back("N" + std::to_string(last) + " G1" + some("XZ", 80));
    if (chance(40)) line("G70 P" + std::to_string(first) + " Q" + std::to_string(last));
  }

  std::string corner() {
    if (!chance(25)) return "";
    static constexpr std::array<const char*, 8> kCorners = {" ,C", " ,R", " ,A", " R",
                                                            " C",  " A",  " L",  " D"};
    return one_of(kCorners) + number();
  }

  /// Write a contour with radius compensation.
  void contour() {
    line(std::string(chance(50) ? "G41" : "G42") + (chance(70) ? " D1" : "") +
         (chance(80) ? " G1" : "") + some("XYZ", 55) + " F100");
    for (std::size_t left = 1 + below(7); left > 0; --left)
      line(chance(15) ? "G1 Z" + number() : chance(15) ? any_block() : move() + corner());
    if (chance(80)) line("G40" + some("XYZ", 50));
  }

  std::string data() {
    switch (below(12)) {
      case 0:
        return "G10 L" + (chance(70) ? std::string("2") : number()) + " P" + number() +
               some("XYZUWRQ", 40);
      case 1:
        return "G10 P" + number() + some("XZUWRQ", 50);
      case 2:
        return "G52" + some("XYZ", 60);
      case 3:
        return "G92" + some("XYZS", 60);
      case 4:
        return "G50" + some("XZUWS", 50);
      case 5:
        return std::string(chance(70) ? "G68" : "G69") + some("XYZR", 60);
      case 6:
        return std::string(chance(75) ? "G51" : "G50") + some("XYZPIJK", 45);
      case 7:
        return std::string(chance(50) ? "G16" : "G15");
      case 8:
        return std::string(chance(75) ? "G43" : "G49") + " H1" + some("Z", 60);
      case 9:
        return "T" + (chance(70) ? std::string("0101") : number());
      case 10:
        return std::string(chance(50) ? "G96 S" : "G97 S") + number();
      default:
        return "G" + std::to_string(54 + below(6)) + some("XYZ", 40);
    }
  }

  std::string macro() {
    const std::string n = std::to_string(10 * (1 + below(14)));
    switch (below(14)) {
      case 0:
        return "G65 P" + std::to_string(2 + below(3)) + some("ABCDEFHIJKQRSTUVWXYZL", 25);
      case 1:
        return "G66 P" + std::to_string(2 + below(3)) + some("ABCIJK", 25);
      case 2:
        return chance(60) ? "G67" : "G66.1 P3" + some("ABC", 30);
      case 3:
        return "M98 P" + std::to_string(2 + below(3)) + (chance(40) ? " L" + number() : "");
      case 4:
        return "M98 P" + number() + some("LQH", 20);
      case 5:
        return "IF[" + expression(1) + (chance(50) ? " LT " : " EQ ") + expression(1) + "]GOTO" + n;
      case 6:
        return "IF[" + expression(1) + " GT " + expression(1) + "]THEN #101=" + expression(2);
      case 7:
        return "GOTO " + n;
      case 8:
        return "#[" + expression(1) + "]=" + expression(2);
      case 9:
        return "#" + std::to_string(1000 + below(9000)) + "=" + expression(2);
      case 10:
        return "G65 H" + (chance(70) ? std::to_string(below(100)) : number()) + " P#101 Q" +
               number() + " R" + number();
      case 11:
        return chance(50) ? "DPRNT[X#100[53]Y#101[08]]" : "#3006=1(LOOK)";
      case 12:
        return chance(30) ? "#3000=" + number() + "(STOP)" : "M99 P" + n;
      default:
        return "#" + std::to_string(100 + below(6)) + "=" + expression(3);
    }
  }

  void loop() {
    line("#1=0");
    line("WHILE[#1 LT " + std::to_string(below(6)) + "]DO1");
    line("#1=#1+1");
    for (std::size_t left = 1 + below(3); left > 0; --left) line(chance(60) ? move() : macro());
    line("END1");
  }

  void line(const std::string& text) {
    const bool numbered = chance(50);
    if (numbered) next_n_ += 10;
    lines_out_.push_back((chance(2) ? "/" : "") +
                         (numbered ? "N" + std::to_string(next_n_) + " " : "") + text);
  }

  void some_lines(std::size_t most) {
    const std::size_t from = lines_out_.size();
    while (lines_out_.size() < from + most) {
      const std::size_t kind = below(100);
      if (kind < 30)
        line(move() + corner());
      else if (kind < 42)
        line(cycle());
      else if (kind < 52)
        line(any_block());
      else if (kind < 62)
        line(data());
      else if (kind < 78)
        line(macro());
      else if (kind < 84)
        rough();
      else if (kind < 90)
        contour();
      else if (kind < 93)
        loop();
      else
        lines_out_.push_back(one_of(lines_));
    }
  }

  std::string program(bool percent) {
    const std::string head = percent ? "%" : "O";
    std::string text;
    for (int number = 1; number <= 4; ++number) {
      next_n_ = 0;
      lines_out_ = {head + std::to_string(number)};
      if (number == 1 && chance(60)) lines_out_.push_back("G0 X50. Z20. F100 S500 M3");
      some_lines(number == 1 ? 1 + below(24) : 1 + below(4));
      if (chance(95)) lines_out_.push_back(number == 1 && chance(85) ? "M30" : "M99");
      text += joined();
    }
    return text;
  }

  std::string joined() const {
    std::string text;
    for (const std::string& one : lines_out_) text += one + '\n';
    return text;
  }

  /// Return a text with words, blocks and numbers changed.
  std::string mutated(const std::string& text) {
    lines_out_.clear();
    for (std::size_t at = 0; at < text.size() && lines_out_.size() < kMostLines;) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      lines_out_.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    for (std::size_t left = 1 + below(5); left > 0 && !lines_out_.empty(); --left) {
      const std::size_t at = below(lines_out_.size());
      std::string& chosen = lines_out_[at];
      switch (below(9)) {
        case 0:
        case 1:
        case 2:
          replace_number(chosen);
          break;
        case 3:
          chosen += some("XYZUVWIJKRPQLFSTHDABC", 12);
          break;
        case 4:
          lines_out_.insert(lines_out_.begin() + static_cast<std::ptrdiff_t>(at), one_of(lines_));
          break;
        case 5:
          lines_out_.erase(lines_out_.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        case 6:
          std::swap(chosen, lines_out_[below(lines_out_.size())]);
          break;
        case 7: {
          const std::string added = chance(50) ? any_block() : chance(50) ? data() : move();
          lines_out_.insert(lines_out_.begin() + static_cast<std::ptrdiff_t>(at) + 1, added);
          break;
        }
        default:
          chosen += ' ' + (chance(50) ? code() : macro());
          break;
      }
    }
    return joined();
  }

 private:
  void replace_number(std::string& text) {
    std::vector<std::size_t> places;
    for (std::size_t i = 1; i < text.size(); ++i) {
      const auto digit = [&](std::size_t k) {
        return (text[k] >= '0' && text[k] <= '9') || text[k] == '-' || text[k] == '.';
      };
      if (digit(i) && !digit(i - 1)) places.push_back(i);
    }
    if (places.empty()) return;
    const std::size_t from = one_of(places);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.-", from), text.size());
    text.replace(from, end - from, number());
  }

  std::mt19937_64 random_;
  const std::vector<std::string>& lines_;
  std::vector<std::string> lines_out_;
  std::size_t next_n_ = 0;
};

/// Return zero points, tools and offsets as people have them.
Setup usual_setup(Writer& writer) {
  static constexpr std::array<const char*, 5> kMachines = {"", "", "mill", "lathe-a", "lathe-b"};
  const auto length = [&] { return (static_cast<double>(writer.below(40'000)) - 20'000) / 1000; };
  Setup setup;
  setup.machine = writer.one_of(kMachines);
  if (writer.chance(60)) setup.start = {{'X', 60 + length()}, {'Z', 40 + length()}};
  if (writer.chance(40)) setup.work_offsets["G54"] = {{'X', length()}, {'Y', length()}};
  if (writer.chance(20)) setup.work_offsets["EXT"] = {{'Z', length()}};
  if (writer.chance(60)) setup.radius_offsets[1] = length() / 4;
  if (writer.chance(50)) setup.length_offsets[1] = length();
  if (writer.chance(60))
    setup.tools[1] = {{{{'X', length()}, {'Z', length()}},
                       static_cast<int>(writer.below(10)),
                       std::abs(length()) / 10},
                      "MILL",
                      {}};
  if (writer.chance(20)) setup.reference[1] = {{'X', length()}, {'Z', length()}};
  if (writer.chance(10))
    for (const char axis : {'X', 'Y', 'Z'}) setup.limits[axis] = {-200, 200};
  return setup;
}

}  // namespace

Generator::Generator(std::vector<std::vector<std::uint8_t>> seeds) : seeds_(std::move(seeds)) {
  for (const auto& seed : seeds_)
    for (const SourceFile& file : run_job(seed.data(), seed.size()).texts.files)
      for (std::size_t at = 0; at < file.text.size();) {
        const std::string_view text = file.text.view();
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (end - at > 3 && end - at < 200) lines_.emplace_back(text.substr(at, end - at));
        at = end + 1;
      }
  if (lines_.empty()) lines_.emplace_back("G1 X1.");
}

Job Generator::make(std::uint64_t seed, std::uint64_t number) const {
  Writer writer(seed * 0x9e3779b97f4a7c15u + number, lines_);
  Job job;
  const bool from_seed = !seeds_.empty() && writer.chance(45);
  if (from_seed) {
    const auto& bytes = writer.one_of(seeds_);
    job = run_job(bytes.data(), bytes.size());
  }
  if (!from_seed || writer.chance(25)) {  // another control, other options
    std::vector<std::uint8_t> around(400);
    for (std::uint8_t& byte : around) byte = writer.byte();
    if (writer.chance(70)) around.back() &= 0x1f;  // only the control
    Job other = job_around(around.data(), around.size());
    other.texts = std::move(job.texts);
    job = std::move(other);
    if (writer.chance(70)) job.options.setup = usual_setup(writer);
    if (writer.chance(50))
      job.options.variables = {{100, 3}, {101, -2.5}, {102, 0.001}, {103, 1e6}};
  }
  job.options.max_blocks = std::min<std::int64_t>(job.options.max_blocks, 300);
  job.copied_after = writer.below(12);
  job.options.mdi = job.options.mdi || (from_seed && job.texts.mdi.has_value());
  if (!from_seed) {
    job.texts = {};
    job.texts.files.push_back({"F1", "F1",
                               FileText(writer.program(job.control->reading.program_heads.value.has(
                                   ProgramHead::Percent))),
                               false});
    return job;
  }
  for (SourceFile& file : job.texts.files)
    file.text = FileText(writer.mutated(std::string(file.text.view())));
  if (job.texts.mdi) job.texts.mdi = writer.mutated(*job.texts.mdi);
  return job;
}

}  // namespace cncsub::fuzz
