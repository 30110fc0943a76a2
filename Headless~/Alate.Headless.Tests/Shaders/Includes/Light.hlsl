// What both kinds of pipelines compute alike for the surfaces that are drawn.
#ifndef STANDIN_LIGHT
#define STANDIN_LIGHT

float4 unity_SHAr, unity_SHAg, unity_SHAb;

// A constant and a slope over each axis, without the second order.
float3 StandinAmbient(float3 normal)
{
    float4 n = float4(normal, 1);
    return max(0, float3(dot(unity_SHAr, n), dot(unity_SHAg, n), dot(unity_SHAb, n)));
}

// Light of an sRGB value.
float3 StandinLinear(float3 encoded)
{
    return lerp(encoded / 12.92, pow(abs((encoded + 0.055) / 1.055), 2.4), step(0.04045, encoded));
}

// Stays upright on a surface whose places a matrix moves, mirrors and stretches.
float3 StandinNormal(float3x3 m, float3 normal)
{
    float3 x = cross(m[1], m[2]), y = cross(m[2], m[0]), z = cross(m[0], m[1]);
    return float3(dot(x, normal), dot(y, normal), dot(z, normal)) / dot(m[0], x);
}

#endif
