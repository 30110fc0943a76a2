using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>A species in one of its variants, flown once for all tests, its right wings at twelve phases of a beat.</summary>
    internal sealed class FlownSpecies
    {
        public const int k_Phases = 12;

        private static readonly ConcurrentDictionary<(string, InsectVariant), FlownSpecies> s_Flown =
            new ConcurrentDictionary<(string, InsectVariant), FlownSpecies>();

        private FlownSpecies(string name, InsectVariant variant)
        {
            var plan = new FlightPlan { Species = name, Variant = variant, Speed = FlightPlan.CruiseOf(InsectCatalogue.Find(name)) };
            using var flight = new TetheredFlight(plan, Insect.Of(plan));
            Flight = flight.Run(_ => { });
            Wings = Flight.Wings.Where(wing => !wing.Placement.IsLeft).ToList();
        }

        public FlightRecord Flight { get; }

        /// <summary>The right wings, from front to back.</summary>
        public IReadOnlyList<RecordedWing> Wings { get; }

        public SurfaceMesh Body => Flight.Insect.Body;

        public static FlownSpecies Of(string name, InsectVariant variant) =>
            s_Flown.GetOrAdd((name, variant), _ => new FlownSpecies(name, variant));

        /// <summary>A wing's vertices on the body at each phase, metres.</summary>
        public static IEnumerable<float3[]> Poses(RecordedWing wing)
        {
            for (int phase = 0; phase < k_Phases; phase++)
                yield return wing.At(phase / (double)k_Phases).Positions;
        }

        /// <summary>A wing's triangles whose corners lie at rest within a span, wing lengths.</summary>
        public static List<int3> TrianglesWithin(RecordedWing wing, float span)
        {
            var triangles = new List<int3>();
            for (int k = 0; k < wing.Triangles.Length; k += 3)
            {
                var corners = new int3(wing.Triangles[k], wing.Triangles[k + 1], wing.Triangles[k + 2]);
                if (wing.Rest[corners.x].x < span && wing.Rest[corners.y].x < span && wing.Rest[corners.z].x < span)
                    triangles.Add(corners);
            }

            return triangles;
        }
    }
}
