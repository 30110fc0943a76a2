using System;
using System.Collections.Generic;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures.Photos;

/// <summary>An insect of the catalogue at one phase of its beat.</summary>
internal static class InsectPhoto
{
    private const float k_DistanceOverReach = 5f, k_Softness = 0.6f;

    /// <summary>Takes the photo.</summary>
    /// <param name="flight">A flight of a species of the catalogue.</param>
    /// <param name="turns">The phase, beats.</param>
    /// <param name="view">From where.</param>
    /// <param name="size">Pixels.</param>
    /// <param name="inset">Least distance of the insect from the picture's edges, pixels.</param>
    /// <param name="paper">What is behind it, linear light.</param>
    public static Color32[] Take(FlightRecord flight, double turns, PictureView view, int2 size, float inset, float3 paper)
    {
        SurfaceMesh body = flight.Insect.Body;
        float reach = 0f;
        foreach (RecordedWing wing in flight.Wings)
            reach = math.max(reach, math.length(wing.Placement.Hinge) + wing.Placement.Length);
        var camera = new PictureCamera(view, k_DistanceOverReach * reach);
        var surfaces = new List<PhotoSurface> { PhotoSurface.Of(body) };
        var places = new List<float3[]> { Array.ConvertAll(body.positions, place => camera.Project(place)) };
        var normals = new List<float3[]> { Array.ConvertAll(body.normals, normal => (float3)normal) };
        var lengths = new List<float> { 1f };
        foreach (RecordedWing wing in flight.Wings)
        {
            var positions = new float3[wing.Rest.Length];
            var upright = new float3[wing.Rest.Length];
            wing.At(turns, positions, upright);
            surfaces.Add(PhotoSurface.Of(surfaces.Count, wing));
            places.Add(Array.ConvertAll(positions, camera.Project));
            normals.Add(upright);
            lengths.Add(wing.Placement.Length);
        }

        (float scale, float2 shift) = Fit(places, size, inset);
        var grid = new SampleGrid(size.x, size.y);
        var shading = new Shading(camera);
        for (int k = 0; k < surfaces.Count; k++)
        {
            float3[] seen = Array.ConvertAll(places[k], place => new float3(SampleGrid.k_Fineness * (scale * place.xy + shift), place.z));
            surfaces[k].Draw(grid, seen, normals[k], shading, k_Softness / (scale * lengths[k]));
        }

        return grid.Pixels(paper);
    }

    // Pixels for a metre, and where the middle of the camera's plane goes.
    private static (float Scale, float2 Shift) Fit(List<float3[]> places, int2 size, float inset)
    {
        float2 min = float.PositiveInfinity, max = float.NegativeInfinity;
        foreach (float3[] surface in places)
        {
            foreach (float3 place in surface)
            {
                min = math.min(min, place.xy);
                max = math.max(max, place.xy);
            }
        }

        float scale = math.cmin((new float2(size.x, size.y) - 2f * inset) / (max - min));
        return (scale, 0.5f * new float2(size.x, size.y) - scale * 0.5f * (min + max));
    }
}
