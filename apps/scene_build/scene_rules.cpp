#include <isocast/apps/scene_build/scene_rules.h>

namespace isocast {
namespace {

using enum RuleKind;
using Keys = std::vector<RecordKey>;

Keys operator+(Keys a, const Keys& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
Rule word(std::string_view name) { return {.kind = text, .meaning = "a type", .choices = {name}}; }

// All rules; they name each other by address.
struct SceneRules {
  // values
  const Rule kNumber = {.kind = number, .meaning = "a number"};
  const Rule kPositive = {.kind = number, .meaning = "a number above 0", .lo = 0, .above = true};
  const Rule kShare = {.kind = number, .meaning = "a number from 0 to 1", .lo = 0, .hi = 1};
  const Rule kAngle = {
      .kind = number, .meaning = "degrees above 0 and below 180", .lo = 0, .hi = 179.999, .above = true};
  const Rule kFlag = {.kind = boolean, .meaning = "true or false"};
  const Rule kText = {.kind = text, .meaning = "a text", .lo = 1, .hi = 1 << 20};
  const Rule kName = {.kind = text, .meaning = "a name", .lo = 1, .hi = 200};
  const Rule kFrame = {.kind = integer, .meaning = "the number of a frame", .lo = 0, .hi = 999999};
  const Rule kThree = {.kind = list, .meaning = "three numbers", .lo = 3, .hi = 3, .parts = {&kNumber}};
  const Rule kFour = {.kind = list, .meaning = "four numbers", .lo = 4, .hi = 4, .parts = {&kNumber}};
  const Rule kRgb = {.kind = list, .meaning = "red, green and blue", .lo = 3, .hi = 3, .parts = {&kShare}};
  const Rule kHex = {.kind = text, .meaning = "a colour such as \"#d9a066\"", .lo = 7, .hi = 7};
  const Rule kColor = {
      .kind = either, .meaning = "a colour, [r, g, b] or \"#rrggbb\"", .parts = {&kRgb, &kHex}};
  const Rule kNumbers = {
      .kind = list, .meaning = "a list of numbers", .lo = 1, .hi = 1000, .parts = {&kNumber}};
  const Rule kShares = {
      .kind = list, .meaning = "a list of numbers from 0 to 1", .lo = 1, .hi = 1000, .parts = {&kShare}};
  const Rule kNumberOrList = {
      .kind = either, .meaning = "a number or a list of numbers", .parts = {&kNumber, &kNumbers}};
  const Rule kShareOrList = {
      .kind = either, .meaning = "a number from 0 to 1 or a list of them", .parts = {&kShare, &kShares}};
  // [r, g, b] or a list of colours: told apart by the elements
  const Rule kColorPart = {.kind = either,
                           .meaning = "a colour or a share of red, green or blue",
                           .parts = {&kShare, &kRgb, &kHex}};
  const Rule kColorList = {
      .kind = list, .meaning = "a colour or a list of colours", .lo = 1, .hi = 1000, .parts = {&kColorPart}};
  const Rule kColors = {
      .kind = either, .meaning = "a colour or a list of colours", .parts = {&kColorList, &kHex}};

  const Rule kInterval = {.kind = list, .meaning = "[lo, hi]", .lo = 2, .hi = 2, .parts = {&kNumber}};
  const Rule kDomain = {.kind = list,
                        .meaning = "[[x lo, x hi], [y lo, y hi], [z lo, z hi]]",
                        .lo = 3,
                        .hi = 3,
                        .parts = {&kInterval}};
  const Rule kParameters = {.kind = record, .meaning = "parameters by name", .others = &kNumber};
  const Rule kSetting = {.kind = either, .meaning = "a number or a word", .parts = {&kNumber, &kName}};
  const Rule kSettings = {.kind = record, .meaning = "options of the method", .others = &kSetting};
  const Rule kWhole = {.kind = integer, .meaning = "a whole number above 0", .lo = 1, .hi = 1 << 30};
  const Rule kDims = {
      .kind = list, .meaning = "three whole numbers above 0", .lo = 3, .hi = 3, .parts = {&kWhole}};
  const Rule kBytes = {.kind = integer, .meaning = "a number of bytes", .lo = 0, .hi = 1e15};
  const Rule kSampleType = {.kind = text,
                            .meaning = "a sample type",
                            .choices = {"u8", "i8", "u16", "i16", "u32", "i32", "f16", "f32", "f64"}};
  const Rule kEndian = {.kind = text, .meaning = "a byte order", .choices = {"little", "big"}};

  // cameras, lights, background
  const Rule kCamera = {
      .kind = record,
      .meaning = "a camera",
      .keys = {{"position", &kThree, "where it stands; default: so that it sees everything"},
               {"target", &kThree, "what it looks at; default: the middle of the scene"},
               {"up", &kThree, "default: [0, 0, 1]"},
               {"fov", &kAngle, "vertical angle; default: 45"},
               {"ortho", &kPositive, "instead of fov: height of the picture, orthographic"}}};
  const Rule kCameras = {.kind = record, .meaning = "cameras by name", .others = &kCamera};
  const Rule kDirectionalType = {.kind = text, .meaning = "a kind of light", .choices = {"directional"}};
  const Rule kOcclusionType = {.kind = text, .meaning = "a kind of light", .choices = {"ambient_occlusion"}};
  const Rule kSamples = {.kind = integer, .meaning = "a number of rays from 1 to 4096", .lo = 1, .hi = 4096};
  const Rule kDirectional = {
      .kind = record,
      .meaning = "a light from far away",
      .keys = {{"type", &kDirectionalType, "", true}, {"direction", &kThree, "towards the light", true}}};
  const Rule kOcclusion = {
      .kind = record,
      .meaning = "light from everywhere",
      .keys = {{"type", &kOcclusionType, "", true},
               {"samples", &kSamples, "rays from every hit; default: 16"},
               {"radius", &kPositive, "how far away something may occlude; default: anywhere"}}};
  const Rule kLight = {.kind = tagged, .meaning = "a light", .parts = {&kDirectional, &kOcclusion}};
  const Rule kLights = {.kind = list, .meaning = "a list of lights", .lo = 0, .hi = 9, .parts = {&kLight}};
  const Rule kSky = {.kind = record,
                     .meaning = "an environment",
                     .keys = {{"environment", &kText, "picture of all directions, z up", true}}};
  const Rule kBackground = {
      .kind = either, .meaning = "a colour or an environment", .parts = {&kRgb, &kHex, &kSky}};

  // what objects share
  const Rule kMaterial = {
      .kind = record,
      .meaning = "a material",
      .keys = {{"color", &kColors, "per iso-value, repeated; numbers are linear, #rrggbb is sRGB"},
               {"opacity", &kShareOrList, "share of the light from behind that is kept out; default: 1"},
               {"reflectivity", &kShareOrList, "share of the colour that is mirrored; default: 0"},
               {"specular", &kShareOrList, "strength of the highlight; default: 0.12"}}};
  const Rule kScale = {.kind = either, .meaning = "a number or three numbers", .parts = {&kNumber, &kThree}};
  const Rule kMatrix = {
      .kind = list, .meaning = "three rows of four numbers", .lo = 3, .hi = 3, .parts = {&kFour}};
  const Rule kTransform = {.kind = record,
                           .meaning = "a transform",
                           .keys = {{"scale", &kScale, "first"},
                                    {"rotate", &kFour, "then: axis x, y, z, degrees"},
                                    {"translate", &kThree, "then"},
                                    {"matrix", &kMatrix, "instead of these: rows [a, b, c, shift]"}}};
  const Rule kBox = {.kind = list, .meaning = "[lo, hi], two points", .lo = 2, .hi = 2, .parts = {&kThree}};
  const Rule kClip = {.kind = record,
                      .meaning = "a solid that keeps what lies in it: one of plane, box and formula",
                      .keys = {{"plane", &kFour, "where a x + b y + c z + d <= 0"},
                               {"box", &kBox, "between two corners"},
                               {"formula", &kText, "where it is not positive"},
                               {"params", &kParameters, "of the formula"}}};
  const Rule kClips = {.kind = list, .meaning = "a list of solids", .lo = 0, .hi = 64, .parts = {&kClip}};
  const Rule kMap = {.kind = text, .meaning = "a colour map's name or a ParaView .json", .lo = 1, .hi = 4096};
  const Rule kColorBy = {
      .kind = record,
      .meaning = "colours by another field: a file or a formula",
      .keys = {{"file", &kText, "a volume"},
               {"expr", &kText, "a formula of x y z w"},
               {"params", &kParameters, "of the formula"},
               {"map", &kMap, "viridis (default) plasma magma inferno grey coolwarm, or a file"},
               {"range", &kInterval, "values of the ends of the map"},
               {"log", &kFlag, "the map follows the logarithm"},
               {"nan_color", &kColor, "where there is no value; default: the map's"},
               {"dims", &kDims, "of a .raw file"},
               {"sample_type", &kSampleType, "of a .raw file"},
               {"endian", &kEndian, "of a .raw file"},
               {"skip", &kBytes, "of a .raw file"},
               {"grid", &kName, "of a .vdb or .nvdb file"}}};
  const Rule kNormals = {
      .kind = text, .meaning = "a kind of normal", .choices = {"gradient", "difference", "neighbour"}};

  // objects
  const Rule kVolumeType = word("volume"), kFormulaType = word("formula"), kSurfaceType = word("surface"),
             kMeshType = word("mesh"), kInstanceType = word("instance"), kCsgType = word("csg");
  const Keys kMethodKeys = {{"iso", &kNumberOrList, "iso-values"},
                            {"method", &kName, "auto, or a name that 'isocast methods' lists"},
                            {"set", &kSettings, "options of the method"},
                            {"normals", &kNormals, "default: gradient"}};
  const Keys kFormulaKeys =
      Keys{{"domain", &kDomain, "the box; default: [-1, 1] on each axis, or the catalogue's"},
           {"params", &kParameters, "parameters of the formula"},
           {"time", &kNumber, "the variable w; default: the scene's time"},
           {"color_components", &kFlag, "materials belong to the operands of min and max"}} +
      kMethodKeys;
  const Rule kVolume = object(kVolumeType, "a volume",
                              Keys{{"file", &kText, "relative to the scene; %04d: the frame's number", true},
                                   {"dims", &kDims, "of a .raw file"},
                                   {"sample_type", &kSampleType, "of a .raw file"},
                                   {"endian", &kEndian, "of a .raw file"},
                                   {"skip", &kBytes, "of a .raw file: bytes before the samples"},
                                   {"grid", &kName, "of a .vdb or .nvdb file"}} +
                                  kMethodKeys);
  const Rule kFormula =
      object(kFormulaType, "a formula", Keys{{"expr", &kText, "f(x, y, z, w)", true}} + kFormulaKeys);
  const Rule kSurface = object(kSurfaceType, "a surface of the catalogue",
                               Keys{{"id", &kName, "as 'isocast surfaces' lists it", true}} + kFormulaKeys);
  const Rule kMesh =
      object(kMeshType, "a mesh", Keys{{"file", &kText, ".obj or .ply; %04d: the frame's number", true}});
  const Rule kPlaces = {
      .kind = list, .meaning = "a list of transforms", .lo = 1, .hi = 65000, .parts = {&kTransform}};
  const Rule kInstance =
      object(kInstanceType, "copies of an object",
             Keys{{"of", &kName, "name of the object", true}, {"transforms", &kPlaces, "a copy each", true}});
  const Rule kOperation = {
      .kind = text, .meaning = "an operation", .choices = {"union", "intersection", "difference"}};
  const Rule kOperands = {
      .kind = list, .meaning = "a list of objects", .lo = 2, .hi = 1000, .parts = {&kObject}};
  const Rule kCsg = object(kCsgType, "a solid of closed objects",
                           Keys{{"op", &kOperation, "difference: the first without the others", true},
                                {"of", &kOperands, "the objects", true}});
  const Rule kObject = {.kind = tagged,
                        .meaning = "an object",
                        .parts = {&kVolume, &kFormula, &kSurface, &kMesh, &kInstance, &kCsg},
                        .name = "object"};
  const Rule kObjects = {
      .kind = list, .meaning = "a list of objects", .lo = 1, .hi = 65000, .parts = {&kObject}};

  // The record of one type of object.
  [[nodiscard]] Rule object(const Rule& type, std::string_view meaning, const Keys& own) const {
    const Keys shared = {{"type", &type, "", true},
                         {"name", &kName, "for messages, animation and instances"},
                         {"visible", &kFlag, "default: true; else only its instances are there"},
                         {"material", &kMaterial, "how it looks"},
                         {"transform", &kTransform, "from its own space into the world's"},
                         {"clip", &kClips, "what lies in all of these is kept, in the world's space"},
                         {"color_by", &kColorBy, "colours by another field"}};
    return {.kind = record, .meaning = meaning, .keys = shared + own};
  }

  // animation
  const Rule kIsoByName = {.kind = record, .meaning = "iso-values by object", .others = &kNumberOrList};
  const Rule kAnimationKey = {.kind = record,
                              .meaning = "a key",
                              .keys = {{"frame", &kFrame, "", true},
                                       {"time", &kNumber, "the scene's time"},
                                       {"camera", &kName, "one of cameras"},
                                       {"params", &kParameters, "\"object.parameter\": value"},
                                       {"iso", &kIsoByName, "\"object\": iso-values"}}};
  const Rule kAnimationKeys = {
      .kind = list, .meaning = "a list of keys", .lo = 0, .hi = 100000, .parts = {&kAnimationKey}};
  const Rule kFrames = {.kind = list, .meaning = "[first, last] frame", .lo = 2, .hi = 2, .parts = {&kFrame}};
  const Rule kAnimation = {.kind = record,
                           .meaning = "an animation",
                           .keys = {{"frames", &kFrames, "first and last", true},
                                    {"keys", &kAnimationKeys, "values between keys are interpolated"}}};

  const Rule kVersion = {.kind = integer, .meaning = "1, the version of the format", .lo = 1, .hi = 1};
  const Rule kPixels = {
      .kind = integer, .meaning = "a number of pixels from 1 to 32768", .lo = 1, .hi = 32768};
  const Rule kSize = {
      .kind = list, .meaning = "[width, height] in pixels", .lo = 2, .hi = 2, .parts = {&kPixels}};
  const Rule kSpp = {.kind = integer, .meaning = "samples from 1 to 4096", .lo = 1, .hi = 4096};
  const Rule kDepth = {.kind = integer, .meaning = "a number of layers from 1 to 64", .lo = 1, .hi = 64};
  const Rule kBounces = {
      .kind = integer, .meaning = "a number of reflections from 0 to 16", .lo = 0, .hi = 16};

  const Rule kScene = {
      .kind = record,
      .meaning = "a scene",
      .keys = {{"isocast", &kVersion, "version of the format", true},
               {"objects", &kObjects, "what is seen", true},
               {"camera", &kCamera, "from where"},
               {"cameras", &kCameras, "or several, by name; without a choice the first by the alphabet"},
               {"clip", &kClips, "of every object only what lies in all of these is kept"},
               {"lights", &kLights, "default: a headlight"},
               {"shadows", &kFlag, "of the directional lights; default: false"},
               {"background", &kBackground, "default: white"},
               {"time", &kNumber, "the variable w of formulas; default: 0"},
               {"animation", &kAnimation, "what changes from frame to frame"},
               {"size", &kSize, "of the picture; default: [1024, 1024]"},
               {"spp", &kSpp, "samples per pixel; default: 1"},
               {"transparency_depth", &kDepth, "crossings that a ray passes; default: 4"},
               {"reflections", &kBounces, "how often a ray is mirrored; default: 1"}}};
};

}  // namespace

const Rule& scene_rule() {
  static const SceneRules rules;
  return rules.kScene;
}

}  // namespace isocast
