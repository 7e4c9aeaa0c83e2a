#include "base/trace_file.h"

#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include "base/cpu_features.h"

namespace softgl {

constinit bool tracing = false;
constinit std::atomic<bool> calls_watched = false;

void watch_calls(bool more) {
  static constinit std::mutex changing;
  static constinit int watchers = 0;
  const std::lock_guard lock(changing);
  watchers += more ? 1 : -1;
  calls_watched = tracing || watchers > 0;
}

namespace {

constinit std::mutex mutex; // of all below
constinit int file = -1;
constinit int open_line = 0; // the thread whose line has no end yet

/// Threads are counted as they come.
int this_thread() {
  static std::atomic<int> count{0};
  static constinit thread_local int number = 0;
  return number ? number : number = ++count;
}

/// The first thread's lines carry no number: most programs have one.
void put_thread(TraceText& line) {
  if (this_thread() != 1) line.print("[%d] ", this_thread());
}

/// One write for a line, so that nothing waits in memory if the program ends.
void write_all(const TraceText& before, const TraceText& text, bool end) {
  const char newline = '\n';
  iovec parts[] = {{const_cast<char*>(before.data()), before.size()},
                   {const_cast<char*>(text.data()), text.size()},
                   {const_cast<char*>(&newline), end ? size_t(1) : 0}};
  const size_t wanted = before.size() + text.size() + size_t(end);
  ssize_t written = 0;
  do written = writev(file, parts, 3);
  while (written < 0 && errno == EINTR);
  if (written == ssize_t(wanted) || file < 0) return;
  std::fprintf(stderr, "softgl: the trace ends here, it cannot be written: %s\n",
               written < 0 ? std::strerror(errno) : "the disk is full");
  close(file);
  file = -1;
}

/// Begins a line: ends one that is open.
TraceText begin_line() {
  TraceText before;
  if (open_line) before.put('\n');
  open_line = 0;
  put_thread(before);
  return before;
}

std::string file_name(const char* pattern) {
  std::string name = pattern;
  const std::string number = std::to_string(getpid());
  for (size_t at = 0; (at = name.find("%p", at)) != std::string::npos; at += number.size())
    name.replace(at, 2, number);
  return name;
}

/// Opens the file when the library is loaded.
[[maybe_unused]] const bool opened = [] {
  const char* pattern = std::getenv("SOFTGL_TRACE");
  if (!pattern || !*pattern) return false;
  const std::string name = file_name(pattern);
  file = open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) {
    std::fprintf(stderr, "softgl: cannot write the trace to %s: %s\n", name.c_str(), std::strerror(errno));
    return false;
  }
  TraceText text;
  text.print("softgl %s, instruction set %s", SOFTGL_VERSION_TEXT, isa_name(selected_isa()));
  write_all({}, text, true);
  // A child must not wait for a thread that it does not have.
  pthread_atfork([] { mutex.lock(); }, [] { mutex.unlock(); }, [] { mutex.unlock(); });
  calls_watched = true;
  return tracing = true;
}();

} // namespace

void TraceText::put(char c) {
  if (size_ < sizeof text_) text_[size_++] = c;
}

void TraceText::put(const char* text) {
  const size_t length = std::min(std::strlen(text), sizeof text_ - size_);
  std::memcpy(text_ + size_, text, length);
  size_ += length;
}

void TraceText::print(const char* format, ...) {
  // The program may have set a locale that writes 0,5.
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  const locale_t of_program = uselocale(plain);
  char part[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(part, sizeof part, format, arguments);
  va_end(arguments);
  uselocale(of_program);
  put(part);
}

void trace_call(const TraceText& call) {
  const std::lock_guard lock(mutex);
  write_all(begin_line(), call, false);
  open_line = this_thread();
}

void trace_result(const char* name, const TraceText& result) {
  const std::lock_guard lock(mutex);
  if (open_line == this_thread()) {
    write_all({}, result, true);
    open_line = 0;
  } else if (result.size() > 0) {
    TraceText before = begin_line();
    before.print("... %s", name);
    write_all(before, result, true);
  }
}

void trace_work(const TraceText& work) {
  const std::lock_guard lock(mutex);
  TraceText before = begin_line();
  before.put("  ");
  write_all(before, work, true);
}

bool read_program_memory(void* to, const void* from, size_t bytes) {
  const iovec here{to, bytes}, there{const_cast<void*>(from), bytes};
  if (process_vm_readv(getpid(), &here, 1, &there, 1, 0) == ssize_t(bytes)) return true;
  if (errno == EFAULT) return false;
  std::memcpy(to, from, bytes); // there is no such system call here
  return true;
}

} // namespace softgl
