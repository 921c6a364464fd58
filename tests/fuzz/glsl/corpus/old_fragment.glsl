#version 120
#extension GL_ARB_texture_rectangle : enable
#define LOOK(texture) texture2D(texture, gl_TexCoord[0].st)
varying vec4 gl_TexCoord[2];
uniform sampler2D texture, other[2];
uniform sampler2DShadow map;
vec4 sample(vec2 at) { return texture2DLod(other[1], at, 0.0); }
/* PLUG-DECLARATIONS */
void main(void)
{
  float flat = shadow2DProj(map, gl_TexCoord[1]).r;
  gl_FragData[0] = LOOK(texture) * flat + gl_Color * sample(vec2(0.5));
  gl_FragColor.a = 1.0; // /* PLUG: none () */
  /*PLUG:fragment_end(gl_FragColor)*/
}
