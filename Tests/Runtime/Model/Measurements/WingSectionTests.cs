using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Cuts through meshes.</summary>
    public sealed class WingSectionTests
    {
        [Test]
        public void Section_RunsFromLeadingToTrailingEdge_AtItsSpan([Values(0.1f, 0.437f, 0.75f)] float span)
        {
            var sheet = new Sheet();

            var section = WingSection.Cut(sheet.rest, sheet.triangles, span);

            float before = float.PositiveInfinity;
            for (int k = 0; k < section.Count; k++)
            {
                float3 place = section.At(k, sheet.rest);
                Assert.That(place.x, Is.EqualTo(span).Within(1e-5f));
                Assert.That(place.z, Is.LessThan(before));
                before = place.z;
            }

            Assert.That(section.Leading(sheet.rest).z, Is.EqualTo(0f).Within(1e-6f));
            Assert.That(section.Trailing(sheet.rest).z, Is.EqualTo(-Sheet.Chord).Within(1e-6f));
        }

        [Test]
        public void SectionThroughAColumnOfVertices_TakesEachVertexOnce()
        {
            var sheet = new Sheet(10, 8);

            var section = WingSection.Cut(sheet.rest, sheet.triangles, sheet.rest[5 * 9].x);

            Assert.That(section.Count, Is.EqualTo(9));
        }

        [Test]
        public void Section_FollowsTheDeformedMesh()
        {
            var sheet = new Sheet();
            var section = WingSection.Cut(sheet.rest, sheet.triangles, 0.33f);
            var shift = new float3(0.2f, -0.4f, 0.7f);

            float3 moved = section.At(2, sheet.Deformed(place => place + shift)) - section.At(2, sheet.rest);

            Assert.That(math.distance(moved, shift), Is.LessThan(1e-5f));
        }

        [Test]
        public void TrianglesInAnyOrder_GiveTheSameSection()
        {
            var sheet = new Sheet(7, 5);
            int[] shuffled = Enumerable.Range(0, sheet.triangles.Length / 3).OrderBy(k => (k * 37) % 101)
                .SelectMany(k => new[] { sheet.triangles[3 * k + 1], sheet.triangles[3 * k + 2], sheet.triangles[3 * k] }).ToArray();

            var one = WingSection.Cut(sheet.rest, sheet.triangles, 0.4f);
            var other = WingSection.Cut(sheet.rest, shuffled, 0.4f);

            Assert.That(other.Count, Is.EqualTo(one.Count));
            for (int k = 0; k < one.Count; k++)
                Assert.That(math.distance(one.At(k, sheet.rest), other.At(k, sheet.rest)), Is.LessThan(1e-6f));
        }

        [Test]
        public void SpanBeyondTheWing_HasNoChord()
        {
            var sheet = new Sheet();

            ArgumentException problem = Assert.Throws<ArgumentException>(() => WingSection.Cut(sheet.rest, sheet.triangles, 1.2f));

            Assert.That(problem.Message, Does.Contain("1.2"));
        }

        [Test]
        public void Tip_IsTheFarthestVertexOfATriangle()
        {
            var sheet = new Sheet();
            float3[] withStray = sheet.rest.Append(new float3(9f, 0f, 0f)).ToArray();

            int tip = TipBend.FindTip(withStray, sheet.triangles);

            Assert.That(withStray[tip].x, Is.EqualTo(1f).Within(1e-6f));
            Assert.That(withStray[tip].z, Is.EqualTo(0f).Within(1e-6f), "of several the most forward");
        }

        [Test]
        public void Percentile_IsTheValueThatTheShareDoesNotExceed()
        {
            float[] values = Enumerable.Range(1, 200).Select(k => (float)(201 - k)).ToArray();

            Assert.That(EdgeStretch.Percentile(values, 0.99f), Is.EqualTo(198f));
            Assert.That(EdgeStretch.Percentile(values, 1f), Is.EqualTo(200f));
            Assert.That(EdgeStretch.Percentile(new[] { 3f }, 0.99f), Is.EqualTo(3f));
            Assert.That(EdgeStretch.Percentile(values, 0f), Is.EqualTo(1f), "the least");
        }

        [Test]
        public void Percentile_IsThatOfTheSortedValues_WhateverTheirOrder()
        {
            var random = new Unity.Mathematics.Random(7);
            for (int round = 0; round < 200; round++)
            {
                float[] values = new float[random.NextInt(1, 40)];
                for (int k = 0; k < values.Length; k++)
                    values[k] = random.NextInt(12) == 0 ? float.NaN : random.NextInt(-9, 10);
                float[] sorted = (float[])values.Clone();
                Array.Sort(sorted);
                for (int rank = 0; rank < sorted.Length; rank++)
                {
                    float found = EdgeStretch.Percentile(values, (rank + 0.5f) / sorted.Length);
                    Assert.That(found, Is.EqualTo(sorted[rank]), $"round {round}, rank {rank} of {sorted.Length}");
                }
            }
        }

        [Test]
        public void TheLeadingEdge_IsAUnitVector_AlsoBetweenSectionsInOnePlace()
        {
            var sheet = new Sheet();
            var section = WingSection.Cut(sheet.rest, sheet.triangles, 0.3f);
            var outer = WingSection.Cut(sheet.rest, sheet.triangles, 0.8f);

            Assert.That(SectionTwist.LeadingEdge(section, section, sheet.rest), Is.EqualTo(new float3(1f, 0f, 0f)));
            float3[] raised = sheet.Deformed(place => new float3(3f * place.x, 4f * place.x, place.z));
            float3 edge = SectionTwist.LeadingEdge(section, outer, raised);
            Assert.That(math.distance(edge, new float3(0.6f, 0.8f, 0f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void Fundamental_HasTheAmplitudeAndPhaseOfACosine_WhateverElseTheHeightHolds()
        {
            var sheet = new Sheet();
            List<BeatFrame> beat = sheet.Beat(phase => quaternion.identity, (place, phase) => place);

            float2 wave = EdgeLag.Fundamental(
                beat, frame => 0.7f + 0.3f * math.cos(frame.Phase - 0.8f) + 0.2f * math.cos(2f * frame.Phase));

            Assert.That(math.length(wave), Is.EqualTo(0.3f).Within(1e-4f));
            Assert.That(math.atan2(wave.y, wave.x), Is.EqualTo(0.8f).Within(1e-4f));
        }

        // Of two waves the second follows the first by the difference of their phases, the shorter way round; what hardly swings follows
        // nothing.
        [Test]
        public void AWave_FollowsAnother_ByTheShorterWayRound(
            [Values(-2.9f, -1f, 0f, 2f, 3f)] float first, [Values(-3f, 0.5f, 2.8f)] float second)
        {
            var beat = new List<BeatFrame>();
            for (int k = 0; k < 40; k++)
                beat.Add(new BeatFrame(2f * math.PI * k / 40f, quaternion.identity, null));
            float behind = EdgeLag.Behind(
                beat, frame => 0.3f * math.cos(frame.Phase - first), frame => 1f + 0.7f * math.cos(frame.Phase - second));
            Assert.That(math.abs(behind), Is.LessThanOrEqualTo(math.PI));
            Assert.That(math.cos(behind - (second - first)), Is.EqualTo(1f).Within(1e-5f));
            Assert.That(EdgeLag.Behind(beat, frame => 0.9e-5f * math.cos(frame.Phase), frame => math.cos(frame.Phase - 1f)), Is.Zero);
            Assert.That(EdgeLag.Behind(beat, frame => math.cos(frame.Phase), frame => 0.9e-5f * math.cos(frame.Phase - 1f)), Is.Zero);
            Assert.That(EdgeLag.Behind(beat, frame => 1.1e-5f * math.cos(frame.Phase), frame => math.cos(frame.Phase - 1f)),
                Is.EqualTo(1f).Within(1e-2f));
        }
    }
}
