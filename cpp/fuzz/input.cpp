#include "input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>

#include "cncsub/dialect/library.hpp"

namespace cncsub::fuzz {

namespace {

constexpr double kSetupLimit = 999'999'999;  // the package accepts no larger number

/// A reader of bytes from the end backwards.
class Reader {
 public:
  Reader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::uint8_t byte() { return left_ == 0 ? 0 : data_[--left_]; }

  template <class T>
  T whole() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t{byte()} << (8 * i);
    return static_cast<T>(value);
  }

  /// Return a number as programs and people write it, a special one, or one of any bits.
  double number() {
    static constexpr std::array kSpecial = {0.0,   1.0,  -1.0,  0.5,   0.001, 1e-9,  90.0,
                                            360.0, 25.4, 9999., 1e6,   1e8,   -1e15, 1e47,
                                            1e300, -0.0, 2e9,   -1e-9, 1e9,   0.0004};
    switch (byte() % 8) {
      case 0:
        return kVacant;
      case 1:
        return whole<std::int8_t>();
      case 2:
        return whole<std::int16_t>();
      case 3:
        return whole<std::int16_t>() / 1000.0;
      case 4:
        return whole<std::int32_t>();
      case 5:
        return whole<std::int32_t>() / 1000.0;
      case 6:
        return kSpecial[byte() % kSpecial.size()];
      default: {
        const auto bits = whole<std::uint64_t>();
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
    }
  }

  // Return the same, as far as the package lets it through.
  double finite() {
    const double value = number();
    return std::isfinite(value) ? value : 0;
  }
  double value() {
    const double value = number();
    return std::isinf(value) ? kVacant : value;
  }
  double length() { return std::clamp(finite(), -kSetupLimit, kSetupLimit); }
  double positive() {
    const double value = std::fabs(length());
    return value >= 1e-9 ? value : 1;
  }
  std::int32_t variable() { return whole<std::int32_t>() & 0x7fffffff; }
  int numbered() { return whole<std::uint16_t>() % 1000; }

  template <class Read>
  void list(std::size_t most, Read&& read) {
    for (std::size_t left = byte() % (most + 1); left > 0; --left) read();
  }

  std::size_t left() const { return left_; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

std::shared_ptr<const Control> control_at(std::uint8_t number) {
  static const std::vector<std::shared_ptr<const Control>> kControls = [] {
    std::vector<std::shared_ptr<const Control>> list;
    for (const Control& control : all_controls())
      list.push_back(std::make_shared<const Control>(control));
    return list;
  }();
  return kControls[number % kControls.size()];
}

std::int64_t rule_number(Reader& in) {
  return std::clamp<std::int64_t>(in.whole<std::int32_t>(), 0, 999999999);
}

std::string text(Reader& in) {
  std::string letters;
  in.list(40, [&] { letters += static_cast<char>(in.byte()); });
  return letters;
}

void change_rule(Reader& in, Control& control) {
  const std::vector<RuleView> every = rules(control);
  const RuleView& rule = every[in.byte() % every.size()];
  RuleValue value = rule.value;
  if (!rule.options.empty())
    value = std::string(rule.options[in.byte() % rule.options.size()].slug);
  else if (std::holds_alternative<bool>(rule.value))
    value = (in.byte() & 1) != 0;
  else if (std::holds_alternative<std::int64_t>(rule.value))
    value = rule_number(in);
  else
    value = text(in);
  const bool checked = rule.options.empty() && std::holds_alternative<std::string>(rule.value);
  claim(!set_rule(control, rule.name, value) || checked, "a rule takes each of its values");
}

void set_parameter(Reader& in, Control& control) {
  const std::uint16_t which = in.whole<std::uint16_t>();
  const bool known = which < control.parameters.size();
  std::string name;
  if (known) {
    name = control.parameters[which].name;
  } else {
    name = std::to_string(which);
    if (const std::uint8_t bit = in.byte() % 9; bit > 0) name += "#" + std::to_string(bit - 1);
  }
  const double value = in.number();
  const bool bit = name.find('#') != std::string::npos;
  const bool fits = bit ? value == 0 || value == 1 : std::fabs(value) <= kSetupLimit;
  const bool taken = !control.set_parameter(name, value);
  claim(!taken || (fits && control.parameter(name) == value), "a parameter takes what fits");
  claim(taken || !known || !fits, "a parameter of the control takes numbers that fit");
}

std::shared_ptr<const Control> changed(Reader& in, const std::shared_ptr<const Control>& control) {
  auto copy = std::make_shared<Control>(*control);
  in.list(4, [&] { set_parameter(in, *copy); });
  in.list(4, [&] { change_rule(in, *copy); });
  return copy;
}

Inputs inputs_of(Reader& in) {
  Inputs inputs;
  in.list(4, [&] { inputs.signals[in.variable()] = in.finite(); });
  inputs.clock_ms = std::fabs(in.length());
  inputs.date = std::fabs(in.length());
  inputs.time = std::fabs(in.length());
  inputs.operator_given = (in.byte() & 1) != 0;
  in.list(8, [&] { inputs.operator_starts.push_back((in.byte() & 1) != 0); });
  in.list(4, [&] {
    std::map<std::int32_t, double> values;
    in.list(2, [&] { values[in.variable()] = in.value(); });
    inputs.writes.push_back(std::move(values));
  });
  in.list(4, [&] {
    const std::size_t signal = in.byte() % inputs.skips.size();
    inputs.skips[signal].push_back({.value = in.byte() / 255.0});
  });
  return inputs;
}

char axis(Reader& in) { return kAxisNames[in.byte() % kAxisNames.size()]; }

std::map<char, double> point(Reader& in) {
  std::map<char, double> axes;
  in.list(4, [&] {
    const char name = axis(in);
    axes[name] = in.length();
  });
  return axes;
}

std::string work_system(Reader& in) {
  const std::uint8_t number = in.byte();
  if (number == 0) return "EXT";
  if (number <= 6) return "G5" + std::to_string(number + 3);
  return "G54.1 P" + std::to_string(number - 6);
}

Setup setup_of(Reader& in) {
  static constexpr std::array<const char*, 4> kMachines = {"", "mill", "lathe-a", "lathe-b"};
  Setup setup;
  setup.machine = kMachines[in.byte() % kMachines.size()];
  if ((in.byte() & 1) != 0) setup.increment = in.positive();
  setup.start = point(in);
  in.list(4, [&] {
    const std::string system = work_system(in);
    setup.work_offsets[system] = point(in);
  });
  for (auto* offsets : {&setup.length_offsets, &setup.radius_offsets})
    in.list(4, [&] {
      const int number = in.numbered();
      (*offsets)[number] = in.length();
    });
  in.list(4, [&] {
    Setup::Tool& tool = setup.tools[in.numbered()];
    tool.values = point(in);
    tool.tip = in.byte() % 10;
    tool.radius = in.length();
  });
  in.list(4, [&] {
    const int number = in.numbered();
    setup.reference[number] = point(in);
  });
  in.list(4, [&] {
    const char name = axis(in);
    setup.rapid[name] = in.positive();
  });
  in.list(4, [&] {
    const char name = axis(in);
    const double one = in.length(), other = in.length();
    setup.limits[name] = {std::min(one, other), std::max(one, other)};
  });
  in.list(4, [&] {
    const char name = axis(in);
    const double one = in.length(), other = in.length();
    setup.area[name] = {std::min(one, other), std::max(one, other)};
  });
  return setup;
}

Options options_of(Reader& in) {
  static constexpr std::array<std::int64_t, 4> kBlocks = {300, 20, 2000, 0};
  Options options;
  const std::uint8_t flags = in.byte(), sizes = in.byte();
  options.mdi = (flags & 1) != 0;
  options.optional_stop = (flags & 2) != 0;
  options.trace = static_cast<Trace::Depth>((flags & 4) == 0 ? 3 : in.byte() % 4);
  options.max_cycles = 1 + (sizes & 3);
  options.max_blocks = kBlocks[sizes >> 2 & 3];
  if ((sizes & 16) != 0) options.max_memory = std::uint64_t{in.byte()} << 10;
  if ((flags & 8) != 0) options.start = in.whole<std::uint32_t>();
  if ((flags & 16) != 0) options.skips = in.whole<std::uint16_t>() & 0x3fe;
  if ((flags & 32) != 0)
    in.list(8, [&] {
      const std::int32_t number = in.variable();
      options.variables[number] = in.value();
    });
  if ((flags & 64) != 0) options.inputs = inputs_of(in);
  if ((flags & 128) != 0) options.setup = setup_of(in);
  return options;
}

SourceFile file_of(std::string_view text, std::size_t number, bool external) {
  SourceFile file{"F" + std::to_string(number), "F" + std::to_string(number), {}, external};
  if (const std::size_t end = text.find(kNameEnd); end < 64) {
    file.name = text.substr(0, end);
    file.stem = file.name.substr(0, file.name.rfind('.'));
    text.remove_prefix(end + 1);
  }
  file.text = FileText(text);
  return file;
}

Texts texts_of(const std::uint8_t* data, std::size_t size) {
  static constexpr std::array<char, 3> kSeparators = {kFile, kExternalFile, kMdi};
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  Texts texts;
  char kind = kFile;
  for (std::size_t at = 0; at <= all.size();) {
    const std::size_t end =
        std::min(all.find_first_of(std::string_view(kSeparators.data(), kSeparators.size()), at),
                 all.size());
    const std::string_view text = all.substr(at, end - at);
    if (kind == kMdi)
      texts.mdi = std::string(text);
    else
      texts.files.push_back(file_of(text, texts.files.size() + 1, kind == kExternalFile));
    texts.external_device |= kind == kExternalFile;
    if (end < all.size()) kind = all[end];
    at = end + 1;
  }
  return texts;
}

}  // namespace

Job read_job(const std::uint8_t* data, std::size_t size) {
  Reader in(data, size);
  Job job;
  job.control = control_at(in.byte());
  job.texts = texts_of(data, in.left());
  return job;
}

namespace {

/// Read a job without its texts, from the end of the bytes.
Job job_without_texts(Reader& in) {
  Job job;
  const std::uint8_t first = in.byte();
  job.control = control_at(first & 0x1f);
  if ((first & 0x20) != 0) job.options = options_of(in);
  if ((first & 0x40) != 0) job.control = changed(in, job.control);
  if ((first & 0x80) != 0) {
    job.main = in.byte();
    job.copied_after = in.byte();
    in.list(4, [&] {
      const std::int32_t number = in.variable();
      job.by_hand.emplace_back(number, in.value());
    });
  }
  if ((first & 0x20) == 0) job.options.max_blocks = 300;
  return job;
}

}  // namespace

Job run_job(const std::uint8_t* data, std::size_t size) {
  Reader in(data, size);
  Job job = job_without_texts(in);
  job.texts = texts_of(data, in.left());
  return job;
}

Job job_around(const std::uint8_t* data, std::size_t size) {
  Reader in(data, size);
  return job_without_texts(in);
}

std::shared_ptr<const Code> library_of(const Job& job, std::int32_t& main, bool general_only) {
  auto code =
      compile(job.control, job.texts.files, job.texts.external_device, {}, {}, general_only);
  if (job.texts.mdi) code = compile_mdi(*code, *job.texts.mdi);
  if (code->programs.empty()) code = compile_mdi(*code, "");
  main = static_cast<std::int32_t>(job.texts.mdi ? code->programs.size() - 1
                                                 : job.main % code->programs.size());
  return code;
}

char* broken_claim = nullptr;

void claim(bool holds, const char* what) {
  if (holds) return;
  if (broken_claim != nullptr) std::strncpy(broken_claim, what, kLongestClaim - 1);
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

}  // namespace cncsub::fuzz
