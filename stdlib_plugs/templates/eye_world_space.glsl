// The library `castle-shader:/EyeWorldSpace.glsl`: points and directions between world and eye space.
vec4 position_world_to_eye_space(vec4 position)
{
  return castle_CameraMatrix * position;
}

vec4 position_eye_to_world_space(vec4 position)
{
  return castle_CameraInverseMatrix * position;
}

vec3 direction_world_to_eye_space(vec3 direction)
{
  return castle_CameraRotationMatrix * direction;
}

vec3 direction_eye_to_world_space(vec3 direction)
{
  return castle_CameraRotationInverseMatrix * direction;
}
