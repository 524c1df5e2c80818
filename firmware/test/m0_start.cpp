// From reset to main on a bare Cortex-M, and the functions that the compiler calls by itself.

#include <stddef.h>
#include <stdint.h>

#include "semihosting.h"

extern uint32_t data_source[], data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];

typedef void (*Handler)();

extern const Handler constructors_begin[], constructors_end[];

int main();

extern "C" {

void* memcpy(void* to, const void* from, size_t size) {
  uint8_t* target = static_cast<uint8_t*>(to);
  const uint8_t* source = static_cast<const uint8_t*>(from);
  for (size_t at = 0; at < size; ++at) target[at] = source[at];
  return to;
}

void* memset(void* to, int value, size_t size) {
  uint8_t* target = static_cast<uint8_t*>(to);
  for (size_t at = 0; at < size; ++at) target[at] = static_cast<uint8_t>(value);
  return to;
}

[[noreturn]] void start() {
#if defined(__ARM_FP)
  *reinterpret_cast<volatile uint32_t*>(0xE000ED88) = 0xF00000;  // CPACR: floating point is on
  asm volatile("dsb; isb");
#endif
  const uint32_t* source = data_source;
  for (uint32_t* word = data_begin; word < data_end; ++word) *word = *source++;
  for (uint32_t* word = bss_begin; word < bss_end; ++word) *word = 0;
  for (const Handler* make = constructors_begin; make < constructors_end; ++make) (*make)();
  semihosting::exit(main());
}

[[noreturn]] void fault() { semihosting::exit(99); }

void wake() {}

__attribute__((section(".vectors"), used)) const Handler vectors[16] = {
    reinterpret_cast<Handler>(stack_top), start, fault, fault, fault, fault, fault, fault,
    fault, fault, fault, fault, fault, fault, fault, wake};
}
