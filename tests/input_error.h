// What an InputError says, for CHECK_THROWS_MATCHES(expression, InputError, says("...")).
#pragma once

#include <isocast/base/error.h>

#include <catch2/catch.hpp>
#include <string>

namespace isocast::test {

inline auto says(const std::string& text) {
  return Catch::Predicate<InputError>(
      [=](const InputError& error) { return std::string(error.what()).find(text) != std::string::npos; },
      "says: " + text);
}

}  // namespace isocast::test
