#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/cuda/device_engine.h>
#include <isocast/cuda/driver.h>
#include <isocast/cuda/formula_program.h>
#include <isocast/cuda/volume_images.h>

#include <mutex>
#include <vector>

namespace isocast {
namespace {

constexpr unsigned kThreads = 128;

// The primary context, current for the calling thread from here on.
class Context {
 public:
  explicit Context(CUdevice device) { check(driver().retain_context(&context_, device)); }
  void use() const { check(driver().set_context(context_)); }

 private:
  CUcontext context_;  // the driver gives it back when the program ends
};

std::string in_mebibytes(std::size_t bytes) {
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 0x1p20);
}

class Memory final : public KernelMemory {
 public:
  Memory(const Context& context, std::size_t bytes) : context_(context), bytes_(bytes) {
    const CUresult result = driver().allocate(&data_, bytes);
    if (result != CUDA_ERROR_OUT_OF_MEMORY) {
      check(result);
      return;
    }
    std::size_t free = 0, total = 0;
    check(driver().memory_info(&free, &total));
    throw InputError(fmt::format("{} were asked of the GPU, which has {} of {} left: use another --isa",
                                 in_mebibytes(bytes), in_mebibytes(free), in_mebibytes(total)));
  }
  ~Memory() override {
    try {
      context_.use();
      driver().free(data_);
    } catch (...) {}  // the driver has gone
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  [[nodiscard]] void* data() const override { return reinterpret_cast<void*>(data_); }
  [[nodiscard]] std::size_t bytes() const override { return bytes_; }

 private:
  const Context& context_;
  CUdeviceptr data_ = 0;
  std::size_t bytes_;
};

struct Function final : Kernel {
  explicit Function(CUfunction handle) : function(handle) {}
  CUfunction function;
};

class DeviceQueue final : public Queue {
 public:
  explicit DeviceQueue(const Context& context) : context_(context) {
    context_.use();
    check(driver().make_stream(&stream_, CU_STREAM_NON_BLOCKING));
  }
  ~DeviceQueue() override {
    try {
      context_.use();
      for (const CUevent event : events_) driver().destroy_event(event);
      driver().destroy_stream(stream_);
    } catch (...) {}  // the driver has gone
  }
  DeviceQueue(const DeviceQueue&) = delete;
  DeviceQueue& operator=(const DeviceQueue&) = delete;

  void upload(void* to, const void* from, std::size_t bytes) override {
    context_.use();
    check(driver().upload(reinterpret_cast<CUdeviceptr>(to), from, bytes, stream_));
  }
  void download(void* to, const void* from, std::size_t bytes) override {
    context_.use();
    check(driver().download(to, reinterpret_cast<CUdeviceptr>(from), bytes, stream_));
  }
  void launch(const Kernel& kernel, const void* body, std::size_t, std::int64_t threads) override {
    context_.use();
    while (events_.size() < 2 * launches_ + 2) {
      CUevent event = nullptr;
      check(driver().make_event(&event, CU_EVENT_DEFAULT));
      events_.push_back(event);
    }
    const auto blocks = static_cast<unsigned>((threads + kThreads - 1) / kThreads);
    void* arguments[] = {const_cast<void*>(body)};
    check(driver().record_event(events_[2 * launches_], stream_));
    check(driver().launch(dynamic_cast<const Function&>(kernel).function, blocks, 1, 1, kThreads, 1, 1, 0,
                          stream_, arguments, nullptr));
    check(driver().record_event(events_[2 * launches_ + 1], stream_));
    ++launches_;
  }
  double wait() override {
    context_.use();
    check(driver().wait_for_stream(stream_));
    double seconds = 0;
    for (std::size_t i = 0; i < launches_; ++i) {
      float milliseconds = 0;
      check(driver().elapsed_time(&milliseconds, events_[2 * i], events_[2 * i + 1]));
      seconds += 1e-3 * static_cast<double>(milliseconds);
    }
    launches_ = 0;
    return seconds;
  }

 private:
  const Context& context_;
  CUstream stream_ = nullptr;
  std::vector<CUevent> events_;  // before and behind each launch since the last wait, and more
  std::size_t launches_ = 0;
};

CUdevice first_device() {
  const Driver& d = driver();
  if (const CUresult result = d.init(0); result == CUDA_ERROR_NO_DEVICE)
    throw InputError("--isa cuda: there is no CUDA device on this machine");
  else check(result);
  int count = 0;
  check(d.device_count(&count));
  if (count == 0) throw InputError("--isa cuda: there is no CUDA device on this machine");
  CUdevice device = 0;
  check(d.device(&device, 0));
  return device;
}

class DeviceEngine final : public Engine {
 public:
  DeviceEngine() : device_(first_device()), context_(device_) {
    char name[256] = {};
    check(driver().device_name(name, sizeof name, device_));
    name_ = name;
    check(driver().device_attribute(&major_, CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR, device_));
    check(driver().device_attribute(&minor_, CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR, device_));
    if (10 * major_ + minor_ < 75)
      throw InputError(fmt::format("--isa cuda needs compute capability 7.5 or newer; {} has {}.{}", name_,
                                   major_, minor_));
  }
  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::unique_ptr<KernelMemory> allocate(std::size_t bytes) const override {
    context_.use();
    return std::make_unique<Memory>(context_, bytes);
  }
  [[nodiscard]] std::unique_ptr<Queue> make_queue() const override {
    return std::make_unique<DeviceQueue>(context_);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> volume_kernel(const std::string& name) const override {
    context_.use();
    const std::scoped_lock lock(mutex_);
    const VolumeImage& image = volume_image_of(name);
    CUmodule& module = volume_modules_[&image - volume_images().data()];
    if (!module) check(driver().load_module(&module, image.data));
    return function_of(module, name.c_str());
  }
  [[nodiscard]] std::shared_ptr<const Kernel> formula_kernel(const SegmentSolverKey& key,
                                                             const Tape& tape) const override {
    return compiled(source_of(key), tape);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> ray_form_kernel(const RayFormKey& key,
                                                              const Tape& tape) const override {
    return compiled(source_of(key), tape);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> beam_kernel(const BeamCastKey& key,
                                                          const Tape& tape) const override {
    return compiled(source_of(key), tape);
  }

 private:
  [[nodiscard]] std::shared_ptr<const Kernel> compiled(const std::string& source, const Tape& tape) const {
    const std::vector<char> program = formula_program(source, tape, architecture_for(10 * major_ + minor_));
    context_.use();
    CUmodule module = nullptr;  // stays: formulas are few
    check(driver().load_module(&module, program.data()));
    return function_of(module, kFormulaKernel);
  }
  [[nodiscard]] static std::shared_ptr<const Kernel> function_of(CUmodule module, const char* name) {
    CUfunction function = nullptr;
    check(driver().find_function(&function, module, name));
    return std::make_shared<Function>(function);
  }

  CUdevice device_;
  Context context_;
  std::string name_;
  int major_ = 0, minor_ = 0;
  mutable std::mutex mutex_;
  mutable std::vector<CUmodule> volume_modules_ = std::vector<CUmodule>(volume_images().size());
};

}  // namespace

std::shared_ptr<const Engine> make_device_engine() { return std::make_shared<DeviceEngine>(); }

}  // namespace isocast
