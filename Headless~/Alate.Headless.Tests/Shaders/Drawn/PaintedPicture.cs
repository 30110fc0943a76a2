using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Shaders;

/// <summary>
/// Picture that the package's painter makes of surfaces of Alate/Wing in the light of a view: its samples, sheets of glass and pixels, with
/// the shader's light written down a second time from what the manual says of it.
/// </summary>
internal static class PaintedPicture
{
    /// <summary>The pixels, rows from above.</summary>
    public static Color32[] Of(SheetView view, IReadOnlyList<LitSurface> surfaces)
    {
        var grid = new SampleGrid(view.Width, view.Height);
        for (int index = 0; index < surfaces.Count; index++)
            Draw(grid, view, surfaces[index], index);
        return grid.Pixels(Shading.ToLinear(Shading.Paper));
    }

    private static void Draw(SampleGrid grid, SheetView view, LitSurface surface, int index)
    {
        Matrix4x4 upright = surface.Place.inverse.transpose;
        float3[] places = Array.ConvertAll(surface.Positions, place => (float3)surface.Place.MultiplyPoint3x4(place)),
            normals = Array.ConvertAll(surface.Normals, normal => math.normalize((float3)upright.MultiplyVector(normal)));
        float4[] shown = Array.ConvertAll(places, place => (float4)(view.Matrix * new Vector4(place.x, place.y, place.z, 1f)));
        float2[] seen = Array.ConvertAll(
            shown, place => SampleGrid.k_Fineness * 0.5f * new float2(view.Width, view.Height)
                * (1f + new float2(1f, -1f) * place.xy / place.w));
        float4[] colours = Array.ConvertAll(
            surface.Colours, colour => new float4(colour.r, colour.g, colour.b, colour.a) / 255f);
        float4 tint = new(
            LitSurface.Linear(new float3(surface.Tint.r, surface.Tint.g, surface.Tint.b)), surface.Tint.a);
        bool isTwoSided = surface.Number("_Cull") < 0.5f;
        ReducedTexture texture = surface.Texture == null ? null : ReducedTexture.Of(surface, seen);
        for (int k = 0; k < surface.Triangles.Length; k += 3)
        {
            int3 t = new(surface.Triangles[k], surface.Triangles[k + 1], surface.Triangles[k + 2]);
            if (!isTwoSided && IsBehind(seen[t.x], seen[t.y], seen[t.z], surface.Place))
                continue;
            TriangleSamples.Visit(seen[t.x], seen[t.y], seen[t.z], (x, y, across) =>
            {
                // What is blended evenly in space is not on a picture in perspective.
                float3 share = across / new float3(shown[t.x].w, shown[t.y].w, shown[t.z].w);
                float depth = 1f / math.csum(share);
                share *= depth;
                if (!grid.IsSeen(x, y, depth))
                    return;
                float3 place = Mean(places), normal = math.normalize(Mean(normals)), toEye = math.normalize((float3)view.Eye - place);
                // Colours of vertices are blended as they are stored.
                float4 colour = share.x * colours[t.x] + share.y * colours[t.y] + share.z * colours[t.z];
                float4 paint = tint * math.lerp(1f, new float4(LitSurface.Linear(colour.xyz), colour.w), surface.Number("_VertexColours"));
                if (texture != null)
                {
                    float2 uv = share.x * (float2)surface.Uvs[t.x] + share.y * (float2)surface.Uvs[t.y]
                        + share.z * (float2)surface.Uvs[t.z];
                    paint *= texture.At(uv);
                }

                if (surface.IsCut && paint.w < 0.5f)
                    return;
                paint.w = math.lerp(1f, paint.w, surface.Number("_Translucent"));
                if (isTwoSided && math.dot(normal, toEye) < 0f)
                {
                    normal = -normal;
                    Color below = surface.Underside;
                    paint.xyz += below.a * math.min(math.cmax(paint.xyz), 1f)
                        * (LitSurface.Linear(new float3(below.r, below.g, below.b)) - paint.xyz);
                }

                float3 light = Light(surface, view.ToSun, paint.w * paint.xyz, normal, toEye) / math.max(paint.w, 1e-4f);
                grid.Add(x, y, depth, new float4(light, surface.IsClear ? paint.w : 1f), index);

                float3 Mean(float3[] corners) => share.x * corners[t.x] + share.y * corners[t.y] + share.z * corners[t.z];
            });
        }
    }

