using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Crowds
{
    /// <summary>Loops that an insect flies by its trims: beat and attitude are those of a free flight.</summary>
    public sealed class FlownClipTests
    {
        private const int k_Frames = 12;

        private readonly List<Object> m_Made = new List<Object>();
        private InsectWings m_Insect;
        private InsectBake m_Bake;

        [OneTimeSetUp]
        public void BakeAll()
        {
            var parts = InsectParts.Make(InsectCatalogue.Find("monarch"));
            WingPreset[] presets = parts.CreatePresets(InsectVariant.Flight, ModelReading.Physical);
            GameObject made = parts.Assemble(presets);
            m_Made.Add(made);
            m_Made.AddRange(presets);
            foreach (MeshFilter filter in made.GetComponentsInChildren<MeshFilter>(true))
            {
                if (!m_Made.Contains(filter.sharedMesh))
                    m_Made.Add(filter.sharedMesh);
            }

            m_Insect = made.GetComponent<InsectWings>();
            CatalogueFlight.AddTo(m_Insect, InsectCatalogue.Find("monarch"));
            m_Bake = InsectBaker.Bake(m_Insect, BakeMotion.All, new BakeSettings(k_Frames));
        }

        [OneTimeTearDown]
        public void DestroyWhatWasMade()
        {
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
        }

        [Test]
        public void AllClips_Loop()
        {
            Assert.That(m_Bake.Clips.Select(clip => clip.Name), Is.EqualTo(BakeMotion.Names));
            foreach (BakedClip clip in m_Bake.Clips)
            {
                bool still = clip.Name is "glide" or "rest" or "folded" or "bask";
                Assert.That(clip.RightBeat.HasValue, Is.EqualTo(!still), clip.Name);
                Assert.That(clip.Frames, Has.Count.EqualTo(still ? 1 : k_Frames), clip.Name);
                Assert.That(clip.Error.closure, Is.LessThan(1e-3f), clip.Name);
            }
        }

        [Test]
        public void TheBody_LiesAsItsTrimsSay()
        {
            using (FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch")))
            using (TrimTable table = CatalogueFlight.CreateTable(InsectCatalogue.Find("monarch"), model))
            {
                foreach (string name in new[] { "hover", "cruise", "turn-left" })
                {
                    BakedClip clip = Clip(name);
                    float[] point = PointNear(table, clip.Motion.Speed * table.TopSpeed);
                    float3 ahead = math.rotate(clip.Attitude, new float3(0f, 0f, 1f));
                    Assert.That(math.degrees(math.asin(ahead.y)), Is.EqualTo(math.degrees(point[TrimPoint.Pitch])).Within(10.0), name);
                    WingDrive beat = clip.RightBeat.Value;
                    Assert.That(beat.amplitude, Is.EqualTo(point[TrimPoint.Drive + 1]).Within(0.1f), name);
                    Assert.That(math.degrees(beat.tilt), Is.EqualTo(math.degrees(point[TrimPoint.Drive + 2])).Within(5f), name);
                    Assert.That(math.degrees(beat.meanSweep), Is.EqualTo(math.degrees(point[TrimPoint.Drive + 3])).Within(5f), name);
                    Assert.That(clip.Frequency, Is.EqualTo(point[TrimPoint.Drive]).Within(1f), name);
                }

                Assert.That(math.length(Clip("cruise").Velocity) * m_Bake.MetresPerUnit, Is.EqualTo(0.65f * table.TopSpeed).Within(0.05f));
                Assert.That(math.length(Clip("hover").Velocity) * m_Bake.MetresPerUnit, Is.LessThan(0.05f));
            }
        }

        // On average over beats, as feedback makes each a little different. The bake holds the body, which bobs in free flight, most where
        // it hovers: what that does to the wings is left out.
        [TestCase("cruise", 0.12f)]
        [TestCase("hover", 0.26f)]
        public void TheJoints_AreOnAverageNearThoseOfAFreeFlight(string name, float near)
        {
            BakedClip clip = Clip(name);
            BakedWing wing = m_Bake.Wings[0];
            var sums = new float3[k_Frames, wing.RestJoints.Length];
            int[] counts = new int[k_Frames];
            using (FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch")))
            using (TrimTable table = CatalogueFlight.CreateTable(InsectCatalogue.Find("monarch"), model))
            {
                float speed = clip.Motion.Speed * table.TopSpeed;
                using (var flight = new FreeFlight(model, table, new FlightCondition(speed, 0f)))
                {
                    while (flight.Time < 7.0)
                    {
                        flight.Step(FlightCommand.Fly(new float3(0f, 0f, speed), 0f), 1f / (60f * model.Frequency));
                        WingReading reading = flight.World.Read(flight.Wings[0]);
                        float at = reading.Phase / (2f * math.PI) * k_Frames;
                        if (flight.Time < 3.0 || math.abs(at - math.round(at)) > 0.1f)
                            continue;
                        int frame = (int)math.round(at) % k_Frames;
                        counts[frame]++;
                        for (int joint = 0; joint < wing.RestJoints.Length; joint++)
                        {
                            sums[frame, joint] += math.mul(
                                model.Wings[0].Axes, reading.JointPosition(joint / wing.JointsPerChain, joint % wing.JointsPerChain)
                                - reading.JointPosition(0, 0));
                        }
                    }
                }
            }

            float worst = 0f;
            for (int frame = 0; frame < k_Frames; frame++)
            {
                Assert.That(counts[frame], Is.GreaterThan(5), "beats at this phase");
                for (int joint = 0; joint < wing.RestJoints.Length; joint++)
                {
                    float3 baked = (clip.Frames[frame].Joints[wing.FirstJoint + joint].position
                        - clip.Frames[frame].Joints[wing.FirstJoint].position) / wing.Length;
                    worst = math.max(worst, math.distance(sums[frame, joint] / counts[frame], baked));
                }
            }

            TestContext.WriteLine($"{name}: joints within {100f * worst:0.0} % of the wing length of a free flight's mean");
            Assert.That(worst, Is.LessThan(near));
        }

        [Test]
        public void ATurnToTheLeft_MirrorsATurnToTheRight()
        {
            BakedClip left = Clip("turn-left"), right = Clip("turn-right");
            Assert.That(left.AngularVelocity.y, Is.LessThan(0f));
            Assert.That(left.Velocity.z, Is.EqualTo(right.Velocity.z).Within(0.01f * right.Velocity.z));
            Assert.That(Bank(right), Is.LessThan(-1f).And.EqualTo(-Bank(left)).Within(0.2f), "it leans into the turn, degrees");
            BakedWing one = m_Bake.Wings[0], other = m_Bake.Wings[1];
            float apart = 0f;
            for (int k = 0; k < one.Vertices.Length; k++)
            {
                float3 mirrored = left.Frames[5].Positions[one.Vertices[k]] * new float3(-1f, 1f, 1f);
                Assert.That(math.distance(mirrored, right.Frames[5].Positions[other.Vertices[k]]), Is.LessThan(5e-3f * m_Bake.WingLength));
                apart = math.max(
                    apart, math.distance(left.Frames[5].Positions[one.Vertices[k]], right.Frames[5].Positions[one.Vertices[k]]));
            }

            Assert.That(apart, Is.GreaterThan(0.005f * m_Bake.WingLength), "the sides beat differently");
        }

        // Lift that leans by the angle whose tangent is speed times turn over gravity holds a body on its circle.
        [TestCase("turn-left")]
        [TestCase("turn-right")]
        public void ATurn_IsFlownAhead_AndLeansAsItsCircleAsks(string name)
        {
            using (FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch")))
            using (TrimTable table = CatalogueFlight.CreateTable(InsectCatalogue.Find("monarch"), model))
            {
                BakedClip clip = Clip(name);
                float speed = clip.Motion.Speed * table.TopSpeed, turn = math.radians(clip.Motion.TurnDegrees);
                float3 flown = math.rotate(clip.Attitude, clip.Velocity) * m_Bake.MetresPerUnit;
                float3 nose = math.rotate(clip.Attitude, new float3(0f, 0f, 1f));
                float3 turned = math.rotate(clip.Attitude, clip.AngularVelocity);
                float lean = math.degrees(math.atan(speed * turn / 9.81f));
                Assert.That(math.distance(flown, new float3(0f, 0f, speed)), Is.LessThan(0.1f * speed));
                Assert.That(math.abs(nose.x), Is.LessThan(0.1f));
                Assert.That(math.distance(turned, new float3(0f, turn, 0f)), Is.LessThan(1e-4f));
                Assert.That(-Bank(clip) / lean, Is.GreaterThan(1f).And.LessThan(2f), "the body leans further than its lift");
            }
        }

        [Test]
        public void BetweenTwoClips_NoWingCollapses()
        {
            var positions = new float3[m_Bake.Surface.VertexCount];
            var others = new float3[positions.Length];
            var normals = new float3[positions.Length];
            float worst = 1f;
            // Nobody blends flying into sitting.
            BakedClip[] flown = m_Bake.Clips.Where(clip => clip.Motion.Steering.fold == 0f).ToArray();
            for (int phase = 0; phase < k_Frames; phase += 2)
            {
                foreach (BakedClip from in flown)
                {
                    foreach (BakedClip to in flown)
                    {
                        from.Evaluate((float)phase / k_Frames, positions, normals);
                        to.Evaluate((float)phase / k_Frames, others, normals);
                        float least = math.min(Span(positions), Span(others));
                        for (int vertex = 0; vertex < positions.Length; vertex++)
                            positions[vertex] = 0.5f * (positions[vertex] + others[vertex]);
                        worst = math.min(worst, Span(positions) / least);
                        Assert.That(Span(positions), Is.GreaterThan(0.75f * least), $"{from.Name} to {to.Name} at {phase} of {k_Frames}");
                    }
                }
            }

            TestContext.WriteLine($"shortest wing half way between two clips: {worst:0.00}");
        }

        [Test]
        public void WithoutTrims_WhatCannotBeFlown_SaysWhatCan()
        {
            InsectFlight flight = m_Insect.GetComponent<InsectFlight>();
            FlightTrims trims = flight.Trims;
            flight.Trims = null;
            try
            {
                Assert.That(
                    () => InsectBaker.Bake(m_Insect, new[] { BakeMotion.Find("hover") }, new BakeSettings(k_Frames)),
                    Throws.TypeOf<BakeException>().With.Message.Contains(
                        "has none for its numbers; without trims it has: glide, rest, folded, bask."));
                Assert.That(
                    InsectBaker.Bake(m_Insect, new[] { BakeMotion.Find("rest") }, new BakeSettings(k_Frames)).Clips, Has.Count.EqualTo(1));
            }
            finally
            {
                flight.Trims = trims;
            }
        }

        // The level point of the table nearest to a speed.
        private static float[] PointNear(TrimTable table, float speed)
        {
            int s = 0, c = 0;
            for (int k = 1; k < table.Speeds.Length; k++)
                s = math.abs(table.Speeds[k] - speed) < math.abs(table.Speeds[s] - speed) ? k : s;
            for (int k = 1; k < table.ClimbRates.Length; k++)
                c = math.abs(table.ClimbRates[k]) < math.abs(table.ClimbRates[c]) ? k : c;
            return table.Point(s, c);
        }

        private BakedClip Clip(string name) => m_Bake.Clips.First(clip => clip.Name == name);

        private static float Bank(BakedClip clip) => math.degrees(math.asin(math.rotate(clip.Attitude, new float3(1f, 0f, 0f)).y));

        // Longest reach of the right wing from its hinge.
        private float Span(float3[] positions)
        {
            float3 hinge = m_Bake.Wings[0].RestJoints[0];
            float longest = 0f;
            foreach (int vertex in m_Bake.Wings[0].Vertices)
                longest = math.max(longest, math.distance(hinge, positions[vertex]));
            return longest;
        }
    }
}
