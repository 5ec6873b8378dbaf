// Which methods and settings a picture is benched with.
#pragma once

#include <isocast/apps/scene_build/description.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// A method with some of its options, as --set takes them.
///
/// text   the column `setting`; empty for the defaults
/// swept  a value of the method's own knob, else it is how the method is meant to run
struct MethodSetting {
  std::string method, text;
  std::string_view proves;
  std::map<std::string, std::string> set;
  bool swept = false;
};

/// wanted  names of methods; empty: every method that can be used for the object
/// set     of all settings; then nothing is swept
struct SettingWishes {
  std::vector<std::string> wanted;
  std::map<std::string, std::string> set;
  bool quick = false;
};

/// Every method once as it is, then each with its own knob at several values: eps-rel from 2^-6 to 2^-24,
/// eps of frustum methods from 2^-6 to 2^-20, step from 2^-5 to 2^-12 of `longest` (the domain's edge),
/// iterations from 1 to 10; then with the other value of its switches: stop, certify. Throws InputError for
/// methods and options that there are not.
[[nodiscard]] std::vector<MethodSetting> method_settings(const ObjectDescription& object,
                                                         const SettingWishes& wishes, double longest);

}  // namespace isocast::bench
