#include "scene/stage.h"

#include <fmt/format.h>

namespace plugc {
namespace {

struct StageShape {
  std::string_view classic;
  std::string_view xml;
};

StageShape stage_shape(std::string_view name) {
  if (name == "sphere") return {"Sphere { radius 1.2 }", "<Sphere radius='1.2'/>"};
  if (name == "box") return {"Box { }", "<Box/>"};
  if (name == "plane") {
    return {"ElevationGrid { xDimension 2 zDimension 2 xSpacing 4 zSpacing 4 height [ 0 0 0 0 ] solid FALSE }",
            "<ElevationGrid xDimension='2' zDimension='2' xSpacing='4' zSpacing='4' height='0 0 0 0' solid='false'/>"};
  }
  return {"Teapot { }", "<Teapot/>"};
}

}  // namespace

std::string stage_statements(std::string_view name) {
  return fmt::format(R"(
Viewpoint {{ position 0 1.6 7 orientation 1 0 0 -0.2 }}
NavigationInfo {{ headlight FALSE }}
DirectionalLight {{ direction -0.3 -0.4 -1 intensity 0.5 global TRUE }}
SpotLight {{ location 2.5 5 3 direction -2.5 -5.2 -3 cutOffAngle 0.6 beamWidth 0.5 shadows TRUE
  defaultShadowMap GeneratedShadowMap {{ update "ALWAYS" size 1024 }} }}
Shape {{ appearance Appearance {{ material Material {{ diffuseColor 0.8 0.6 0.4 specularColor 0.4 0.4 0.4 }} }} geometry {} }}
Transform {{ translation 0 -1.3 0 children Shape {{
  appearance Appearance {{ material Material {{ }} }} geometry Box {{ size 8 0.1 8 }} }} }}
)",
                     stage_shape(name).classic);
}

std::string stage_elements(std::string_view name) {
  return fmt::format(R"(
<Viewpoint position='0 1.6 7' orientation='1 0 0 -0.2'/>
<NavigationInfo headlight='false'/>
<DirectionalLight direction='-0.3 -0.4 -1' intensity='0.5' global='true'/>
<SpotLight location='2.5 5 3' direction='-2.5 -5.2 -3' cutOffAngle='0.6' beamWidth='0.5' shadows='true'>
  <GeneratedShadowMap containerField='defaultShadowMap' update='ALWAYS' size='1024'/></SpotLight>
<Shape><Appearance><Material diffuseColor='0.8 0.6 0.4' specularColor='0.4 0.4 0.4'/></Appearance>{}</Shape>
<Transform translation='0 -1.3 0'><Shape><Appearance><Material/></Appearance><Box size='8 0.1 8'/></Shape></Transform>
)",
                     stage_shape(name).xml);
}

}  // namespace plugc
