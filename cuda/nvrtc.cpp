#include <isocast/cuda/library.h>
#include <isocast/cuda/nvrtc.h>
#include <nvrtc.h>

#include <algorithm>
#include <stdexcept>

namespace isocast {
namespace {

struct Nvrtc {
  decltype(&::nvrtcVersion) version;
  decltype(&::nvrtcCreateProgram) create;
  decltype(&::nvrtcDestroyProgram) destroy;
  decltype(&::nvrtcCompileProgram) compile;
  decltype(&::nvrtcGetProgramLogSize) log_size;
  decltype(&::nvrtcGetProgramLog) log;
  decltype(&::nvrtcGetCUBINSize) cubin_size;
  decltype(&::nvrtcGetCUBIN) cubin;
  decltype(&::nvrtcGetPTXSize) ptx_size;
  decltype(&::nvrtcGetPTX) ptx;
  decltype(&::nvrtcGetErrorString) error_text;
  decltype(&::nvrtcGetNumSupportedArchs) architecture_count;
  decltype(&::nvrtcGetSupportedArchs) architectures;

  Nvrtc() {
    const SharedLibrary library(
        {"libnvrtc.so." ISO_NVRTC_MAJOR, "libnvrtc.so"},
        "formulas on a GPU are compiled by NVRTC, and libnvrtc.so is not on this machine: install "
        "the CUDA toolkit's, or use another --isa");
    library.find("nvrtcVersion", version);
    library.find("nvrtcCreateProgram", create);
    library.find("nvrtcDestroyProgram", destroy);
    library.find("nvrtcCompileProgram", compile);
    library.find("nvrtcGetProgramLogSize", log_size);
    library.find("nvrtcGetProgramLog", log);
    library.find("nvrtcGetCUBINSize", cubin_size);
    library.find("nvrtcGetCUBIN", cubin);
    library.find("nvrtcGetPTXSize", ptx_size);
    library.find("nvrtcGetPTX", ptx);
    library.find("nvrtcGetErrorString", error_text);
    library.find("nvrtcGetNumSupportedArchs", architecture_count);
    library.find("nvrtcGetSupportedArchs", architectures);
  }
};

const Nvrtc& nvrtc() {
  static const Nvrtc opened;
  return opened;
}

void check(nvrtcResult result, const std::string& log = {}) {
  if (result != NVRTC_SUCCESS)
    throw std::runtime_error(fmt::format("NVRTC says {}\n{}", nvrtc().error_text(result), log));
}

class Program {
 public:
  Program(const std::string& source, std::span<const SourceFile> headers) {
    std::vector<const char*> texts, names;
    for (const SourceFile& header : headers) {
      texts.push_back(header.text.c_str());
      names.push_back(header.name.c_str());
    }
    check(nvrtc().create(&handle_, source.c_str(), "isocast.cu", static_cast<int>(headers.size()),
                         texts.data(), names.data()));
  }
  ~Program() { nvrtc().destroy(&handle_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // The log, whatever came of it.
  std::string compile(std::span<const char* const> options, nvrtcResult& result) {
    result = nvrtc().compile(handle_, static_cast<int>(options.size()), options.data());
    std::size_t size = 0;
    check(nvrtc().log_size(handle_, &size));
    std::string log(size, '\0');
    check(nvrtc().log(handle_, log.data()));
    return log.c_str();
  }
  [[nodiscard]] std::vector<char> code(bool ptx) const {
    std::size_t size = 0;
    check((ptx ? nvrtc().ptx_size : nvrtc().cubin_size)(handle_, &size));
    std::vector<char> code(size);
    check((ptx ? nvrtc().ptx : nvrtc().cubin)(handle_, code.data()));
    return code;
  }

 private:
  nvrtcProgram handle_ = nullptr;
};

}  // namespace

CompiledProgram compile_program(const std::string& source, std::span<const SourceFile> headers,
                                const std::string& architecture) {
  const bool ptx = architecture.starts_with("compute_");
  Program program(source, headers);
  const std::string target = "--gpu-architecture=" + architecture;
  // functions that say nothing run on the device; nothing is fused: the bits are those of this processor
  std::vector<const char*> options = {"--std=c++20", "--fmad=false", "--device-as-default-execution-space",
                                      target.c_str()};
  options.push_back("--define-macro=__INT_MAX__=2147483647");  // which other compilers have
  if (!ptx) options.push_back("--ptxas-options=-v");
  nvrtcResult result = NVRTC_SUCCESS;
  std::string log = program.compile(options, result);
  check(result, log);
  return {program.code(ptx), std::move(log)};
}

std::string architecture_for(int capability) {
  int count = 0;
  check(nvrtc().architecture_count(&count));
  std::vector<int> known(static_cast<std::size_t>(count));
  check(nvrtc().architectures(known.data()));
  int newest = 0;
  for (const int each : known) {
    if (each == capability) return fmt::format("sm_{}", capability);
    if (each < capability) newest = std::max(newest, each);
  }
  return fmt::format("compute_{}", newest);
}

std::string compiler_version() {
  int major = 0, minor = 0;
  check(nvrtc().version(&major, &minor));
  return fmt::format("{}.{}", major, minor);
}

}  // namespace isocast
