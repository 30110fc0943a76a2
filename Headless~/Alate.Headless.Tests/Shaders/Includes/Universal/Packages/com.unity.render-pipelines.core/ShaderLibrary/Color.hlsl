#ifndef STANDIN_COLOR
#define STANDIN_COLOR
float3 SRGBToLinear(float3 c) { return c; }
#endif
