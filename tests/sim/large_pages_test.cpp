#include "sim/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace wale {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

class LargePagesTest : public ::testing::Test {
 protected:
  /// What other tests have left is given back where none of it is large enough.
  void SetUp() override { large_pages::leave(large_pages::take(512 * megabyte)); }
};

TEST_F(LargePagesTest, KeepsWhatIsLeftForTheNextOfAboutTheSameSize) {
  void* const first = large_pages::take(100 * megabyte);
  large_pages::leave(first);
  void* const next = large_pages::take(104 * megabyte);
  EXPECT_EQ(next, first);
  large_pages::leave(next);
}

TEST_F(LargePagesTest, HandsNothingOutTwice) {
  void* const first = large_pages::take(100 * megabyte);
  void* const second = large_pages::take(100 * megabyte);
  EXPECT_NE(first, second);
  large_pages::leave(first);
  EXPECT_EQ(large_pages::take(100 * megabyte), first);
  large_pages::leave(first);
  large_pages::leave(second);
}

TEST_F(LargePagesTest, DoesNotSpendMuchOnLittle) {
  void* const large = large_pages::take(300 * megabyte);
  large_pages::leave(large);
  void* const small = large_pages::take(10 * megabyte);
  EXPECT_NE(small, large);
  large_pages::leave(small);
}

TEST_F(LargePagesTest, LieOnPages) {
  void* const memory = large_pages::take(9 * megabyte);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % large_pages::page, 0U);
  large_pages::leave(memory);
}

TEST_F(LargePagesTest, ServeArraysThatGrow) {
  LargeArray<int> counted(megabyte);
  std::iota(counted.begin(), counted.end(), 0);
  counted.resize(20 * megabyte);
  counted.resize(megabyte);
  counted.shrink_to_fit();
  for (std::size_t k = 0; k < counted.size(); ++k) ASSERT_EQ(counted[k], static_cast<int>(k));
}

}  // namespace
}  // namespace wale
