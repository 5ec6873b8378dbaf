#include <math/pack_operations.h>

namespace isocast {

namespace scalar {
extern const test::PackOperations pack_operation_table;
}
namespace sse4 {
extern const test::PackOperations pack_operation_table;
}
namespace avx2 {
extern const test::PackOperations pack_operation_table;
}
namespace avx512 {
extern const test::PackOperations pack_operation_table;
}

const test::PackOperations& test::pack_operations(Isa isa) {
  static const PackOperations* const tables[kIsaCount] = {
      &scalar::pack_operation_table, &sse4::pack_operation_table, &avx2::pack_operation_table,
      &avx512::pack_operation_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
