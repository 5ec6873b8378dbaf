// isocast_openvdb: what needs OpenVDB, as a process of its own, which may fail or be stopped.
//   read FILE GRID MEMORY SECONDS
//   unblosc FILE OFFSET SIZE BYTES MEMORY SECONDS
//   write FILE
// What is wrong goes to stdout as a part of a sentence, with exit code 2.
#include <fmt/format.h>
#include <isocast/base/child_process.h>
#include <isocast/volume/io/vdb_process.h>

#include <ios>
#include <iostream>
#include <span>

namespace isocast::vdb_process {
namespace {

void run(std::span<const std::string> words) {
  const auto limit = [&](const std::string& memory, const std::string& seconds) {
    limit_this_process(std::stoull(memory), static_cast<unsigned>(std::stoul(seconds)));
  };
  if (words.size() == 5 && words[0] == "read") {
    limit(words[3], words[4]);
    read(words[1], words[2]);
  } else if (words.size() == 7 && words[0] == "unblosc") {
    limit(words[5], words[6]);
    unblosc(words[1], std::stoull(words[2]), std::stoull(words[3]), std::stoull(words[4]));
  } else if (words.size() == 2 && words[0] == "write") {
    write(words[1]);
  } else {
    throw std::runtime_error("isocast_openvdb is a part of isocast and no program of its own");
  }
}

int try_to_run(std::span<const std::string> words) {
  const auto say = [](const std::string& what) {
    fmt::print("{}", what);
    return 2;
  };
  try {
    run(words);
    return 0;
  } catch (const std::bad_alloc&) {
    return say("more memory is needed than its size makes plausible, or than there is");
  } catch (const std::ios_base::failure&) {
    return say("it ends inside its tree, it is damaged or incomplete");
  } catch (const std::exception& error) { return say(error.what()); }
}

}  // namespace
}  // namespace isocast::vdb_process

// Ends without destructors: those of a tree that was half read would follow wild pointers.
int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  std::cerr.rdbuf(nullptr);  // OpenVDB's warnings about what it reads all the same
  const int status = isocast::vdb_process::try_to_run(arguments);
  std::fflush(stdout);
  _exit(status);
}
