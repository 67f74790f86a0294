#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/common/scratch_folder.h"

extern char** environ;

namespace mirrorarm::cli {

/// A program that runs beside the test; interrupted at the end.
class Background {
 public:
  /// `line` as a shell reads it.
  explicit Background(const std::string& line) {
    const std::string redirected =
        "exec " + line + " >" + (scratch_ / "out").string() + " 2>" + (scratch_ / "err").string();
    std::array<std::string, 3> words{"sh", "-c", redirected};
    std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    if (::posix_spawn(&process_, "/bin/sh", nullptr, nullptr, arguments.data(), environ) != 0) process_ = -1;
  }
  ~Background() { end(); }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Ends it; 0 where it left of its own accord and was content.
  int end(int signal = SIGINT) {
    if (process_ <= 0) return status_;
    ::kill(process_, signal);
    ::waitpid(process_, &status_, 0);
    process_ = -1;
    return status_;
  }
  /// Whether what it said on standard error contains `text`, within a few seconds.
  [[nodiscard]] bool says(const std::string& text) const {
    for (int i = 0; i < 100 && err().find(text) == std::string::npos; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return err().find(text) != std::string::npos;
  }
  [[nodiscard]] std::string out() const { return test::bytesOf(scratch_ / "out"); }
  [[nodiscard]] std::string err() const { return test::bytesOf(scratch_ / "err"); }

 private:
  test::ScratchFolder scratch_;
  pid_t process_ = -1;
  int status_ = -1;
};

}  // namespace mirrorarm::cli
