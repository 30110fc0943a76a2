#ifndef STANDIN_COMMON_MATERIAL
#define STANDIN_COMMON_MATERIAL
float LerpWhiteTo(float b, float t) { return lerp(1, b, t); }
#endif
