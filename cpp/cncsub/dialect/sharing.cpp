#include "cncsub/dialect/sharing.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "cncsub/system/cores.hpp"
#include "cncsub/text/helpers.hpp"

namespace cncsub {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Unify a run of line feeds and carriage returns that has a return. The last character of each
/// line's end becomes the line feed, so that no blank is left at the head of a line.
void unify_run(char* first, char* end) {
  char* feed = end;
  while (feed != first && feed[-1] != '\n') --feed;
  if (feed == first) return std::fill(first, end, '\n');
  std::replace(first, end, '\r', ' ');
  if (feed == end) return;
  end[-1] = '\n';
  feed[-1] = ' ';
}

}  // namespace

void unify_line_ends(char* at, char* end, InterruptCheck& interrupt) {
  const char* const begin = at;
  const auto next = [&](char* from) {
    return static_cast<char*>(std::memchr(from, '\r', static_cast<std::size_t>(end - from)));
  };
  while (at != end && (at = next(at)) != nullptr && !interrupt.requested(InterruptCheck::kBlock)) {
    char* const first = at != begin && at[-1] == '\n' ? at - 1 : at;
    at = std::find_if_not(at, end, is_line_end);
    unify_run(first, at);
  }
}

namespace {

constexpr std::size_t kProgram = 64;  // the work of giving a program its names, in bytes
constexpr std::size_t kWorthIt = 8;   // pieces that make the start of a further thread worthwhile

/// Files [first, last), or lines of the first of them.
struct Job {
  std::size_t first = 0, last = 0;
  Lines lines;
  char* text = nullptr;  // the text of the file; null: whole files

  bool begins_file() const { return text != nullptr && lines.from == 0; }
};

void cut(SourceFile& file, std::size_t number, std::size_t piece, std::vector<Job>& jobs) {
  const std::string_view text = file.text.view();
  for (std::size_t at = 0; at < text.size();) {
    std::size_t to = text.size();
    if (to - at > 2 * piece) to = std::min(text.find('\n', at + piece), to - 1) + 1;
    while (to < text.size() && is_line_end(text[to])) ++to;
    jobs.push_back({number, number + 1, {text, at, to}, file.text.data()});
    at = to;
  }
}

std::vector<Job> jobs_of(std::vector<SourceFile>& files, std::size_t piece) {
  std::vector<Job> jobs;
  std::size_t bytes = piece;  // of the last job, if files can be added to it
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::size_t size = files[i].text.size();
    if (size > 2 * piece) {
      cut(files[i], i, piece, jobs);
      bytes = piece;
    } else if (bytes >= piece) {
      jobs.push_back({i, i + 1, {}, nullptr});
      bytes = size;
    } else {
      jobs.back().last = i + 1;
      bytes += size;
    }
  }
  return jobs;
}

/// A code of its own for one job after another, and its readers.
struct WorkerPart {
  WorkerPart(const SharedReading& reading, const std::function<bool()>& stopped)
      : interrupt(stopped), to(prepared(reading), interrupt) {
    read = reading.dialect.reader(to, reading.other_mode);
    pieces = reading.dialect.pieces(to);
  }
  WorkerPart(const WorkerPart&) = delete;
  WorkerPart& operator=(const WorkerPart&) = delete;
  ~WorkerPart() = default;

  Code code;
  InterruptCheck interrupt;
  Builder to;
  FileReader read;
  PieceReader pieces;
  std::vector<int> lists;
  std::optional<std::uint32_t> lines;  // of a piece that could be read

 private:
  Code& prepared(const SharedReading& reading) {
    reading.prepare(code);
    return code;
  }
};

class Pool {
 public:
  Pool(const SharedReading& reading, std::vector<SourceFile>& files, std::vector<Job> jobs)
      : reading_(reading),
        files_(files),
        jobs_(std::move(jobs)),
        slots_(jobs_.size()),
        pieces_(reading.dialect.pieces(reading.to)) {}

