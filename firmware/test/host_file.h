/// Files of this machine, as those of the emulator's.

#pragma once

#include <cstdio>

class File {
 public:
  File(const char* name, const char* mode) : file_(std::fopen(name, mode)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (file_ != nullptr) std::fclose(file_);
  }
  bool read(void* to, size_t size) { return file_ && std::fread(to, 1, size, file_) == size; }
  bool write(const void* from, size_t size) {
    return file_ && std::fwrite(from, 1, size, file_) == size;
  }

 private:
  std::FILE* file_;
};
