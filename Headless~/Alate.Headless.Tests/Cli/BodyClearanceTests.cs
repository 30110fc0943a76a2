using System.Collections.Generic;
using System.Linq;
using Alate.Cli.Flights;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>Wings that beat, and the body between them.</summary>
    public sealed class BodyClearanceTests
    {
        private const int k_Phases = 12;

        private static IEnumerable<string> Names => Species.Names;

        [TestCaseSource(nameof(Names))]
        public void AsItFlies_HardlyAnyOfAWing_IsWithinTheBody(string species)
        {
            FlightRecord flight = MonarchFlight.Fly(new FlightPlan { Species = species });
            SurfaceMesh body = flight.Insect.Body;
            var pieces = BodyPieces.Of(body).ConvertAll(piece => (Corners: piece, Bounds: BodyPieces.BoundsOf(body, piece)));
            foreach (RecordedWing wing in flight.Wings.Where(wing => !wing.Placement.IsLeft))
            {
                var places = new float3[wing.Rest.Length];
                int within = 0;
                float deepest = 0f;
                for (int phase = 0; phase < k_Phases; phase++)
                {
                    wing.At(phase / (double)k_Phases, places, new float3[places.Length]);
                    for (int k = 0; k < places.Length; k++)
                    {
                        Vector3 place = places[k];
                        if (!pieces.Exists(piece => piece.Bounds.Contains(place) && BodyPieces.Winding(body, piece.Corners, place) > 0.5))
                            continue;
                        within++;
                        deepest = math.max(deepest, math.length(wing.Rest[k]));
                    }
                }

                double share = within / (double)(k_Phases * places.Length);
                TestContext.Progress.WriteLine($"{species} {wing.Wing.Name}: {share:P2} within the body, up to {deepest:0.000} of the wing's length from its hinge");
                Assert.That(share, Is.LessThan(0.01));
            }
        }
    }
}
