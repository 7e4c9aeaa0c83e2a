// SOFTGL_TRACE=FILE: a text file that says what a program asks of the library, line by line. This is where
// the lines go; who has something to say tests `tracing` first and makes the text in a function of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace softgl {

/// True when there is a trace. Set before main, never changed: a branch that every processor predicts.
extern bool tracing __attribute__((visibility("hidden")));

/// True while calls are watched: there is a trace, or a context wants messages of errors (GL_KHR_debug).
extern std::atomic<bool> calls_watched __attribute__((visibility("hidden")));
/// One context more, or one less, that wants it.
void watch_calls(bool more);

/// The text of one line. Holds so much and drops the rest; allocates nothing.
class TraceText {
public:
  TraceText() {} // no zeros into the text
  void put(const char* text);
  void put(char c);
  /// As printf does, always with a decimal point.
  [[gnu::format(printf, 2, 3)]] void print(const char* format, ...);
  const char* data() const { return text_; }
  size_t size() const { return size_; }

private:
  char text_[4096];
  size_t size_ = 0;
};

/// Writes the beginning of a line: a call that is about to be made. It is in the file whatever the call does.
void trace_call(const TraceText& call);
/// Writes the end of that line. Where other lines came in between it is a line of its own that begins with
/// `name`, or nothing if there is nothing to say.
void trace_result(const char* name, const TraceText& result);
/// Writes a line about work that a call caused.
void trace_work(const TraceText& work);

/// Copies memory of the program; false if it cannot be read. A pointer to nowhere must not end the program
/// before its call is in the file.
bool read_program_memory(void* to, const void* from, size_t bytes);

} // namespace softgl
