// host_filter INPUT OUTPUT: the filter on this machine.

#include <cstdio>

#include "filter_run.h"

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

int main(int count, char** names) {
  if (count != 3) return 2;
  File input(names[1], "rb"), output(names[2], "wb");
  return exoid::run_filter(input, output) ? 0 : 1;
}