  void read(std::size_t threads) {
    threads_ = threads;
    const Helpers helpers(std::min(threads, jobs_.size()) - 1, [this] { help(); });
    const struct End {
      Pool& pool;
      ~End() { pool.end(); }
    } end{*this};
    for (std::size_t k = 0; k < jobs_.size() && !interrupted(kProgram); ++k) do_job(k);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Slot {
    enum class State { Free, Taken, Done } state = State::Free;
    std::unique_ptr<WorkerPart> worker_part;  // null: nothing could be read apart
  };

  bool interrupted(std::size_t bytes) { return reading_.to.interrupt().requested(bytes); }

  void end() {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
    changed_.notify_all();
  }

  /// Do one job after another, as a helper.
  void help() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stop_ || free_job() != kNone; });
      if (stop_) return;
      take(free_job(), lock);
    }
  }

  /// Return the next job to be read apart, which is never far ahead of the job being joined. Of
  /// `threads_` jobs one is left to the joining thread, which reads it to where it belongs, so that
  /// nothing has to be moved. If all others are taken, such a job is read apart as well.
  std::size_t free_job() const {
    const std::size_t end = std::min(jobs_.size(), joined_ + 2 * threads_ + 2);
    std::size_t found = kNone;
    for (std::size_t k = joined_; k < end; ++k) {
      // The beginning of a file is not read apart: it continues no program.
      if (slots_[k].state != Slot::State::Free || jobs_[k].begins_file()) continue;
      if (k % threads_ != 0) return k;
      found = std::min(found, k);
    }
    return found;
  }

  /// Read a job apart.
  void take(std::size_t number, std::unique_lock<std::mutex>& lock) {
    slots_[number].state = Slot::State::Taken;
    std::unique_ptr<WorkerPart> worker_part;
    if (!free_.empty()) {
      worker_part = std::move(free_.back());
      free_.pop_back();
    }
    lock.unlock();
    read_in_worker(jobs_[number], worker_part);
    lock.lock();
    slots_[number].worker_part = std::move(worker_part);
    slots_[number].state = Slot::State::Done;
    changed_.notify_all();
  }

  /// Read a job into `worker_part`. If memory runs out, the joining thread meets that too, and
  /// reports it.
  void read_in_worker(const Job& job, std::unique_ptr<WorkerPart>& worker_part) noexcept {
    try {
      if (!worker_part)
        worker_part = std::make_unique<WorkerPart>(
            reading_, [this] { return stop_.load(std::memory_order_relaxed); });
      if (job.text != nullptr)
        read_lines(job, *worker_part);
      else
        read_some(job, *worker_part);
    } catch (...) {
      if (job.text == nullptr && worker_part) return_texts(job, worker_part->code.files);
      worker_part.reset();
    }
  }

  void read_lines(const Job& job, WorkerPart& worker_part) {
    unify(job, worker_part.interrupt);
    worker_part.code.files.assign(1, {});
    worker_part.lines = worker_part.pieces.read_in_worker(job.lines);
    worker_part.code.files.clear();
  }

  void read_some(const Job& job, WorkerPart& worker_part) {
    worker_part.code.files.reserve(job.last - job.first);
    for (std::size_t i = job.first; i < job.last && !worker_part.interrupt.requested(kProgram);
         ++i) {
      SourceFile& file = worker_part.code.files.emplace_back(std::move(files_[i]));
      unify_line_ends(file.text.data(), file.text.data() + file.text.size(), worker_part.interrupt);
      worker_part.read(static_cast<std::uint32_t>(worker_part.code.files.size() - 1));
    }
    worker_part.lines = 0;
  }

  void return_texts(const Job& job, std::vector<SourceFile>& files) noexcept {
    for (std::size_t i = 0; i < files.size(); ++i) files_[job.first + i] = std::move(files[i]);
    files.clear();
  }

  static void unify(const Job& job, InterruptCheck& interrupt) {
    unify_line_ends(job.text + job.lines.from, job.text + job.lines.to, interrupt);
  }

  /// Put a job into the code, which holds everything before it.
  void do_job(std::size_t number) {
    std::unique_ptr<WorkerPart> worker_part = taken(number);
    if (stop_) return;  // a helper may still be reading it
    if (!worker_part || !join(number, *worker_part)) {
      if (worker_part && jobs_[number].text == nullptr)
        return_texts(jobs_[number], worker_part->code.files);
      worker_part.reset();
      read_itself(jobs_[number]);
    }
    const std::scoped_lock lock(mutex_);
    if (worker_part) free_.push_back(std::move(worker_part));
    joined_ = number + 1;
    changed_.notify_all();
  }

  /// Return what another thread has read of a job; null if none took it.
  std::unique_ptr<WorkerPart> taken(std::size_t number) {
    std::unique_lock lock(mutex_);
    Slot& slot = slots_[number];
    if (slot.state == Slot::State::Free) {
      slot.state = Slot::State::Done;
      return nullptr;
    }
    while (slot.state == Slot::State::Taken && !stop_) {
      if (const std::size_t other = free_job(); other != kNone)
        take(other, lock);
      else
        changed_.wait_for(lock, std::chrono::milliseconds(20));
      lock.unlock();
      const bool over = interrupted(InterruptCheck::kLook);
      lock.lock();
      if (over) stop_ = true;
    }
    return std::move(slot.worker_part);
  }

  bool join(std::size_t number, WorkerPart& worker_part) {
    const Job& job = jobs_[number];
    if (!worker_part.lines) return false;
    Joined of{worker_part.to, worker_part.code, worker_part.lists};
    of.to_come = static_cast<double>(jobs_.size() - number - 1) / static_cast<double>(number + 1);
    if (job.text == nullptr) {
      if (!can_join(reading_.to, of)) return false;
      cncsub::join(reading_.to, of);
      return true;
    }
    if (!pieces_.join(of, *worker_part.lines)) return false;
    if (job.lines.to == job.lines.text.size())
      pieces_.read_on({job.lines.text, job.lines.to, job.lines.to});
    return true;
  }

  void read_itself(const Job& job) {
    if (job.text == nullptr || job.begins_file())
      for (std::size_t i = job.first; i < job.last && !interrupted(kProgram); ++i) {
        SourceFile& file = reading_.code.files.emplace_back(std::move(files_[i]));
        if (job.text != nullptr) break;
        unify_line_ends(file.text.data(), file.text.data() + file.text.size(),
                        reading_.to.interrupt());
        reading_.read(static_cast<std::uint32_t>(reading_.code.files.size() - 1));
      }
    if (job.text == nullptr) return;
    unify(job, reading_.to.interrupt());
    pieces_.read_on(job.lines);
  }

  const SharedReading& reading_;
  std::vector<SourceFile>& files_;
  const std::vector<Job> jobs_;
  std::vector<Slot> slots_;
  PieceReader pieces_;
  std::size_t threads_ = 1;
  std::mutex mutex_;  // guards all that follows, and the slots
  std::condition_variable changed_;
  std::size_t joined_ = 0;
  std::vector<std::unique_ptr<WorkerPart>> free_;
  std::atomic<bool> stop_ = false;
};

void read_alone(const SharedReading& reading, std::vector<SourceFile>& files) {
  for (SourceFile& file : files) {
    FileText& text = reading.code.files.emplace_back(std::move(file)).text;
    unify_line_ends(text.data(), text.data() + text.size(), reading.to.interrupt());
    reading.read(static_cast<std::uint32_t>(reading.code.files.size() - 1));
    if (reading.to.interrupt().requested(kProgram)) return;
  }
}

}  // namespace

void read_files(const SharedReading& reading, std::vector<SourceFile>& files,
                const Sharing& sharing) {
  reading.code.files.reserve(files.size());
  const std::size_t threads = sharing.threads == 0 ? system::cores() : sharing.threads;
  std::size_t bytes = 0;
  for (const SourceFile& file : files) bytes += file.text.size();
  if (threads < 2 || reading.code.general_only || bytes < kWorthIt * sharing.piece ||
      reading.dialect.pieces == nullptr)
    return read_alone(reading, files);
  Pool(reading, files, jobs_of(files, sharing.piece)).read(threads);
}

}  // namespace cncsub
