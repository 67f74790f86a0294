#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace mirrorarm::robot::testing {

inline std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline std::string withInstead(std::string text, const std::string& old, const std::string& other) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), other);
}

/// Calls `read` with texts of which bytes are changed, every third cut short.
template <class Read>
void forMutationsOf(const std::string& good, int rounds, Read read) {
  std::mt19937 random(5);
  for (int round = 0; round < rounds; ++round) {
    std::string text = good.substr(0, round % 3 == 0 ? random() % good.size() : good.size());
    for (unsigned i = 0; i < 1 + random() % 6 && !text.empty(); ++i)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    read(text);
  }
}

}  // namespace mirrorarm::robot::testing
