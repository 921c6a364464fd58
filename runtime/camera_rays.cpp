// Near and far plane are parallel to the picture, so that points on them are linear in the pixel's place.

#include "runtime/camera_rays.h"

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {

CameraRays::CameraRays(const View& camera, int width, int height) {
  const glm::dmat4 one(1.0);
  const glm::dmat4 picture_to_eye = glm::inverse(camera.projection) * glm::translate(one, glm::dvec3(-1, -1, 0)) *
                                    glm::scale(one, glm::dvec3(2.0 / width, 2.0 / height, 1));
  const auto at = [&](double x, double y, double depth) {
    const glm::dvec4 eye = picture_to_eye * glm::dvec4(x, y, depth, 1);
    return glm::dvec3(camera.eye_to_world * glm::dvec4(glm::dvec3(eye) / eye.w, 1));
  };
  const auto along = [&](double x, double y) { return at(x, y, 1) - at(x, y, -1); };
  begin_ = at(0, 0, -1);
  begin_x_ = (at(width, 0, -1) - begin_) / double(width);
  begin_y_ = (at(0, height, -1) - begin_) / double(height);
  along_ = along(0, 0);
  along_x_ = (along(width, 0) - along_) / double(width);
  along_y_ = (along(0, height) - along_) / double(height);
}

glm::dvec3 CameraRays::on_plane(double x, double y, const Plane& plane) const {
  const glm::dvec3 begin = begin_ + x * begin_x_ + y * begin_y_;
  const glm::dvec3 along = direction(x, y);
  return begin + along * (glm::dot(plane.normal, plane.point - begin) / glm::dot(plane.normal, along));
}

}  // namespace plugc
