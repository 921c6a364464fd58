// A method is one file that fills `light_scale`. Around it stand the coordinates in the map, which all methods begin with; the
// kernel, where methods share one; and shadowIntensity, which remembers the light in front of the method and mixes behind it.

#include "compose/shadow_units.h"

namespace plugc {
namespace {

bool has_gathers(Target target) {
  return target != Target::essl300;
}

/// The function `shadow_kernel_N` of a method that calls one.
std::vector<ShadowUnit> kernel_units(ShadowMethod method, Target target) {
  switch (method) {
    case ShadowMethod::pcf2:  // as many gathers as look-ups would be needed, and they are no quicker
    case ShadowMethod::pcf2_taps: return {{"shadows/taps.glsl", {"TAPS_2"}}};
    case ShadowMethod::pcf3:
      if (has_gathers(target)) return {{"shadows/gather3.glsl", {}}};
      [[fallthrough]];
    case ShadowMethod::pcf3_taps: return {{"shadows/taps.glsl", {"TAPS_3"}}};
    case ShadowMethod::pcf4:
      if (has_gathers(target)) return {{"shadows/gather4.glsl", {}}};
      [[fallthrough]];
    case ShadowMethod::pcf4_taps: return {{"shadows/taps.glsl", {"TAPS_4"}}};
    case ShadowMethod::sharp3:
      if (has_gathers(target)) return {{"shadows/gather3.glsl", {"SLOPE"}}};
      return {{"shadows/taps.glsl", {"TAPS_3", "SLOPE"}}};
    case ShadowMethod::hard:
    case ShadowMethod::bilinear:
    case ShadowMethod::poisson:
    case ShadowMethod::traced:
    case ShadowMethod::vsm:
    case ShadowMethod::evsm:
    case ShadowMethod::msm: break;
  }
  return {};
}

/// The file that fills the plug.
std::string_view method_file(ShadowMethod method) {
  switch (method) {
    case ShadowMethod::hard:
    case ShadowMethod::bilinear: return "shadows/one_tap.glsl";
    case ShadowMethod::sharp3: return "shadows/sharp3.glsl";
    case ShadowMethod::poisson: return "shadows/poisson.glsl";
    case ShadowMethod::traced: return "shadows/traced.glsl";
    case ShadowMethod::vsm: return "shadows/vsm.glsl";
    case ShadowMethod::evsm: return "shadows/evsm.glsl";
    case ShadowMethod::msm: return "shadows/msm.glsl";
    case ShadowMethod::pcf2:
    case ShadowMethod::pcf3:
    case ShadowMethod::pcf4:
    case ShadowMethod::pcf2_taps:
    case ShadowMethod::pcf3_taps:
    case ShadowMethod::pcf4_taps: break;
  }
  return "shadows/pcf.glsl";
}

std::vector<ShadowUnit> flat_units(const LightRecipe& light, Target target) {
  std::vector<ShadowUnit> units;
  units.push_back({"shadows/coord.glsl", light.kind == LightKind::spot ? Features{"PERSPECTIVE"} : Features{}});
  for (ShadowUnit& unit : kernel_units(light.shadow_method, target)) units.push_back(std::move(unit));
  if (keeps_moments(light.shadow_method)) units.push_back({"shadows/share.glsl", {}});
  if (light.shadow_method == ShadowMethod::evsm) units.push_back({"shadows/warp.glsl", {}});
  if (light.shadow_method == ShadowMethod::vsm || light.shadow_method == ShadowMethod::evsm)
    units.push_back({"shadows/chebyshev.glsl", {}});
  units.push_back({method_file(light.shadow_method), {}});
  return units;
}

/// Of a point light, for the methods that method_for_cube() gives.
std::vector<ShadowUnit> cube_units(ShadowMethod method) {
  switch (method) {
    case ShadowMethod::pcf3: return {{"shadows/point_coord.glsl", {"ACROSS"}}, {"shadows/point_pcf3.glsl", {}}};
    case ShadowMethod::poisson: return {{"shadows/point_coord.glsl", {"ACROSS"}}, {"shadows/poisson.glsl", {"POINT"}}};
    default: return {{"shadows/point_coord.glsl", {}}, {"shadows/point_one_tap.glsl", {}}};
  }
}

}  // namespace

std::vector<ShadowUnit> shadow_units(const LightRecipe& light, Target target) {
  std::vector<ShadowUnit> units;
  if (light.shadow_intensity) units.push_back({"shadows/intensity.glsl", {"BEFORE"}});
  const bool traced = light.shadow_method == ShadowMethod::traced;
  auto looking_up = traced                           ? std::vector<ShadowUnit>{{method_file(light.shadow_method), {}}}
                    : light.kind == LightKind::point ? cube_units(light.shadow_method)
                                                     : flat_units(light, target);
  for (ShadowUnit& unit : looking_up) units.push_back(std::move(unit));
  if (light.shadow_intensity) units.push_back({"shadows/intensity.glsl", {"AFTER"}});
  return units;
}

std::vector<ShadowUnit> map_pass_units(MapPass pass) {
  switch (pass) {
    case MapPass::vsm_moments: return {{"shadows/moments.frag", {"VSM"}}};
    case MapPass::evsm_moments: return {{"shadows/warp.glsl", {}}, {"shadows/moments.frag", {"EVSM"}}};
    case MapPass::msm_moments: return {{"shadows/moments.frag", {"MSM"}}};
    case MapPass::blur:
    case MapPass::none: break;
  }
  return {{"shadows/blur.frag", {}}};
}

}  // namespace plugc
