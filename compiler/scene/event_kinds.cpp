// X3D 4.1: 8.4.1 (TimeSensor), 19.4 (interpolators), 22.4.1 (ProximitySensor), 30.4 (event utilities); the matrices of a
// viewpoint are the reference engine's.

#include "scene/event_kinds.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

using Field = std::string_view;

constexpr std::array<Field, 7> kTimeIn = {"enabled",  "loop",      "cycleInterval", "startTime",
                                          "stopTime", "pauseTime", "resumeTime"};
constexpr std::array<Field, 6> kTimeOut = {"isActive", "isPaused", "fraction_changed", "elapsedTime", "time", "cycleTime"};
constexpr std::array<Field, 3> kProximityIn = {"enabled", "center", "size"};
constexpr std::array<Field, 5> kProximityOut = {"isActive", "enterTime", "exitTime", "position_changed", "orientation_changed"};
constexpr std::array<Field, 4> kCameraOut = {"cameraMatrix", "cameraInverseMatrix", "cameraRotationMatrix",
                                             "cameraRotationInverseMatrix"};
constexpr std::array<Field, 3> kInterpolatorIn = {"set_fraction", "key", "keyValue"};
constexpr std::array<Field, 6> kSplineIn = {"set_fraction", "key", "keyValue", "keyVelocity", "normalizeVelocity", "closed"};
constexpr std::array<Field, 3> kEaseIn = {"set_fraction", "key", "easeInEaseOut"};
constexpr std::array<Field, 5> kSequencerIn = {"set_fraction", "next", "previous", "key", "keyValue"};
constexpr std::array<Field, 1> kValueOut = {"value_changed"};
constexpr std::array<Field, 1> kEaseOut = {"modifiedFraction_changed"};
constexpr std::array<Field, 1> kBooleanIn = {"set_boolean"};
constexpr std::array<Field, 3> kFilterOut = {"inputTrue", "inputFalse", "inputNegate"};
constexpr std::array<Field, 2> kToggleIn = {"set_boolean", "toggle"};
constexpr std::array<Field, 1> kToggleOut = {"toggle"};
constexpr std::array<Field, 1> kTriggerIn = {"set_triggerTime"};
constexpr std::array<Field, 1> kTriggerOut = {"triggerTrue"};
constexpr std::array<Field, 2> kIntegerIn = {"set_boolean", "integerKey"};
constexpr std::array<Field, 1> kIntegerOut = {"triggerValue"};
constexpr std::array<Field, 1> kTimeTriggerOut = {"triggerTime"};

constexpr std::array<EventNodeInfo, 23> kNodes = {{
    {"TimeSensor", EventKind::time_sensor, kTimeIn, kTimeOut},
    {"ProximitySensor", EventKind::proximity_sensor, kProximityIn, kProximityOut},
    {"Viewpoint", EventKind::camera, {}, kCameraOut},
    {"ScalarInterpolator", EventKind::interpolate, kInterpolatorIn, kValueOut},
    {"PositionInterpolator", EventKind::interpolate, kInterpolatorIn, kValueOut},
    {"PositionInterpolator2D", EventKind::interpolate, kInterpolatorIn, kValueOut},
    {"CoordinateInterpolator", EventKind::interpolate, kInterpolatorIn, kValueOut},
    {"CoordinateInterpolator2D", EventKind::interpolate, kInterpolatorIn, kValueOut},
    {"ColorInterpolator", EventKind::interpolate_color, kInterpolatorIn, kValueOut},
    {"NormalInterpolator", EventKind::interpolate_normal, kInterpolatorIn, kValueOut},
    {"OrientationInterpolator", EventKind::interpolate_rotation, kInterpolatorIn, kValueOut},
    {"SplineScalarInterpolator", EventKind::spline, kSplineIn, kValueOut},
    {"SplinePositionInterpolator", EventKind::spline, kSplineIn, kValueOut},
    {"SplinePositionInterpolator2D", EventKind::spline, kSplineIn, kValueOut},
    {"SquadOrientationInterpolator", EventKind::squad, kInterpolatorIn, kValueOut},
    {"EaseInEaseOut", EventKind::ease, kEaseIn, kEaseOut},
    {"IntegerSequencer", EventKind::sequence, kSequencerIn, kValueOut},
    {"BooleanSequencer", EventKind::sequence, kSequencerIn, kValueOut},
    {"BooleanFilter", EventKind::boolean_filter, kBooleanIn, kFilterOut},
    {"BooleanToggle", EventKind::boolean_toggle, kToggleIn, kToggleOut},
    {"BooleanTrigger", EventKind::boolean_trigger, kTriggerIn, kTriggerOut},
    {"IntegerTrigger", EventKind::integer_trigger, kIntegerIn, kIntegerOut},
    {"TimeTrigger", EventKind::time_trigger, kBooleanIn, kTimeTriggerOut},
}};

}  // namespace

const EventNodeInfo* find_event_node(std::string_view type) {
  const auto found = std::ranges::find(kNodes, type, &EventNodeInfo::node);
  return found == kNodes.end() ? nullptr : &*found;
}

int find_field_index(std::span<const std::string_view> fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name);
  return found == fields.end() ? -1 : static_cast<int>(found - fields.begin());
}

}  // namespace plugc
