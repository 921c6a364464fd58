// How deep a vertex lies in the fog: behind the viewer's plane, or as the geometry's FogCoordinate says.
#ifdef FOG_COORD
in float castle_FogCoord;
#endif
out float castle_FogFragCoord;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
#ifdef FOG_COORD
  castle_FogFragCoord = castle_FogCoord;
#else
  castle_FogFragCoord = -vertex_eye.z;
#endif
}
