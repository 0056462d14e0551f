#include "tests/support/allocations.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define WALE_WATCHES_THE_HEAP 1
#endif

namespace wale::test {
namespace {
thread_local Allocations counted;
}

Allocations allocations() { return counted; }

#ifdef WALE_WATCHES_THE_HEAP
bool counts_allocations() { return true; }
#else
bool counts_allocations() { return false; }
#endif

}  // namespace wale::test

#ifdef WALE_WATCHES_THE_HEAP
extern "C" {
void* __libc_malloc(
    std::size_t);  // glibc's own: a program's malloc goes before it, for Eigen and for operator new alike

void* malloc(std::size_t size) {
  ++wale::test::counted.calls;
  wale::test::counted.bytes += size;
  return __libc_malloc(size);
}
}
#endif