    // Corners of what faces the eye run clockwise, those of a mirrored mesh the other way.
    private static bool IsBehind(float2 a, float2 b, float2 c, Matrix4x4 place) =>
        ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) * place.determinant < 0f;

    // A pane: it scatters light on the side that it falls on, and, filtered twice, what passes to the other; round about, half of it each.
    private static float3 Light(LitSurface surface, float3 toSun, float3 colour, float3 normal, float3 toEye)
    {
        float through = surface.Number("_Through"), cosine = math.dot(normal, toSun);
        float3 around = (1f - 0.5f * through) * Around(normal.y) + 0.5f * through * Around(-normal.y);
        float3 sun = cosine > 0f ? cosine * colour : -cosine * through * colour * (0.35f + 0.65f * colour);
        float mirror = math.max(0f, math.dot(normal, math.normalize(toSun + toEye)));
        float gleam = surface.Number("_Gloss") * math.pow(mirror, surface.Number("_Shine")) * math.clamp(8f * cosine, 0f, 1f);
        return colour * around + SheetView.Sun * (sun + gleam);

        static float3 Around(float up) => SheetView.Ambient + up * SheetView.Sky;
    }

    /// <summary>A texture of about as many pixels as are seen of it, in linear light.</summary>
    private sealed class ReducedTexture(int width, int height, float4[] pixels)
    {
        /// <summary>Halves a surface's texture while two of its pixels fall on a sample.</summary>
        public static ReducedTexture Of(LitSurface surface, float2[] seen)
        {
            Texture2D texture = surface.Texture;
            float4[] pixels = Array.ConvertAll(texture.GetPixels32(), pixel =>
                new float4(LitSurface.Linear(new float3(pixel.r, pixel.g, pixel.b) / 255f), pixel.a / 255f));
            var reduced = new ReducedTexture(texture.width, texture.height, pixels);
            double samples = 0.0, texels = 0.0;
            for (int k = 0; k < surface.Triangles.Length; k += 3)
            {
                int a = surface.Triangles[k], b = surface.Triangles[k + 1], c = surface.Triangles[k + 2];
                samples += Area(seen[a], seen[b], seen[c]);
                texels += Area(surface.Uvs[a], surface.Uvs[b], surface.Uvs[c]) * texture.width * texture.height;
            }

            for (; texels > 2.0 * samples; texels /= 4.0)
                reduced = reduced.Half();
            return reduced;
        }

        /// <summary>Blended between the four pixels around.</summary>
        public float4 At(float2 uv)
        {
            float2 place = math.saturate(uv) * new float2(width, height) - 0.5f, share = math.frac(place);
            var corner = (int2)math.floor(place);
            return math.lerp(
                math.lerp(Pixel(corner.x, corner.y), Pixel(corner.x + 1, corner.y), share.x),
                math.lerp(Pixel(corner.x, corner.y + 1), Pixel(corner.x + 1, corner.y + 1), share.x), share.y);
        }

        private ReducedTexture Half()
        {
            int across = math.max(1, width / 2), up = math.max(1, height / 2);
            return new ReducedTexture(across, up, [.. Enumerable.Range(0, across * up).Select(k =>
            {
                int x = 2 * (k % across), y = 2 * (k / across);
                return 0.25f * (Pixel(x, y) + Pixel(x + 1, y) + Pixel(x, y + 1) + Pixel(x + 1, y + 1));
            })]);
        }

        private float4 Pixel(int x, int y) => pixels[math.clamp(y, 0, height - 1) * width + math.clamp(x, 0, width - 1)];

        private static double Area(float2 a, float2 b, float2 c) =>
            0.5 * math.abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    }
}
