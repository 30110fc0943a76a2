#ifndef STANDIN_PACKING
#define STANDIN_PACKING
float2 PackNormalOctQuadEncode(float3 n) { return n.xy; }
float3 PackFloat2To888(float2 f) { return float3(f, 0); }
#endif
