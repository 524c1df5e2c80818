/// The files of a test program that runs here and on the emulated Cortex-M0: in.bin and out.bin of
/// its folder.

#pragma once

#if defined(__arm__)

#include "semihosting.h"

namespace world_files {

using semihosting::File;
constexpr semihosting::Mode TO_READ = semihosting::READ_BINARY;
constexpr semihosting::Mode TO_WRITE = semihosting::WRITE_BINARY;

[[noreturn]] inline void end(int code) { semihosting::exit(code); }

inline void tell(const char*) {}

}  // namespace world_files

#else

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace world_files {

constexpr const char* TO_READ = "rb";
constexpr const char* TO_WRITE = "wb";

class File {
 public:
  File(const char* name, uint32_t, const char* mode) : file_(std::fopen(name, mode)) {
    if (file_ == nullptr) std::exit(98);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { std::fclose(file_); }

  bool read(void* to, uint32_t size) { return std::fread(to, 1, size, file_) == size; }
  bool write(const void* from, uint32_t size) { return std::fwrite(from, 1, size, file_) == size; }

 private:
  std::FILE* file_;
};

[[noreturn]] inline void end(int code) { std::exit(code); }

inline void tell(const char* sentence) {
  std::fprintf(stderr, "it does not hold that %s\n", sentence);
}

}  // namespace world_files

#endif
