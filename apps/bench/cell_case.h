// One case of cells through some intersectors: errors once, times in turns.
#pragma once

#include <isocast/apps/bench/timing.h>
#include <isocast/apps/reference/cell_reference.h>
#include <isocast/isa/cpu.h>
#include <isocast/volume/methods.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace isocast::bench {

/// A method with some of its options, as --set takes them. `text` is the column `setting`.
struct CellSetting {
  std::string method, text;
  std::map<std::string, std::string> set;
  CellMethodChoice choice;
};
/// Throws InputError for methods and options that there are not.
[[nodiscard]] CellSetting cell_setting(const std::string& method,
                                       const std::map<std::string, std::string>& set = {});

/// Cells with the truth about them, of which there is as much.
struct CellCase {
  std::string suite, name;
  std::vector<reference::CellChord> chords;
  std::vector<reference::CellReference> truth;
};

/// precisions  "float", "double". Errors are the same on all instruction sets, and computed once
struct CellCaseOptions {
  std::vector<Isa> isas = available_isas();
  std::vector<std::string> precisions = {"float", "double"};
  Repetitions repetitions = 7;
};

/// A row for each precision, setting and instruction set, in this order. t errors are |s - s_reference| times
/// the chord's length, in voxels; normal errors the angle between the gradients of the trilinear field at the
/// two points. Seconds are the processor time of one thread.
[[nodiscard]] std::vector<Row> run_cell_case(const CellCase& cells, std::span<const CellSetting> settings,
                                             const CellCaseOptions& options);

}  // namespace isocast::bench
