using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>
    /// Reaction of the wings on the body: momentum and angular momentum of both without air and weight, summed over all masses in double
    /// precision from where they are, and the bob that it makes.
    /// </summary>
    public sealed class BodyReactionTests
    {
        private const double k_Allowed = 1e-3;
        private const int k_Beats = 10, k_Substeps = 240;

        [TestCase("monarch", true)]
        [TestCase("monarch", false)]
        [TestCase("dragonfly", true)]
        [TestCase("firefly", true)]
        [TestCase("monarch", true, true)]
        public void WithoutAir_MomentumStays_ButForTheWeight(string species, bool even, bool falls = false)
        {
            using var insect = new FlyingInsect(species);
            using FlightModel model = InVacuum(insect.Model, InsectCatalogue.Find(species));
            using var tunnel = new FlightTunnel(model, 1);
            var condition = new FlightCondition(0.65f, 0f);
            float[] point = insect.Table.PointNear(condition.Speed, condition.Climb);
            var trim = TrimState.Read(point, model.Frequency);
            tunnel.Set(0, trim, condition, point);
            tunnel.Restart();
            float h = 1f / (model.Frequency * (float)trim.FrequencyScale * k_Substeps);
            for (int step = 0; step < 3 * k_Substeps; step++)
                tunnel.World.StepOnce(h);
            tunnel.World.PlaceOnBob(tunnel.Body(0));
            ref FlyingBody body = ref tunnel.World.Body(tunnel.Body(0));
            body.mode = BodyMode.Free;
            if (!falls)
                body.weight = body.gravity = default;
            if (!even)
            {
                for (int command = TrimPoint.LongCommands; command < FlightCommands.Count; command++)
                    tunnel.World.SetLast(tunnel.Body(0), command, 0.5f);
            }

            var all = new List<Masses>();
            for (int step = 0; step < k_Beats * k_Substeps; step++)
            {
                tunnel.World.StepOnce(h);
                all.Add(new Masses(model, tunnel, InsectCatalogue.Find(species)));
            }

            Vector start = default, end = default, turning = default, turned = default;
            Vector weight = falls ? new Vector(0, -9.81 * model.Mass, 0) : default;
            double wings = 0, spun = 0;
            for (int k = 1; k + 1 < all.Count; k++)
            {
                all[k].Momentum(
                    all[k - 1], all[k + 1], 2 * h, out Vector linear, out Vector angular, out double own, out double ownTurning);
                wings = Math.Max(wings, own);
                spun = Math.Max(spun, ownTurning);
                if (k <= k_Substeps)
                    (start, turning) = (start + linear - k * h * weight, turning + angular);
                if (k > all.Count - 2 - k_Substeps)
                    (end, turned) = (end + linear - k * h * weight, turned + angular);
            }

            double off = (end - start).Length / (k_Substeps * wings), offTurning = (turned - turning).Length / (k_Substeps * spun);
            TestContext.Out.WriteLine($"{species}: off by {off:0.0e+0} and {offTurning:0.0e+0} of the wings'");
            Assert.That(off, Is.LessThan(k_Allowed));
            Assert.That(offTurning, Is.LessThan(k_Allowed));
        }

        // The bob that answers the inertia of wings and abdomen on a body that is held is that of one that flies; an abdomen that swings
        // against the wings lessens it.
        [TestCase("monarch", 0.5, 14.0, 17.0, true)]
        [TestCase("monarch", 0.5, 8.5, 11.0)]
        [TestCase("painted-lichen-moth", 0.3, 3.7, 4.7)]
        public void TheBobOfATrim_IsFlown(string species, double allowed, double least, double most, bool isStiff = false)
        {
            using var insect = new FlyingInsect(species);
            SetOptions(insect.Model);
            IEnumerable<BodyEllipsoid> parts = InsectCatalogue.Find(species).FlightParts;
            if (isStiff)
                parts = parts.Select(part => part.Swinging(0f, 0f));
            using var model = new FlightModel(insect.Model.Wings, parts.ToList(), insect.Model.Mass, insect.Model.FluidDensity);
            using var solver = new TrimSolver(model);
            using var tunnel = new FlightTunnel(model, BeatMap.Insects);
            var condition = new FlightCondition(1.3f, 0f);
            TrimState trim = solver.Solve(condition, solver.Start(), out double[] residual);
            Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed));
            float[] point = new float[TrimPoint.Floats];
            trim.Write(point, model.Frequency);
            Assert.That(FlightGains.Write(BeatMap.Fly(tunnel, model, trim, condition), point));
            TrimState flown = FlownTrim.Fly(model, point, trim, condition, out string lost);
            Assert.That(lost, Is.Null);

            double solved = trim.PitchBob * 180 / Math.PI, bob = flown.PitchBob * 180 / Math.PI;
            TestContext.Out.WriteLine($"{species}: {solved:0.00}° held, {bob:0.00}° flown");
            Assert.That(bob, Is.EqualTo(solved).Within(allowed).And.InRange(least, most));
        }

        // Measured on a monarch that flies at 1.28 m/s: ±8.3°.
        [Test]
        public void AMonarchsBob_HardlyDependsOnTheSubsteps()
        {
            double[] bobs = [.. new[] { 1, 4 }.Select(finer =>
            {
                using var insect = new FlyingInsect("monarch");
                SetOptions(insect.Model, finer);
                using var model = new FlightModel(
                    insect.Model.Wings, InsectCatalogue.Find("monarch").FlightParts, insect.Model.Mass, insect.Model.FluidDensity);
                using var solver = new TrimSolver(model);
                TrimState trim = solver.Solve(new FlightCondition(1.3f, 0f), solver.Start(), out double[] residual);
                Assert.That(TrimSolver.Norm(residual), Is.LessThan(TrimSolver.Closed));
                return trim.PitchBob * 180 / Math.PI;
            })];
            TestContext.Out.WriteLine($"{bobs[0]:0.00}°, at four times the substeps {bobs[1]:0.00}°");
            Assert.That(bobs, Is.All.InRange(6.0, 11.0));
            Assert.That(bobs[0], Is.EqualTo(bobs[1]).Within(10).Percent);
        }

        private static void SetOptions(FlightModel own, int finer = 1)
        {
            foreach (FlightWing wing in own.Wings)
            {
                WingParameters parameters = wing.Parameters;
                parameters.options.bodyReaction = true;
                parameters.substepsPerBeat *= finer;
                wing.Parameters = parameters;
            }
        }

        private static FlightModel InVacuum(FlightModel own, InsectDefinition insect)
        {
            SetOptions(own);
            foreach (FlightWing wing in own.Wings)
            {
                WingParameters parameters = wing.Parameters;
                parameters.airDensity = 0f;
                wing.Parameters = parameters;
            }

            return new FlightModel(own.Wings, insect.FlightParts, own.Mass, 1e-9f, own.GravityShare);
        }

        /// <summary>All masses of an insect at one time, in the world.</summary>
        private sealed class Masses
        {
            private readonly List<(double Mass, Vector At)> m_Joints = [], m_Abdomen = [];
            private readonly double m_Body;
            private readonly Vector m_Place, m_Turning;

            public Masses(FlightModel model, FlightTunnel tunnel, InsectDefinition insect)
            {
                FlyingBody body = tunnel.World.Body(tunnel.Body(0));
                Vector origin = new Vector(body.position) - new Vector(body.positionRest);
                var parts = new MassSum();
                double shares = 0, wings = 0;
                foreach (FlightWing wing in model.Wings)
                    wings += wing.Mass;
                foreach (BodyEllipsoid part in insect.FlightParts)
                    shares += part.share;
                double whole = model.Mass - wings;
                float phase = tunnel.World.Read(tunnel.Wings(0)[0]).Phase;
                foreach (BodyEllipsoid part in insect.FlightParts)
                {
                    if (part.swing == 0f)
                        parts.Add(whole * part.share / shares, part.centre, part.halfAxes);
                    else
                        AddAbdomen(whole * part.share / shares, part, phase, new Vector(model.Centre), origin, body.rotation);
                }

                m_Body = parts.Mass;
                m_Place = origin + Vector.Rotate(body.rotation, new Vector(parts.Centre) - new Vector(model.Centre));
                m_Turning = Vector.Rotate(body.rotation, Vector.Transform(parts.Inertia, new Vector(body.spin)));
                for (int k = 0; k < model.Wings.Count; k++)
                {
                    FlightWing wing = model.Wings[k];
                    WingReading reading = tunnel.World.Read(tunnel.Wings(0)[k]);
                    for (int joint = 0; joint < wing.Rig.JointCount; joint++)
                    {
                        float3 at = reading.JointPosition(joint / wing.Rig.JointsPerChain, joint % wing.Rig.JointsPerChain);
                        Vector place = new Vector(wing.Hinge) - new Vector(model.Centre)
                            + Vector.Transform(wing.Axes, new Vector(at, wing.Length));
                        m_Joints.Add((wing.Mass * wing.Rig.JointMasses[joint], origin + Vector.Rotate(body.rotation, place)));
                    }
                }
            }

            // Six points have the moments of an ellipsoid: two on each axis, a sixth of its mass each.
            private void AddAbdomen(double mass, BodyEllipsoid part, float phase, Vector centre, Vector origin, quaternion rotation)
            {
                double up = -part.swing * Math.PI / 180 * Math.Cos(phase - part.lowestPhase * Math.PI / 180), sin = Math.Sin(up),
                    cos = Math.Cos(up);
                var hinge = new Vector(part.Hinge);
                for (int point = 0; point < 6; point++)
                {
                    double[] off = new double[3];
                    off[point / 2] = (point % 2 == 0 ? 1 : -1) * Math.Sqrt(0.6) * part.halfAxes[point / 2];
                    Vector arm = new Vector(part.centre) - hinge + new Vector(off[0], off[1], off[2]);
                    var turned = new Vector(arm.X, cos * arm.Y - sin * arm.Z, sin * arm.Y + cos * arm.Z);
                    m_Abdomen.Add((mass / 6, origin + Vector.Rotate(rotation, hinge + turned - centre)));
                }
            }

            public void Momentum(
                Masses before, Masses after, double time, out Vector linear, out Vector angular, out double own, out double ownTurning)
            {
                linear = m_Body / time * (after.m_Place - before.m_Place);
                angular = m_Turning + Vector.Cross(m_Place, linear);
                Vector wings = default, turning = default, centre = m_Body * m_Place;
                double mass = m_Body;
                for (int k = 0; k < m_Joints.Count; k++)
                {
                    Vector moved = m_Joints[k].Mass / time * (after.m_Joints[k].At - before.m_Joints[k].At);
                    wings += moved;
                    turning += Vector.Cross(m_Joints[k].At - m_Place, moved);
                    angular += Vector.Cross(m_Joints[k].At, moved);
                    centre += m_Joints[k].Mass * m_Joints[k].At;
                    mass += m_Joints[k].Mass;
                }

                for (int k = 0; k < m_Abdomen.Count; k++)
                {
                    Vector moved = m_Abdomen[k].Mass / time * (after.m_Abdomen[k].At - before.m_Abdomen[k].At);
                    linear += moved;
                    angular += Vector.Cross(m_Abdomen[k].At, moved);
                    centre += m_Abdomen[k].Mass * m_Abdomen[k].At;
                    mass += m_Abdomen[k].Mass;
                }

                linear += wings;
                angular -= Vector.Cross(1 / mass * centre, linear);
                own = wings.Length;
                ownTurning = turning.Length;
            }
        }
    }
}
