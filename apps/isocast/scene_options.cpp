#include <isocast/apps/isocast/scene_options.h>
#include <isocast/apps/isocast/volume_options.h>

#include <CLI/CLI.hpp>

namespace isocast {

void add_scene_options(CLI::App& verb, RenderWords& w, const char* method) {
  verb.add_option("INPUT", w.input,
                  "A scene .json, a volume file, a formula of x y z w, a .vm tape, or @id of the catalogue")
      ->required();
  verb.add_option(
      "--iso", w.iso,
      "Iso-values V[,V...] in the file's units (default: the best of suggested_iso; 0 for formulas)");
  verb.add_option("--param", w.params, "A parameter of the formula, such as a=2")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  verb.add_option("--domain", w.domain,
                  "Box of a formula: LO,HI or XLO,XHI,YLO,YHI,ZLO,ZHI (default: -1,1, or the catalogue's)");
  verb.add_option("--time", w.time, "The variable w of a formula (default 0)");
  verb.add_option("--method", w.method, method);
  verb.add_option("--set", w.set, "An option of the method, KEY=VALUE")->allow_extra_args(false);
  verb.add_option("--size", w.size, "WIDTHxHEIGHT in pixels (default 1024x1024)");
  verb.add_option("--camera", w.camera, "One of a scene's cameras, by name (default: the first)");
  verb.add_option("--camera-position", w.position, "X,Y,Z in world units (default: frames the volume)");
  verb.add_option("--camera-target", w.target, "X,Y,Z in world units");
  verb.add_option("--camera-up", w.up, "X,Y,Z (default 0,0,1)");
  CLI::Option* fov = verb.add_option("--fov", w.fov, "Vertical field of view in degrees (default 45)");
  verb.add_option("--ortho", w.ortho, "Orthographic camera: height of the picture in world units")
      ->excludes(fov);
  verb.add_option("--isa", w.isa, "auto, scalar, sse4, avx2 or avx512: the same picture with each; or cuda, a GPU");
  add_read_options(verb, w.read);
}

}  // namespace isocast
