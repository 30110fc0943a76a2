using System;
using System.Collections.Concurrent;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes
{
    /// <summary>
    /// A species in level flight, flown by the command line's own flight with twice as many substeps as a bake has frames: what bakes are
    /// measured against.
    /// </summary>
    internal sealed class LiveWings
    {
        public const int Frames = 48;

        private static readonly ConcurrentDictionary<string, LiveWings> s_Flown = new ConcurrentDictionary<string, LiveWings>();
        private readonly FlightRecord m_Flight;

        private LiveWings(string species)
        {
            InsectDefinition definition = InsectCatalogue.Find(species);
            m_Flight = TetheredFlight.Fly(FlightPlan.Cruise(definition, InsectVariant.Standard) with { Substeps = 2 * Frames });
        }

        public static LiveWings Of(string species) => s_Flown.GetOrAdd(species, name => new LiveWings(name));

        public double Frequency => m_Flight.Wings[0].Frequency;

        /// <summary>Compares an insect in glTF's axes, body first and then the wings, with the live one.</summary>
        /// <returns>Largest distance of a wing's vertex over the wing length, and largest angle of a normal, degrees.</returns>
        public (double Distance, double Angle) Compare(double turns, float3[] positions, float3[] normals)
        {
            int next = m_Flight.Insect.Body.VertexCount;
            float3[] body = m_Flight.Insect.Abdomen?.Pose(m_Flight.AbdomenAt(turns)).Positions
                ?? Array.ConvertAll(m_Flight.Insect.Body.positions, place => (float3)place);
            float moved = 0f;
            for (int vertex = 0; vertex < next; vertex++)
                moved = Math.Max(moved, math.distance(positions[vertex], ToGltf(body[vertex])));
            Assert.That(moved, Is.LessThan(2e-5f), "the body stands still, but for an abdomen that swings");
            double distance = 0.0, angle = 0.0;
            foreach (RecordedWing wing in m_Flight.Wings)
            {
                (float3[] flown, float3[] flownNormals) = wing.At(turns);
                for (int vertex = 0; vertex < flown.Length; vertex++, next++)
                {
                    distance = Math.Max(distance, math.distance(positions[next], ToGltf(flown[vertex])) / wing.Placement.Length);
                    angle = Math.Max(angle, math.degrees(math.acos(math.min(1f, math.dot(normals[next], ToGltf(flownNormals[vertex]))))));
                }
            }

            Assert.That(next, Is.EqualTo(positions.Length));
            return (distance, angle);
        }

        private static float3 ToGltf(float3 body) => new float3(-body.x, body.y, body.z);
    }
}
