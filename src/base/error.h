// The two kinds of failure that reach a user.
#pragma once

#include <stdexcept>
#include <string>

namespace isocast {

/// What the user gave cannot be used: wrong command line, file, formula, missing optional part. The message
/// is one sentence: what was found, where (file, line, column, byte or key), what was expected. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work was stopped by Ctrl-C (or by the caller's stop token). Exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace isocast
