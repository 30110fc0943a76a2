#ifndef STANDIN_COLOR
#define STANDIN_COLOR
#include "../../../../Light.hlsl"
float3 SRGBToLinear(float3 c) { return StandinLinear(c); }
#endif
