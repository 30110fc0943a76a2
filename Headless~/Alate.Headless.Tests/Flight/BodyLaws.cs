using System;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using StandIns;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Laws of a body that its wings carry, whatever the numbers.</summary>
    public sealed class BodyLaws
    {
        private FlyingInsect m_Insect;

        [OneTimeSetUp]
        public void MakeTheInsect() => m_Insect = new FlyingInsect("monarch");

        [OneTimeTearDown]
        public void DisposeTheInsect() => m_Insect.Dispose();

        [Test]
        public void TheForceOnTheBody_IsTheRateOfItsMomentum()
        {
            using var flight = new FreeFlight(m_Insect.Model, m_Insect.Table);
            float3 start = flight.Velocity;
            Vector impulse = default;
            for (int step = 0; step < 100; step++)
            {
                flight.Step(FlightCommand.Fly(new float3(0.2f, 0f, 0.8f)), 0.01f);
                impulse += new Vector(flight.Force, 0.01) - new Vector(0, 0.01 * m_Insect.Model.Weight, 0);
            }

            float3 gained = m_Insect.Model.Mass * (flight.Velocity - start);
            double weight = m_Insect.Model.Weight;
            Assert.That(Math.Abs(gained.x - impulse.X), Is.LessThan(1e-4 * weight));
            Assert.That(Math.Abs(gained.y - impulse.Y), Is.LessThan(1e-4 * weight));
            Assert.That(Math.Abs(gained.z - impulse.Z), Is.LessThan(1e-4 * weight));
        }

        [Test]
        public void AWindTunnel_LeavesNoMemory()
        {
            int live = NativeMemoryLedger.LiveCount;
            using (new FlightTunnel(m_Insect.Model, 2))
                Assert.That(NativeMemoryLedger.LiveCount, Is.GreaterThan(live));

            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(live), NativeMemoryLedger.Describe());
        }

        [Test]
        public unsafe void FeedbackOfABodyThatForgot_IsThatOfANewOne([Values(0.1f, 30f)] float unsampled)
        {
            FlyingBody fresh = m_Insect.Model.CreateBody();
            fresh.rotation = quaternion.identity;
            FlyingBody flown = fresh;
            float* point = stackalloc float[TrimPoint.Floats];
            m_Insect.Table.View.Read(0.3f, 0f, point);
            for (int beat = 0; beat < 3; beat++)
            {
                flown.velocity = new float3(0.1f, -0.2f, 0.2f) * beat;
                flown.sinceSample += 0.1f;
                BodyFeedback.Sample(ref flown, 0f, point);
            }

            flown.sinceSample = unsampled;
            flown.Forget();
            flown.velocity = fresh.velocity = new float3(0.02f, 0.01f, -0.03f);
            for (int beat = 0; beat < 3; beat++)
            {
                flown.sinceSample += 0.1f;
                fresh.sinceSample += 0.1f;
                BodyFeedback.Sample(ref flown, 0f, point);
                BodyFeedback.Sample(ref fresh, 0f, point);
                for (int command = 0; command < FlightCommands.Count; command++)
                    Assert.That(flown.Last(command), Is.EqualTo(fresh.Last(command)), $"command {command} of beat {beat}");
            }
        }

        [Test]
        public void ForceAndMomentOnAHeldBody_AreThoseOfItsPatchesAndItsHull()
        {
            using var tunnel = new FlightTunnel(m_Insect.Model, 1);
            tunnel.Set(0, new TrimState(), new FlightCondition(1.3f, 0f));
            tunnel.Restart();
            var sums = new PatchSums(m_Insect.Model, tunnel.World, tunnel.Wings(0));
            double largest = 0, turning = 0;
            for (int step = 0; step < 200; step++)
            {
                tunnel.World.StepOnce(1f / (200f * 11f));
                FlyingBody body = tunnel.World.Body(tunnel.Body(0));
                sums.Read(out Vector force, out Vector moment);
                var stream = Vector.Rotate(math.conjugate(body.middleRotation), new Vector(-body.middleVelocity));
                force += stream.Length * new Vector(stream.X * body.drag.x, stream.Y * body.drag.y, stream.Z * body.drag.z);
                var read = Vector.Rotate(math.conjugate(body.middleRotation), new Vector(body.force));
                largest = Math.Max(largest, (read - force).Length / m_Insect.Model.Weight);
                turning = Math.Max(turning, (new Vector(body.moment) - moment).Length / (m_Insect.Model.Weight * m_Insect.Model.Length));
            }

            TestContext.Out.WriteLine($"off by {largest:0.0e+0} of the weight, {turning:0.0e+0} of weight and wing length");
            Assert.That(largest, Is.LessThan(1e-4));
            Assert.That(turning, Is.LessThan(1e-4));
        }

        [TestCase("monarch")]
        [TestCase("fishfly")]
        public void TheMomentOnAFreeBody_IsThatOfItsPatches_AndTheRateOfItsAngularMomentum(string species)
        {
            using var insect = new FlyingInsect(species);
            using var flight = new FreeFlight(insect.Model, insect.Table);
            var sums = new PatchSums(insect.Model, flight.World, flight.Wings);
            double unit = insect.Model.Weight * insect.Model.Length, largest = 0, most = 0;
            float h = 1f / (40f * insect.Model.Frequency);
            Vector start = Spin(insect.Model, flight), impulse = default;
            for (int step = 0; step < 400; step++)
            {
                quaternion before = flight.Rotation;
                flight.Wind = step > 200 ? new float3(0.5f, 0.1f, 0f) : default;
                flight.Step(FlightCommand.Fly(new float3(0.3f, 0f, 0.5f)), h);
                Assert.That(flight.World.Read(flight.Wings[0]).Substeps, Is.EqualTo(1));
                sums.Read(out _, out Vector moment);
                var read = new Vector(flight.Moment);
                impulse += h * Vector.Rotate(math.slerp(before, flight.Rotation, 0.5f), read);
                most = Math.Max(
                    most, (Spin(insect.Model, flight) - start - impulse).Length / (unit * step * h + unit / insect.Model.Frequency));
                largest = Math.Max(largest, (read - moment).Length / unit);
            }

            TestContext.Out.WriteLine(
                $"{species}: off by {largest:0.0e+0} of weight and wing length, the angular momentum by {most:0.0e+0} of their impulse");
            Assert.That(largest, Is.LessThan(1e-4));
            Assert.That(most, Is.LessThan(1e-2));
        }

        [Test]
        public void AMirroredInsect_FliesTheMirroredPath()
        {
            List<float3> right = Path(1f), left = Path(-1f);
            for (int k = 0; k < right.Count; k++)
                Assert.That(math.length(right[k] - new float3(-left[k].x, left[k].yz)), Is.LessThan(1e-5f), $"step {k}");
        }

        [Test]
        public void TheSameFlight_IsFlown_OnOneThreadAsOnMany()
        {
            List<float3> once = Path(1f);
            try
            {
                JobsUtility.JobWorkerCount = 0;
                Assert.That(Path(1f), Is.EqualTo(once));
            }
            finally
            {
                JobsUtility.ResetJobWorkerCount();
            }
        }

        [Test]
        public void ManyInsects_FlyAsOneAlone_AndAllocateNothing_InOneJobAStep()
        {
            using var world = new WingWorld();
            var bodies = new List<BodyHandle>();
            var wings = new List<WingHandle>();
            for (int k = 0; k < 21; k++)
            {
                FlyingBody body = m_Insect.Model.CreateBody();
                body.table = m_Insect.Table.View;
                body.steered = 1;
                body.mode = BodyMode.Free;
                bodies.Add(m_Insect.Model.AddTo(world, body, wings));
            }

            for (int k = 0; k < wings.Count; k++)
                world.SetDrive(wings[k], new WingDrive { frequency = 12f, amplitude = 1.1f });
            for (int step = 0; step < 20; step++)
                world.Step(0.02f);
            float3 first = world.Body(bodies[0]).position;
            foreach (BodyHandle body in bodies)
                Assert.That(world.Body(body).position, Is.EqualTo(first));
            Assert.That(math.all(math.isfinite(first)));

            long jobs = world.JobCount, least = long.MaxValue;
            for (int round = 0; round < 25; round++)
            {
                long before = GC.GetTotalAllocatedBytes(true);
                world.Step(0.02f);
                least = Math.Min(least, GC.GetTotalAllocatedBytes(true) - before);
            }

            Assert.That(least, Is.Zero);
            Assert.That(world.JobCount - jobs, Is.EqualTo(25));
        }

        [Test]
        public void WingsAndBodiesThatGo_LeaveTheOthersFlying()
        {
            using var world = new WingWorld();
            var bodies = new List<BodyHandle>();
            var wings = new List<WingHandle>();
            for (int k = 0; k < 5; k++)
            {
                FlyingBody body = m_Insect.Model.CreateBody();
                body.table = m_Insect.Table.View;
                body.mode = BodyMode.Free;
                bodies.Add(m_Insect.Model.AddTo(world, body, wings));
            }

            world.Step(0.02f);
            world.RemoveBody(bodies[1]);
            world.Remove(wings[2]);
            world.Remove(wings[0]);
            world.Step(0.02f);
            world.Remove(wings[1]);
            world.Step(0.02f);
            world.RemoveBody(bodies[0]);
            for (int step = 0; step < 10; step++)
                world.Step(0.02f);

            Assert.That(world.Contains(bodies[0]), Is.False);
            Assert.That(world.Body(bodies[4]).position, Is.EqualTo(world.Body(bodies[3]).position));
            Assert.That(math.length(world.Body(bodies[4]).position), Is.GreaterThan(0.01f));
        }

        private List<float3> Path(float side)
        {
            var path = new List<float3>();
            using var flight = new FreeFlight(m_Insect.Model, m_Insect.Table);
            for (int step = 0; step < 150; step++)
            {
                flight.Wind = step > 100 ? new float3(0.5f * side, 0.1f, 0f) : default;
                flight.Step(FlightCommand.Fly(step < 50 ? default : new float3(0.6f * side, 0f, 0.6f)), 0.02f);
                path.Add(flight.Position);
            }

            return path;
        }

        // Angular momentum about the centre of mass, along the world's axes.
        private static Vector Spin(FlightModel model, FreeFlight flight) =>
            Vector.Rotate(flight.Rotation, Vector.Transform(
                model.Inertia, Vector.Rotate(math.conjugate(flight.Rotation), new Vector(flight.AngularVelocity))));
    }
}
