/// Counts what this thread asks of the heap.
#pragma once

#include <cstddef>

namespace wale::test {

struct Allocations {
  std::size_t calls = 0, bytes = 0;
};

/// Since the thread began; always zero where the heap cannot be watched: under a sanitizer, or without glibc.
Allocations allocations();
/// Whether it can.
bool counts_allocations();

/// Those of `work`.
template <class Work>
Allocations allocations_of(Work work) {
  const Allocations before = allocations();
  work();
  const Allocations after = allocations();
  return {after.calls - before.calls, after.bytes - before.bytes};
}

}  // namespace wale::test
