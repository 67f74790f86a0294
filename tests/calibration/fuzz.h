#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

namespace mirrorarm::calibration {

inline void writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string readText(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Calls `read` on `rounds` damaged versions of `file`: bytes changed, cut off, doubled.
template <class Read>
void fuzz(const std::filesystem::path& file, int rounds, Read read) {
  const std::string good = readText(file);
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> place(0, good.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255), kind(0, 3);
  for (int round = 0; round < rounds; ++round) {
    std::string bad = good;
    for (int change = round % 4; change >= 0; --change) bad[place(random)] = static_cast<char>(byte(random));
    if (kind(random) == 0) bad.resize(place(random));
    if (kind(random) == 0) bad += good.substr(place(random));
    writeText(file, bad);
    read(file);
  }
}

}  // namespace mirrorarm::calibration
