#if defined(GL_ES) && __VERSION__ >= 300 || !defined X
precision mediump float;
#elif (1 << 3) == 0x8 && ~0 != 0
#define A B
#define B A + 1
#else
void dead() { }
#endif
#ifdef A
#if A
float alive;
#endif
#endif
#undef A
#ifndef A
struct S { vec2 a[2]; float b; } s[3];
layout(std140) uniform Block { vec4 x; } block;
#endif
invariant gl_Position;
