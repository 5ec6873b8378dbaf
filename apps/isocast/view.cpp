// isocast view: a window with the iso-value slider.
#include <isocast/apps/isocast/verbs.h>

namespace isocast::verbs {

void add_view(CLI::App& /*app*/) {}

}  // namespace isocast::verbs
