// What the shader of a ScreenEffect may ask. Positions are in pixels from the lower left corner, whole numbers or with the middle of
// a pixel at .5; those with `01` run from 0 to 1 over the picture. `screen` is what is drawn so far.
#ifdef WIDTH
uniform int screen_width;
#endif
#ifdef HEIGHT
uniform int screen_height;
#endif
#ifdef COLOR
uniform sampler2D screen;
#endif
#ifdef DEPTH
uniform sampler2D screen_depth;
#endif
#ifdef POSITION_01
in vec2 screenf_01_position;
#endif
#ifdef POSITION

ivec2 screen_position()
{
  return ivec2(gl_FragCoord.xy);
}
#endif
#ifdef X

int screen_x()
{
  return int(gl_FragCoord.x);
}
#endif
#ifdef Y

int screen_y()
{
  return int(gl_FragCoord.y);
}
#endif
#ifdef GET_COLOR

vec4 screen_get_color(const in ivec2 position)
{
  return texelFetch(screen, clamp(position, ivec2(0), textureSize(screen, 0) - 1), 0);
}
#endif
#ifdef F_POSITION

vec2 screenf_position()
{
  return gl_FragCoord.xy;
}
#endif
#ifdef F_X

float screenf_x()
{
  return gl_FragCoord.x;
}
#endif
#ifdef F_Y

float screenf_y()
{
  return gl_FragCoord.y;
}
#endif
#ifdef F_GET_COLOR

vec4 screenf_get_color(const in vec2 position)
{
  return texture(screen, position / vec2(textureSize(screen, 0)));
}
#endif
#ifdef F_01_GET_COLOR

vec4 screenf_01_get_color(const in vec2 position)
{
  return texture(screen, position);
}
#endif
#ifdef F_GET_ORIGINAL_COLOR

vec4 screenf_get_original_color()
{
  return texelFetch(screen, ivec2(gl_FragCoord.xy), 0);
}
#endif
#ifdef GET_DEPTH

float screen_get_depth(const in ivec2 position)
{
  return texelFetch(screen_depth, clamp(position, ivec2(0), textureSize(screen_depth, 0) - 1), 0).r;
}
#endif
#ifdef GET_DEPTH_FAST

float screen_get_depth_fast(const in ivec2 position)
{
  return texelFetch(screen_depth, clamp(position, ivec2(0), textureSize(screen_depth, 0) - 1), 0).r;
}
#endif
#ifdef F_GET_DEPTH

float screenf_get_depth(const in vec2 position)
{
  return texture(screen_depth, position / vec2(textureSize(screen_depth, 0))).r;
}
#endif
#ifdef F_GET_DEPTH_FAST

float screenf_get_depth_fast(const in vec2 position)
{
  return texture(screen_depth, position / vec2(textureSize(screen_depth, 0))).r;
}
#endif
#ifdef F_01_GET_DEPTH

float screenf_01_get_depth(const in vec2 position)
{
  return texture(screen_depth, position).r;
}
#endif
#ifdef F_GET_ORIGINAL_DEPTH

float screenf_get_original_depth()
{
  return texelFetch(screen_depth, ivec2(gl_FragCoord.xy), 0).r;
}
#endif
#ifdef PLAIN
out vec4 castle_FragColor;

void main()
{
  castle_FragColor = screenf_get_original_color();
}
#endif
