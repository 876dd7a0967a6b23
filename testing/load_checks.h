// Helpers for tests of files that are read: a folder that vanishes, messages, a foreign locale.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <locale>
#include <string>

#include "ping_pong_sim/scene_loader.h"

namespace ping_pong
{
class TempFolder
{
public:
  TempFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "ping_pong_XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const
  {
    std::filesystem::remove(path(name));  // ext4 waits for the disk when a file is overwritten, not when it is new
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

private:
  std::filesystem::path path_;
};

inline std::string textOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text with the first `from` replaced. A `from` that is not there is a mistake of the test.
inline std::string edited(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("test edits text that is not there: " + from);
  return text.replace(at, from.size(), to);
}

/// Message of the LoadError that a call throws; empty if it throws none. Other exceptions pass through and fail the
/// test.
inline std::string loadErrorOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const LoadError& error)
  {
    return error.what();
  }
  return "";
}

inline bool startsWith(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

inline void expectMessage(const std::string& message, const std::string& start)
{
  EXPECT_TRUE(startsWith(message, start)) << "message:  " << message << "\nexpected: " << start << "...";
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// Loads, or throws LoadError of one line that begins with the file: nothing else may happen.
inline void expectLoadsOrSaysWhy(const std::function<void()>& load, const std::string& folder, const std::string& what)
{
  try
  {
    load();
  }
  catch (const LoadError& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << what << message;
    EXPECT_TRUE(startsWith(message, folder)) << what << message;
    EXPECT_NE(message.find(": expected "), std::string::npos) << what << message;
  }
  catch (const std::exception& error)
  {
    ADD_FAILURE() << what << "threw something else: " << error.what();
  }
}

/// Numbers with a decimal comma, in C++ and (where the machine has such a locale) in C, until the end of the scope.
class DecimalComma
{
public:
  DecimalComma() : previous_(std::locale::global(std::locale(std::locale::classic(), new Comma)))
  {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
      if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  ~DecimalComma()
  {
    std::locale::global(previous_);
    std::setlocale(LC_ALL, "C");
  }

private:
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
  };
  std::locale previous_;
};
}  // namespace ping_pong
