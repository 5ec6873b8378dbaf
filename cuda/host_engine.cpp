#include <fmt/format.h>
#include <isocast/cuda/host_engine.h>
#include <isocast/cuda/host_kernels.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/isa/cpu.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <new>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace isocast {
namespace one_ray {
HostFormulaKernel formula_kernel_of(const SegmentSolverKey& key);
HostFormulaKernel ray_form_kernel_of(const RayFormKey& key);
HostFormulaKernel beam_kernel_of(const BeamCastKey& key);
}  // namespace one_ray
namespace one_ray_nearest {
HostFormulaKernel formula_kernel_of(const SegmentSolverKey& key);
}
namespace {

class Memory final : public KernelMemory {
 public:
  explicit Memory(std::size_t bytes)
      : bytes_(bytes), data_(::operator new(bytes, std::align_val_t(kAlignment))) {
    std::memset(data_, 0xa5, bytes);  // a device's memory holds anything
  }
  ~Memory() override { ::operator delete(data_, std::align_val_t(kAlignment)); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  [[nodiscard]] void* data() const override { return data_; }
  [[nodiscard]] std::size_t bytes() const override { return bytes_; }

 private:
  static constexpr std::size_t kAlignment = 256;
  std::size_t bytes_;
  void* data_;
};

struct Function final : Kernel {
  HostKernel* run = nullptr;
  std::size_t register_bytes = 0;
};

std::vector<std::int32_t> order_of(std::int32_t count, std::uint64_t seed) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  if (seed) std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
  return order;
}

class HostQueue final : public Queue {
 public:
  explicit HostQueue(const HostLaunches& launches) : launches_(launches) {}
  void upload(void* to, const void* from, std::size_t bytes) override { std::memcpy(to, from, bytes); }
  void download(void* to, const void* from, std::size_t bytes) override { std::memcpy(to, from, bytes); }
  void launch(const Kernel& kernel, const void* body, std::size_t, std::int64_t threads) override {
    const DefaultFloatEnvironment environment;
    const auto& function = dynamic_cast<const Function&>(kernel);
    const auto start = std::chrono::steady_clock::now();
    // doubles: aligned for every kind of register
    std::vector<double> registers(function.register_bytes / sizeof(double) + 1);
    const auto blocks = static_cast<std::int32_t>((threads + launches_.threads - 1) / launches_.threads);
    for (const std::int32_t block : order_of(blocks, launches_.shuffle))
      for (const std::int32_t thread : order_of(launches_.threads, launches_.shuffle))
        function.run(body, block, thread, launches_.threads, registers.data());
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  double wait() override { return std::exchange(seconds_, 0); }

 private:
  HostLaunches launches_;
  double seconds_ = 0;
};

class HostEngine final : public Engine {
 public:
  explicit HostEngine(const HostLaunches& launches) : launches_(launches) {}
  [[nodiscard]] std::string name() const override { return "host"; }
  [[nodiscard]] std::unique_ptr<KernelMemory> allocate(std::size_t bytes) const override {
    return std::make_unique<Memory>(bytes);
  }
  [[nodiscard]] std::unique_ptr<Queue> make_queue() const override {
    return std::make_unique<HostQueue>(launches_);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> volume_kernel(const std::string& name) const override {
    auto function = std::make_shared<Function>();
    function->run = host_volume_kernel(name);
    if (!function->run) throw std::logic_error(fmt::format("there is no kernel '{}'", name));
    return function;
  }
  [[nodiscard]] std::shared_ptr<const Kernel> formula_kernel(const SegmentSolverKey& key,
                                                             const Tape& tape) const override {
    return function_of(
        key.nearest ? one_ray_nearest::formula_kernel_of(key) : one_ray::formula_kernel_of(key), tape);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> ray_form_kernel(const RayFormKey& key,
                                                              const Tape& tape) const override {
    return function_of(one_ray::ray_form_kernel_of(key), tape);
  }
  [[nodiscard]] std::shared_ptr<const Kernel> beam_kernel(const BeamCastKey& key,
                                                          const Tape& tape) const override {
    return function_of(one_ray::beam_kernel_of(key), tape);
  }

 private:
  static std::shared_ptr<const Kernel> function_of(const HostFormulaKernel& kernel, const Tape& tape) {
    auto function = std::make_shared<Function>();
    function->run = kernel.run;
    function->register_bytes = tape.registers * kernel.register_bytes;
    return function;
  }

  HostLaunches launches_;
};

}  // namespace

std::shared_ptr<const Engine> make_host_engine(const HostLaunches& launches) {
  return std::make_shared<HostEngine>(launches);
}

}  // namespace isocast
