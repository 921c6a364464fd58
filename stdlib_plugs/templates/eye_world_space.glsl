// The library `castle-shader:/EyeWorldSpace.glsl`: points and directions between world and eye space. Of its functions there
// are those that some part names.
#ifdef POSITION_WORLD_TO_EYE
vec4 position_world_to_eye_space(vec4 position)
{
  return castle_CameraMatrix * position;
}
#endif
#ifdef POSITION_EYE_TO_WORLD
vec4 position_eye_to_world_space(vec4 position)
{
  return castle_CameraInverseMatrix * position;
}
#endif
#ifdef DIRECTION_WORLD_TO_EYE
vec3 direction_world_to_eye_space(vec3 direction)
{
  return castle_CameraRotationMatrix * direction;
}
#endif
#ifdef DIRECTION_EYE_TO_WORLD
vec3 direction_eye_to_world_space(vec3 direction)
{
  return castle_CameraRotationInverseMatrix * direction;
}
#endif
