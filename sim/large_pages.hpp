/// Memory for arrays of many megabytes.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace wale {

/// Pages of 2 MB, which the kernel looks up and hands out in a fraction of the time of 500 small ones. It clears them,
/// which took another tenth of the time of a large swatch: so what is left is kept for the next array of about the same
/// size. No more is held than was once in use. Threads may call at once.
namespace large_pages {

constexpr std::size_t page = std::size_t{1} << 21;  // bytes

/// Memory for at least so many bytes, with anything in it. Throws std::bad_alloc.
void* take(std::size_t bytes);
/// What take() gave is no longer used.
void leave(void* memory);

}  // namespace large_pages

/// An allocator of large pages for arrays as large as a few of them, and of the heap for others. Elements that are made
/// without a value are left as they are.
template <class T>
struct LargePages {
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  /// Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    if (!is_large(count)) return static_cast<T*>(::operator new(count * sizeof(T)));
    return static_cast<T*>(large_pages::take(count * sizeof(T)));
  }

  void deallocate(T* memory, std::size_t count) {
    if (is_large(count))
      large_pages::leave(memory);
    else
      ::operator delete(memory);
  }

  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    if constexpr (sizeof...(Values) == 0)
      ::new (static_cast<void*>(at)) U;
    else
      ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }

  friend bool operator==(const LargePages&, const LargePages&) { return true; }

 private:
  static constexpr std::size_t few = 4 * large_pages::page;  // bytes
  static bool is_large(std::size_t count) { return count >= few / sizeof(T); }
};

template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace wale
