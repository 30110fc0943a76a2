using System.Collections.Generic;
using Alate.Flight;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Trims in the air of their own wakes: the disk by its equation, wakes that are given, and one that is computed.</summary>
    public sealed class WakeTrimsLaws
    {
        private static readonly FlightCondition s_Cruise = new(1f, 0f), s_Slow = new(0.3f, 0f);

        [Test]
        public void ADisk_InducesTheSameForce_AtAnySpeed([Values(0.1f, 0.4f, 2f)] float induced, [Values(0f, 0.3f, 1.3f)] float speed,
            [Values(0f, 0.2f, 1f)] float other)
        {
            float there = induced * WakeTrims.DiskShare(induced, speed, other);
            Assert.That(there * math.sqrt(other * other + there * there),
                Is.EqualTo(induced * math.sqrt(speed * speed + induced * induced)).Within(0.01).Percent);
            Assert.That(WakeTrims.DiskShare(0f, speed, other), Is.EqualTo(1f), "air at rest stays so");
        }

        [Test]
        public void ATrim_ClosesInTheAirThatItsWakeIsSaidToHave()
        {
            using var insect = new FlyingInsect("firefly");
            using var solver = new TrimSolver(insect.Model);
            var air = new WingInflow { mean = new float3(0f, -8f, -2f) };
            var wake = new SaidWake(air);
            var trims = new WakeTrims(insect.Model, wake, solver);
            TrimState still = solver.Solve(s_Cruise, solver.Start(), out _), met = trims.Meet(s_Cruise, still, [], null);

            Assert.That(met.Inflow[0], Is.EqualTo(air));
            Assert.That(met, Is.SameAs(wake.Asked), "its wake was found as it stands");
            Assert.That(TrimSolver.Norm(solver.Residual(met, s_Cruise, out _)), Is.LessThan(TrimSolver.Closed));
            Assert.That(met.FrequencyScale * met.AmplitudeScale, Is.GreaterThan(1.01 * still.FrequencyScale * still.AmplitudeScale),
                "what blows down takes lift");
        }

        [Test]
        public void WhereTheWakeIsAnotherInEachBeat_TheAirIsThatBeside_AsADiskMakesIt()
        {
            using var insect = new FlyingInsect("firefly");
            using var solver = new TrimSolver(insect.Model);
            TrimState fast = solver.Solve(s_Cruise, solver.Start(), out _);
            fast.inflow[0] = new WingInflow { mean = new float3(0f, -5f, 0f), sine1 = new float3(0f, 2f, 0f) };
            var lines = new List<string>();
            var trims = new WakeTrims(insect.Model, new SaidWake(null), solver);
            TrimState slow = trims.Meet(s_Slow, null, [(s_Cruise, fast)], lines.Add);

            float share = WakeTrims.DiskShare(5f * insect.Model.Length, 1f, 0.3f);
            Assert.That(share, Is.GreaterThan(1f));
            Assert.That(slow.Inflow[0].mean.y, Is.EqualTo(-5f * share).Within(1e-3f));
            Assert.That(slow.Inflow[0].sine1.y, Is.EqualTo(2f * share).Within(1e-3f));
            string told = $"{s_Slow}: the wake is another one in each beat; the air is that of {s_Cruise}, scaled.";
            Assert.That(lines, Is.EqualTo(new[] { told }));
            Assert.That(trims.Meet(s_Slow, null, [], null), Is.Null, "nothing to take");
        }

        [Test]
        public void ABakeWithWakes_KeepsTheirAir()
        {
            using var insect = new FlyingInsect("firefly");
            var air = new WingInflow { mean = new float3(0f, -4f, -1f) };
            var bake = new TrimBake(insect.Model) { Wake = new SaidWake(air) };
            using TrimTable table = bake.Bake([1f], [0f]);
            using TrimTable read = TrimTableText.Read(TrimTableText.Write(table, insect.Model.Key), insect.Model.Key);

            Assert.That((table.HasWake, read.HasWake), Is.EqualTo((true, true)));
            Assert.That(TrimState.Read(read.Point(0, 0), insect.Model.Frequency).Inflow[0], Is.EqualTo(air));
        }

        // The force of the wings in the wake carries the weight as that of the trim does, within what a lifting line differs by.
        [Test]
        public void AFireflysTrim_MeetsItsOwnWake()
        {
            using var insect = new FlyingInsect("firefly");
            using var solver = new TrimSolver(insect.Model);
            TrimState still = solver.Solve(s_Slow, solver.Start(), out _);
            var trims = new WakeTrims(insect.Model, new TrimWake(), solver);
            TrimState met = trims.Meet(s_Slow, still, [], null);
            var found = new WingInflow[TrimPoint.Pairs];
            Assert.That(new TrimWake().Find(insect.Model, met, s_Slow, found));
            Assert.That((found[0] + met.Inflow[0] * -1f).MeanSquare, Is.LessThan(0.03f * 0.03f * found[0].MeanSquare), "its own");
            Assert.That(found[1].IsSet, Is.False, "a firefly beats one pair");
            float3 mean = math.rotate(quaternion.RotateX(-(float)met.Pitch), found[0].mean) * insect.Model.Length;
            Assert.That(mean.y, Is.InRange(-0.6f, -0.1f), "downwards, m/s");
            Assert.That(met.FrequencyScale * met.AmplitudeScale, Is.GreaterThan(still.FrequencyScale * still.AmplitudeScale));
        }

        // A change of a mesh or of the air that a table does not know of shows here. Hovering butterflies take the air of other trims.
        [TestCase("monarch", 1.3f)]
        [TestCase("swallowtail", 1.3f)]
        [TestCase("firefly", 1.3f)]
        [TestCase("firefly", 0f)]
        [TestCase("fishfly", 1.3f)]
        [TestCase("fishfly", 0f)]
        [TestCase("painted-lichen-moth", 1.3f)]
        [TestCase("dragonfly", 1.3f)]
        [TestCase("dragonfly", 0f)]
        public void TheAirOfATable_IsThatOfTheWakeOfItsTrim(string species, float speed)
        {
            using var insect = new FlyingInsect(species);
            var condition = new FlightCondition(speed, 0f);
            var trim = TrimState.Read(insect.Table.PointNear(speed, 0f), insect.Model.Frequency);
            var found = new WingInflow[TrimPoint.Pairs];
            Assert.That(new TrimWake().Find(insect.Model, trim, condition, found));
            float off = 0f, size = 0f;
            for (int pair = 0; pair < found.Length; pair++)
            {
                off += (found[pair] + trim.Inflow[pair] * -1f).MeanSquare;
                size += found[pair].MeanSquare;
            }

            Assert.That(math.sqrt(off / size), Is.LessThan(0.03f), "of its root mean square");
            using var solver = new TrimSolver(insect.Model);
            double[] residual = solver.Residual(trim, condition, out _);
            Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed), "and the trim balances in it");
        }

        // In hover, where the body itself meets hardly any air.
        [Test]
        public void TheForceOfAMotion_CarriesTheWeightOfItsTrim(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string species)
        {
            using var insect = new FlyingInsect(species);
            using var solver = new TrimSolver(insect.Model);
            var condition = new FlightCondition(0f, 0f);
            var trim = TrimState.Read(insect.Table.PointNear(0f, 0f), insect.Model.Frequency);
            double[] left = solver.Residual(trim, condition, out _);
            float3 force = new TrimMotion(insect.Model, trim, condition, TrimPoint.Pairs).Force / insect.Model.Weight;
            Assert.That(force.x, Is.Zero, "left and right");
            Assert.That(force.y, Is.EqualTo(1.0 + left[0]).Within(0.02), "lift");
            Assert.That(force.z, Is.EqualTo(left[1]).Within(0.02), "thrust");
        }

        // Where it repeats by itself: nothing was moved.
        [Test]
        public void TheForceOfAWake_IsThatOfItsAirReplayed()
        {
            using var insect = new FlyingInsect("firefly");
            var condition = new FlightCondition(0f, 0f);
            var trim = TrimState.Read(insect.Table.PointNear(0f, 0f), insect.Model.Frequency);
            var motion = new TrimMotion(insect.Model, trim, condition, 1, 8);
            using var wake = new TrimSheet(insect.Model, condition, motion, new WakeSettings());
            Assert.That(wake.Repeated(2, 4, 0.03f), Is.Not.Null);
            Assert.That(wake.Force.y / insect.Model.Weight, Is.EqualTo(motion.Force.y / insect.Model.Weight).Within(0.03));
            Assert.That(wake.Force.z / insect.Model.Weight, Is.EqualTo(motion.Force.z / insect.Model.Weight).Within(0.03));
        }

        // Their wakes stay between the wings: rings of slender cores throw one another about, another way in each beat. They are compared
        // at half as many substeps again as the air was moved for.
        [TestCase("monarch")]
        [TestCase("swallowtail")]
        [TestCase("painted-lichen-moth")]
        public void TheAirOfAHover_GivesTheForceOfItsWake(string species)
        {
            using var insect = new FlyingInsect(species);
            var condition = new FlightCondition(0f, 0f);
            var trim = TrimState.Read(insect.Table.PointNear(0f, 0f), insect.Model.Frequency);
            var found = new WingInflow[TrimPoint.Pairs];
            Assert.That(new TrimWake { HasWideCores = true }.Find(insect.Model, trim, condition, found));
            using TrimSheet wake = TrimWake.WideBehind(insect.Model, trim, condition, found.Length);
            Assert.That(wake.Repeated(8, 16, 0.01f), Is.Not.Null, "a wake of wide cores repeats");

            TrimState replayed = trim.Copy();
            found.CopyTo(replayed.inflow, 0);
            float3 force = new TrimMotion(insect.Model, replayed, condition, found.Length, 12).Force;
            float2 by = wake.Force.yz / insect.Model.Weight, again = force.yz / insect.Model.Weight;
            TestContext.Out.WriteLine($"{species}: {by} by the wake, {again} replayed");
            Assert.That(again.x, Is.EqualTo(by.x).Within(0.03), "lift");
            Assert.That(again.y, Is.EqualTo(by.y).Within(0.03), "thrust");
        }

        [Test]
        public void AWingWithoutASurface_ShedsNone_InOneLine()
        {
            using var insect = new FlyingInsect("firefly");
            insect.Model.Wings[0].Surface = null;
            Assert.That(() => new TrimWake().Find(insect.Model, new TrimState(), s_Cruise, new WingInflow[2]),
                Throws.ArgumentException.With.Message.Contains("FlightWing.Surface"));
        }

        // Says that a wake has some air; null for one that is another in each beat.
        private sealed class SaidWake(WingInflow? air) : ITrimWake
        {
            // Trim that was asked about last.
            public TrimState Asked { get; private set; }

            public bool Find(FlightModel model, TrimState trim, in FlightCondition condition, WingInflow[] pairs)
            {
                Asked = trim;
                if (air is WingInflow said)
                    pairs[0] = said;
                return air != null;
            }
        }
    }
}
