#include <isocast/cuda/volume_images.h>

// from bin2c
extern "C" {
extern unsigned long long isocast_dense_float[], isocast_dense_double[], isocast_sparse_float[],
    isocast_sparse_double[];
}

namespace isocast {

std::span<const VolumeImage> volume_images() {
  static const VolumeImage images[] = {{"trace_float_tree_", isocast_sparse_float},
                                       {"trace_double_tree_", isocast_sparse_double},
                                       {"trace_float_", isocast_dense_float},
                                       {"trace_double_", isocast_dense_double}};
  return images;
}

const VolumeImage& volume_image_of(const std::string& name) {
  for (const VolumeImage& image : volume_images())
    if (name.starts_with(image.prefix)) return image;
  return volume_images().back();
}

}  // namespace isocast
