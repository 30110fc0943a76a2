// How wings and bodies answer to light, the same in every pipeline. Colours are linear light; directions are unit vectors in the world.
#ifndef ALATE_WING_LIGHT
#define ALATE_WING_LIGHT

// A wing has no inside: whichever side the eye sees is lit as the upper one. A body is closed and keeps its normals.
float3 AlateFacing(float3 normal, float3 toEye, float isTwoSided)
{
    return isTwoSided > 0.5 && dot(normal, toEye) < 0 ? -normal : normal;
}

// Colour of the side that the eye sees: the lower one is paler by a colour where it is bright, so that veins stay dark.
half3 AlateSide(half3 colour, float3 normal, float3 toEye, float isTwoSided, half4 underside)
{
    half share = isTwoSided > 0.5 && dot(normal, toEye) < 0 ? underside.a : 0;
    return lerp(colour, underside.rgb, share * saturate(max(colour.r, max(colour.g, colour.b))));
}

// Light that falls on the side the eye sees, light that falls on the other side and passes through it, and a soft gleam. What passes is filtered twice by the
// colour of the wing, as by a coloured pane.
float3 AlateWingLight(float3 colour, float3 normal, float3 toEye, float3 toLight, float3 light, float through, float gloss, float shine)
{
    float facing = dot(normal, toLight);
    float3 diffuse = colour * saturate(facing);
    float3 passed = colour * (0.35 + 0.65 * colour) * (through * saturate(-facing));
    float gleam = gloss * pow(saturate(dot(normal, normalize(toLight + toEye))), shine) * saturate(8 * facing);
    return light * (diffuse + passed + gleam);
}

// Share of a pixel that lies on a wing whose picture has a margin: its opacity there, as sharp as if a texel were a pixel. Beyond the margin nothing is drawn. With
// multisampling the margin is smooth by the share that is left.
half AlateCutMargin(half alpha)
{
    #if defined(_CUT)
    half share = saturate((alpha - 0.5) / max(fwidth(alpha), 0.0001) + 0.5);
    clip(share - 0.02);
    return share;
    #else
    return alpha;
    #endif
}

// Share of the light of a pixel that is the wing's: of glass as much as it is opaque. A margin leaves it to coverage.
half AlateOpaqueShare(half alpha)
{
    #if defined(_CUT)
    return 1;
    #else
    return alpha;
    #endif
}

// Below 0 where a shadow lets light pass: a membrane's shadow has holes, as many as it is clear, in a pattern as fine as the shadow map's points.
float AlateShadowHole(float alpha, float2 place)
{
    return alpha - frac(0.5 * floor(place.x) + 0.25 * floor(place.y)) - 0.125;
}

#endif
