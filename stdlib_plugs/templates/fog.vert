// How deep a vertex lies in the fog: behind the viewer's plane, as the geometry's FogCoordinate says, or, of a fog in layers, below
// its upper bound.
#ifdef FOG_COORD
in float castle_FogCoord;
#endif
#ifdef FOG_PLANE
uniform vec4 castle_FogPlane;
#endif
out float castle_FogFragCoord;

void PLUG_vertex_eye_space(const in vec4 vertex_eye, const in vec3 normal_eye)
{
#ifdef FOG_COORD
  castle_FogFragCoord = castle_FogCoord;
#else
#ifdef FOG_PLANE
  castle_FogFragCoord = max(dot(castle_FogPlane, vertex_eye), 0.0);
#else
  castle_FogFragCoord = -vertex_eye.z;
#endif
#endif
}
