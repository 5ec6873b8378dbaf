// A volume in the memory that kernels see.
#pragma once

#include <isocast/cuda/engine.h>
#include <isocast/volume/volume_tracer.h>

#include <vector>

namespace isocast {

/// Copies all that a query's pointers lead to.
class VolumeMemory {
 public:
  VolumeMemory(const Engine& engine, const VolumeQuery& query, const VolumeParts& parts);

  /// The query with pointers into this memory; `cells`, a table of this processor's functions, is null.
  [[nodiscard]] VolumeQuery translated(VolumeQuery query) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] const void* copied(const void* from, std::size_t bytes);
  void copy_grid(const VolumeQuery& query);
  void copy_tree(const VolumeQuery& query, const VolumeParts& parts);

  const Engine& engine_;
  std::unique_ptr<Queue> queue_;
  std::vector<std::unique_ptr<KernelMemory>> pieces_;
  GridView grid_ = {};
  SparseView tree_ = {};
  SparseRanges ranges_ = {};
};

}  // namespace isocast
