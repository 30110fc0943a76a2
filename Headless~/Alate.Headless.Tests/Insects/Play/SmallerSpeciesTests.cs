using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>Distance of the wings of every species, as they beat, from those of fewer triangles that take their place.</summary>
public sealed class SmallerSpeciesTests : PlayFixture
{
    private static IReadOnlyList<string> Species => InsectCatalogue.Names;

    [UnityTest]
    public IEnumerator AVertex_IsWithinAHundredthOfTheWing_AndTheMeanWithinATenthOfThat([ValueSource(nameof(Species))] string species)
    {
        InsectWings insect = Keep(InsectFactory.Create(species).gameObject).GetComponent<InsectWings>();
        insect.Quality.culling = WingCulling.AlwaysSimulate;
        insect.Air.wind = new Vector3(0.5f, 0f, -2f);
        yield return Frames(20);
        List<Carried> carried = [.. insect.Live.meshes.SelectMany(
            mesh => mesh.wings.SelectMany((wing, shape) => Of(mesh.template, shape, wing.handle)))];
        double squares = 0.0;
        float worst = 0f;
        for (int frame = 0; frame < 30; frame++)
        {
            yield return null;
            foreach (Carried vertex in carried)
            {
                float away = vertex.Away();
                squares += away * away;
                worst = math.max(worst, away);
            }
        }

        double mean = math.sqrt(squares / (30 * carried.Count));
        TestContext.Out.WriteLine($"{species}: {100.0 * mean:0.000} % of the wing's length, {100f * worst:0.000} at most");
        Assert.That(worst, Is.LessThan(0.01f), "half a hundredth of the span");
        Assert.That(mean, Is.LessThan(0.0012));
        Assert.That(worst, Is.GreaterThan(1e-4f), "the wings bend");
    }

    // The vertices that the smaller mesh lacks.
    private static IEnumerable<Carried> Of(MeshTemplate template, int wing, WingHandle handle)
    {
        RiggedPart shape = template.Shapes[wing];
        Vector3[] rest = template.Source.vertices;
        int[] vertices = shape.Selection.vertices;
        var places = new Dictionary<int, int>();
        for (int place = 0; place < vertices.Length; place++)
            places[vertices[place]] = place;
        for (int place = shape.Smaller.vertexCount; place < vertices.Length; place++)
        {
            (int3 corners, float3 shares) = Nearest(shape.Smaller.triangles, rest, rest[vertices[place]]);
            var at = new int3(places[corners.x], places[corners.y], places[corners.z]);
            yield return new Carried(handle, place, at, shares, shape.Rig.Frame.length);
        }
    }

    private static (int3 Corners, float3 Shares) Nearest(int[][] parts, Vector3[] rest, float3 point)
    {
        (int3 Corners, float3 Shares) nearest = default;
        float least = float.PositiveInfinity;
        foreach (int[] part in parts)
        {
            for (int k = 0; k < part.Length; k += 3)
            {
                float3 a = rest[part[k]], b = rest[part[k + 1]], c = rest[part[k + 2]];
                float3 shares = ReducedSurface.NearestShares(point, a, b, c);
                float distance = math.distancesq(point, shares.x * a + shares.y * b + shares.z * c);
                if (distance < least)
                    (least, nearest) = (distance, (new int3(part[k], part[k + 1], part[k + 2]), shares));
            }
        }

        return nearest;
    }

    /// <summary>A vertex, and the place on the smaller mesh that is nearest to it at rest.</summary>
    private sealed record Carried(WingHandle Wing, int Vertex, int3 Corners, float3 Shares, float Length)
    {
        /// <summary>Distance of the two now, wing lengths.</summary>
        public float Away()
        {
            NativeArray<PackedVertex> now = WingSystem.Loop.World.PackedVertices(Wing);
            float3 carried = Shares.x * now[Corners.x].position + Shares.y * now[Corners.y].position + Shares.z * now[Corners.z].position;
            return math.distance(carried, now[Vertex].position) / Length;
        }
    }
}
