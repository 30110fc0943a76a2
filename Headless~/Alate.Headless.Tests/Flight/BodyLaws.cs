using System;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>What holds for a body that its wings carry, whatever the numbers.</summary>
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
                impulse += new Vector(flight.Force, 0.01);
                impulse.Y -= 0.01 * m_Insect.Model.Weight;
            }

            float3 gained = m_Insect.Model.Mass * (flight.Velocity - start);
            double weight = m_Insect.Model.Weight;
            Assert.That(Math.Abs(gained.x - impulse.X), Is.LessThan(1e-4 * weight));
            Assert.That(Math.Abs(gained.y - impulse.Y), Is.LessThan(1e-4 * weight));
            Assert.That(Math.Abs(gained.z - impulse.Z), Is.LessThan(1e-4 * weight));
        }

        [Test]
        public void ForceAndMomentOnAHeldBody_AreThoseOfItsPatches()
        {
            using var tunnel = new FlightTunnel(m_Insect.Model, 1);
            var condition = new FlightCondition(1.3f, 0f);
            var trim = new TrimState();
            tunnel.Set(0, trim, condition);
            tunnel.Restart();
            foreach (WingHandle wing in tunnel.Wings(0))
                tunnel.World.RecordPatches(wing, true);
            double largest = 0, turning = 0;
            for (int step = 0; step < 200; step++)
            {
                tunnel.World.StepOnce(1f / (200f * 11f));
                FlyingBody body = tunnel.World.Body(tunnel.Body(0));
                Vector force = default, moment = default;
                for (int k = 0; k < m_Insect.Model.Wings.Count; k++)
                    Add(tunnel.World.Read(tunnel.Wings(0)[k]), m_Insect.Model.Place(m_Insect.Model.Wings[k]), ref force, ref moment);
                // In body axes; what the hull drags stays below this bound.
                float3 read = math.rotate(math.conjugate(body.middleRotation), body.force);
                double scale = m_Insect.Model.Weight;
                largest = Math.Max(largest, Math.Sqrt(Math.Pow(read.x - force.X, 2) + Math.Pow(read.y - force.Y, 2) + Math.Pow(read.z - force.Z, 2)) / scale);
                turning = Math.Max(turning, Math.Abs(body.moment.x - moment.X) / (scale * m_Insect.Model.Length));
            }

            double hull = m_Insect.Model.Drag.y * 1.3 * 1.3 / m_Insect.Model.Weight;
            Assert.That(largest, Is.LessThan(hull + 1e-4));
            Assert.That(turning, Is.LessThan(0.02), "the patches' places after the substep, not those at which the air met them");
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

        private static void Add(in WingReading reading, in BodyWing wing, ref Vector force, ref Vector moment)
        {
            double unit = (double)wing.mass * wing.length;
            for (int patch = 0; patch < reading.PatchCount; patch++)
            {
                float3 f = wing.ToBody(reading.PatchForce(patch)), at = wing.hinge + wing.length * wing.ToBody(reading.PatchPosition(patch));
                force += new Vector(f, unit);
                moment += new Vector(math.cross(at, f), unit);
            }
        }

        /// <summary>A sum in double precision.</summary>
        private record struct Vector(double X, double Y, double Z)
        {
            public Vector(float3 v, double factor)
                : this(v.x * factor, v.y * factor, v.z * factor)
            {
            }

            public static Vector operator +(Vector a, Vector b) => new Vector(a.X + b.X, a.Y + b.Y, a.Z + b.Z);
        }
    }
}
