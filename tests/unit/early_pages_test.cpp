// Memory that was brought in early: aligned, zero, each byte given once, open again when all is back.
#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/early_pages.h"

using namespace softgl;

#ifndef SOFTGL_ADDRESS_SANITIZER // which gets all objects from malloc

namespace {

constexpr size_t kObject = size_t(128) << 10;

/// Takes until there is no more.
std::vector<unsigned char*> take_all() {
  std::vector<unsigned char*> objects;
  while (auto* p = static_cast<unsigned char*>(take_early_pages(kObject))) objects.push_back(p);
  return objects;
}

bool zero(const unsigned char* p) {
  return std::all_of(p, p + kObject, [](unsigned char byte) { return byte == 0; });
}

} // namespace

TEST_CASE("early pages are zero, aligned and given once, and open again when all are back", "[pages]") {
  open_early_pages();
  for (int round = 0; round < 3; ++round) {
    std::vector<unsigned char*> objects = take_all();
    REQUIRE(objects.size() > 4);
    CHECK(take_early_pages(kObject) == nullptr);
    for (unsigned char* p : objects) {
      CHECK(reinterpret_cast<uintptr_t>(p) % 64 == 0);
      REQUIRE(zero(p)); // not what another object or the last round wrote
      std::fill_n(p, kObject, uint8_t(255));
    }
    // In any order; what is back is not open before the last one is.
    std::swap(objects.front(), objects.back());
    for (size_t i = 0; i < objects.size(); ++i) {
      CHECK(take_early_pages(kObject) == nullptr);
      CHECK(give_back_early_pages(objects[i]));
    }
  }
}

TEST_CASE("early pages are not for what is small or large, and take nothing back that is not theirs",
          "[pages]") {
  open_early_pages();
  CHECK(take_early_pages(0) == nullptr);
  CHECK(take_early_pages(1000) == nullptr);
  CHECK(take_early_pages(size_t(64) << 20) == nullptr);
  CHECK(take_early_pages(SIZE_MAX) == nullptr);
  int other = 0;
  CHECK_FALSE(give_back_early_pages(&other));
  CHECK_FALSE(give_back_early_pages(nullptr));
}

TEST_CASE("threads take and give early pages at the same time", "[pages]") {
  open_early_pages();
  std::atomic<bool> good{true};
  auto work = [&](uint8_t mark) {
    for (int i = 0; i < 300; ++i) {
      auto* p = static_cast<unsigned char*>(take_early_pages(kObject));
      if (!p) continue;
      if (!zero(p)) good = false;
      std::fill_n(p, kObject, mark);
      if (!std::all_of(p, p + kObject, [&](unsigned char byte) { return byte == mark; })) good = false;
      give_back_early_pages(p);
    }
  };
  std::thread first(work, uint8_t(1)), second(work, uint8_t(2));
  work(3);
  first.join();
  second.join();
  CHECK(good);
  const auto objects = take_all();
  CHECK(objects.size() > 4); // all is open again
  for (unsigned char* p : objects) give_back_early_pages(p);
}

#endif
