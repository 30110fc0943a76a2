using System.Collections;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Laws of a monarch that sits down on a spot and leaves it, in steps of the test's own.</summary>
    public abstract class PerchingFixture : FlightFixture
    {
        /// <summary>Length of a step, seconds.</summary>
        private protected const float StepLength = 0.005f;

        /// <summary>The feet beside the centre, and the spot, metres of an insect.</summary>
        private protected static readonly float3 Legs = new float3(0f, -0.006f, 0.002f), Spot = new float3(1f, 2f, 3f);

        private protected FlightModel Model { get; private set; }

        private protected TrimTable Table { get; private set; }

        private protected LiveInsect Live { get; private set; }

        private protected WingWorld World { get; private set; }

        private protected HeldWings Wings { get; private set; }

        [UnitySetUp]
        public IEnumerator HoldAMonarch()
        {
            InsectDefinition species = InsectCatalogue.Find("monarch");
            Model = CatalogueFlight.CreateModel(species);
            Table = CatalogueFlight.CreateTable(species, Model);
            InsectFlight flight = Hatch();
            yield return Frames(3);
            Live = flight.GetComponent<InsectWings>().Live;
            World = WingSystem.Loop.World;
            World.Complete();
            Wings = new HeldWings(World, new BodyHandle(0, 1), Live, Model, Table);
        }

        [TearDown]
        public void GiveBack()
        {
            Table.Dispose();
            Model.Dispose();
        }

        private protected Perching Seated(float3 normal, float heading, float clearance, float units, out FlyingBody body)
        {
            body = default;
            body.rotation = quaternion.identity;
            var spot = new PerchSpot { position = Spot, normal = normal, heading = heading };
            var perching = new Perching(
                ref body, spot, Spot + units * (0.1f * normal - Legs), units * Legs, clearance, Wings.Frequency, units);
            for (int step = 0; step < 1000 && !perching.IsSeated; step++)
                perching.Sit(ref body, Wings, StepLength);
            Assert.That(perching.IsSeated);
            return perching;
        }

        // The attitude in which a hovering insect is at the end of a step, looking where a rotation looks.
        private protected quaternion Bob(quaternion like)
        {
            ref FlyingBody body = ref World.Body(new BodyHandle(0, 1));
            FlyingBody kept = body;
            body.reference = new BodyReference { heading = Headings.Of(like) };
            World.PlaceOnBob(new BodyHandle(0, 1), StepLength);
            quaternion bob = body.rotation;
            body = kept;
            return bob;
        }

        private protected static float3 Feet(in Perching perching, in FlyingBody body, float units) =>
            perching.Centre(body.rotation, units * Legs) + math.rotate(body.rotation, units * Legs);

        private protected static quaternion Facing(float heading, float3 normal)
        {
            var ahead = new float3(math.sin(heading), 0f, math.cos(heading));
            return quaternion.LookRotation(math.normalize(ahead - normal * math.dot(ahead, normal)), normal);
        }

        private protected static float Angle(quaternion a, quaternion b)
        {
            float3 nose = math.rotate(a, new float3(0f, 0f, 1f)), back = math.rotate(a, new float3(0f, 1f, 0f));
            quaternion turn = math.mul(b, math.conjugate(a));
            Assert.That(math.length(nose) * math.length(back), Is.EqualTo(1f).Within(1e-3f));
            return 2f * math.asin(math.min(math.length(turn.value.xyz), 1f));
        }

        private protected static void AssertTurned(quaternion rotation, quaternion from, quaternion to, float share)
        {
            float all = Angle(from, to);
            Assert.That(Angle(from, rotation), Is.EqualTo(share * all).Within(2e-3f), $"share {share} of the turn");
            Assert.That(Angle(rotation, to), Is.EqualTo((1f - share) * all).Within(2e-3f), $"share {share} of the turn");
        }

        private protected static void AssertHeld(in FlyingBody body)
        {
            Assert.That(body.mode, Is.EqualTo(BodyMode.Resting));
            Assert.That(math.length(body.velocity) + math.length(body.spin) + math.length(body.acceleration) + math.length(body.spinRate),
                Is.Zero);
        }
    }
}
