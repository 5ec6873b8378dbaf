// isocast render: a picture of the iso-surfaces of a volume or a formula.
#include <isocast/apps/isocast/render_frames.h>
#include <isocast/apps/isocast/scene_options.h>
#include <isocast/apps/isocast/verbs.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace isocast::verbs {

void add_picture_options(CLI::App* verb, RenderWords* w) {
  add_scene_options(
      *verb, *w,
      "auto (marmitt for volumes, interval, affine or certified for formulas), or a name that 'isocast "
      "methods' lists");
  verb->add_option("--colors", w->colors, "A colour per iso-value: #rrggbb[,#rrggbb...]");
  verb->add_option("--opacity", w->opacity, "0 to 1 per iso-value, A[,A...] (default 1)");
  verb->add_option("--reflectivity", w->reflectivity,
                   "The mirrored share of the colour per iso-value, 0 to 1, R[,R...] (default 0)");
  verb->add_option("--clip", w->clips,
                   "A formula g(x,y,z): only what lies where g <= 0 is there; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FORMULA");
  verb->add_option("--spp", w->spp,
                   "Samples per pixel for the colour; layers are those of the centre (default 1)")
      ->check(CLI::Range(1, 4096));
  verb->add_option(
          "--aa", w->aa,
          "How edges are smoothed: none, spp (by --spp samples, 4 where it is not given), silhouette "
          "(formulas: the edges between pixels are found) or coverage (a formula: pixels are blended by the "
          "shares that it covers, and what is thinner than a pixel does not vanish)")
      ->check(CLI::IsMember({"none", "spp", "silhouette", "coverage"}));
  verb->add_option("--light", w->lights,
                   "X,Y,Z: direction towards a directional light; up to 8 times, n lights have 1/n of the "
                   "strength each (default: a headlight)")
      ->allow_extra_args(false);
  verb->add_flag("--color-components", w->by_component,
                 "Materials belong to the operands of a formula's min and max instead of to iso-values");
  verb->add_flag("--shadows", w->shadows,
                 "Hard shadows of the directional lights; what is not opaque lets light through");
  verb->add_option(
          "--transparency-depth", w->transparency_depth,
          "Crossings that a ray passes; where more lie behind, the last counts as opaque (default 4)")
      ->check(CLI::Range(1, 64));
  verb->add_option("--reflections", w->reflections,
                   "How often a ray is mirrored where --reflectivity says so (default 1)")
      ->check(CLI::Range(0, 16));
  verb->add_option("--ambient-occlusion", w->ambient_occlusion,
                   "Light from everywhere, as far as nothing is in its way: rays per hit (default 0: none)")
      ->check(CLI::Range(0, 4096));
  verb->add_option("--ambient-occlusion-radius", w->ambient_occlusion_radius,
                   "How far away something may be in its way, in world units (default: anywhere)");
  verb->add_option(
          "--filter", w->filter,
          "How --spp samples lie around a pixel's centre: box (default), triangle, gaussian or blackman")
      ->check(CLI::IsMember({"box", "triangle", "gaussian", "blackman"}));
  verb->add_option("--environment", w->environment,
                   "Picture of all directions (longitude by latitude, z up; .exr .hdr .png .jpg), seen where "
                   "nothing is hit and in reflections (default: white)");
  verb->add_option("--normals", w->normals,
                   "gradient (exact; of the cell of a volume), difference (central differences, smooth) or "
                   "neighbour (formulas: from the pixels beside it)")
      ->check(CLI::IsMember({"gradient", "difference", "neighbour"}));
  verb->add_option("--precision", w->precision, "float (default), double, or mixed (frustum methods)")
      ->check(CLI::IsMember({"float", "double", "mixed"}));
  verb->add_option("--threads", w->threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
}

void add_render(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "render", "Pictures of iso-surfaces of a volume or a formula: PNG, or EXR with layers");
  const auto w = std::make_shared<RenderWords>();
  add_picture_options(verb, w.get());
  verb->add_option("-o", w->output,
                   "The picture: .png (sRGB) or .exr (linear, with layers); %04d is the frame's number")
      ->required();
  verb->add_option(
      "--frames", w->frames,
      "FIRST:LAST, the frames of an animation, of --time FROM:TO or of --iso-sweep (default: all)");
  verb->add_option("--shard", w->shard, "I/N: every N-th frame from the I-th on, I from 1 to N");
  verb->add_flag(
      "--resume", w->resume,
      "Frames that are there are not rendered again: whole files of the same scene, inputs, options "
      "and version, as the manifest beside them says");
  verb->add_option("--iso-sweep", w->iso_sweep,
                   "FROM:TO:COUNT, a frame per value: OUT_0000.png, OUT_0001.png, ...");
  verb->add_option("--aov", w->aov,
                   "Layers of the EXR: depth,z,normal,position,id,object,value,albedo,cost,certificate");
  verb->add_option(
          "--exr-names", w->exr_names,
          "Names of the EXR's channels: plain (as --aov has them), or compositor (Z, depth.Z, N.X, P.X, ...)")
      ->check(CLI::IsMember({"plain", "compositor"}));
  verb->add_option("--stats", w->stats, "What was done, as JSON, to a file or - for stdout");
  verb->callback([w] { render_frames(*w, ISOCAST_VERSION); });
}

}  // namespace isocast::verbs
