/// Files and exit code of the machine that runs the emulator, by ARM's semihosting calls.

#pragma once

#include <stddef.h>
#include <stdint.h>

namespace semihosting {

enum Operation : uint32_t { OPEN = 0x01, CLOSE = 0x02, WRITE = 0x05, READ = 0x06, EXIT = 0x20 };
enum Mode : uint32_t { READ_BINARY = 1, WRITE_BINARY = 5 };

inline int32_t call(Operation operation, const uint32_t* arguments) {
  register uint32_t r0 asm("r0") = operation;
  register const uint32_t* r1 asm("r1") = arguments;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<int32_t>(r0);
}

[[noreturn]] inline void exit(int code) {
  const uint32_t arguments[] = {0x20026, static_cast<uint32_t>(code)};  // the application's own end
  for (;;) call(EXIT, arguments);
}

inline uint32_t address(const void* pointer) { return reinterpret_cast<uintptr_t>(pointer); }

/// A file of the host; a program that cannot open it ends.
class File {
 public:
  File(const char* name, uint32_t length, Mode mode) {
    const uint32_t arguments[] = {address(name), mode, length};
    const int32_t opened = call(OPEN, arguments);
    if (opened < 0) exit(98);
    handle_ = static_cast<uint32_t>(opened);
  }

  ~File() { call(CLOSE, &handle_); }

  /// Whether all `size` bytes were there.
  bool read(void* to, uint32_t size) {
    const uint32_t arguments[] = {handle_, address(to), size};
    return call(READ, arguments) == 0;
  }

  /// Whether all `size` bytes were taken.
  bool write(const void* from, uint32_t size) {
    const uint32_t arguments[] = {handle_, address(from), size};
    return call(WRITE, arguments) == 0;
  }

 private:
  uint32_t handle_;
};

}  // namespace semihosting
