// The verbs of the program: each adds its subcommand with its options and the callback that runs it.
#pragma once

namespace CLI {
class App;
}

namespace isocast::verbs {


}  // namespace isocast::verbs
