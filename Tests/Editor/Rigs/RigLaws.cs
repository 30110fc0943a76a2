using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of what an inspected rig tells of its vertices, and of the limits from which a rig is called weak.</summary>
    public sealed class RigLaws : EditingFixture
    {
        [Test]
        public void AQuantityOfOneJoint_IsBlendedByTheWeightOfThatJoint_AndTheStrongestHasTheLargest()
        {
            RigInspection rig = Inspect(0);
            float[] weights = new float[rig.masses.Length];
            for (int vertex = 0; vertex < rig.points.Length; vertex += 41)
            {
                float most = 0f;
                for (int joint = 0; joint < weights.Length; joint++)
                {
                    float[] one = new float[rig.masses.Length];
                    one[joint] = 1f;
                    weights[joint] = rig.Weight(vertex, new[] { rig.Joint(joint) });
                    Assert.That(rig.Blend(vertex, one), Is.EqualTo(weights[joint]).Within(1e-6f), $"vertex {vertex}, joint {joint}");
                    most = math.max(most, weights[joint]);
                }

                JointIndex strongest = rig.Strongest(vertex);
                Assert.That(weights[5 * strongest.chain + strongest.joint], Is.EqualTo(most));
                JointIndex[] twice = JointPicking.All(Skeleton).Concat(JointPicking.All(Skeleton)).ToArray();
                Assert.That(rig.Weight(vertex, twice), Is.EqualTo(1f), "no more than all");
            }
        }

        [Test]
        public void ADelay_IsThatOfItsChainsRoot_AndAnEvenShareAlongTheChain()
        {
            RigInspection rig = Inspect(0);
            WingParameters parameters = WingParameters.Default;
            parameters.chordDelay = 0.5f;
            parameters.spanDelay = 0.2f;
            float[] delays = rig.Delays(parameters);
            Vector3 first = Skeleton.GetJoint(0, 0), last = Skeleton.GetJoint(4, 0);

            for (int i = 0; i < 5; i++)
            {
                float root = Vector3.Distance(Skeleton.GetJoint(i, 0), first) / Vector3.Distance(last, first);
                for (int j = 0; j < 5; j++)
                    Assert.That(delays[5 * i + j], Is.EqualTo(Mathf.PI * (0.5f * root + 0.2f * j / 4f)).Within(1e-4f), $"{i}, {j}");
            }
        }

        [Test]
        public void ADistance_IsMadeOfThatInPlan_AndThatInHeight()
        {
            RigInspection rig = Inspect(0);
            const float k_Up = 0.1f;
            for (int vertex = 0; vertex < rig.points.Length; vertex += 41)
            {
                float before = rig.Distance(vertex), height = rig.points[vertex].y;
                rig.points[vertex].y = height + k_Up;
                float above = rig.Distance(vertex);
                rig.points[vertex].y = height - k_Up;
                float below = rig.Distance(vertex);

                // Squares of both sides: what lies in plan, and the height there was, stand in each of them alike.
                Assert.That(above * above + below * below - 2f * before * before, Is.EqualTo(2f * k_Up * k_Up).Within(1e-5f));
                rig.points[vertex].y = height;
                float plan = rig.located[vertex].distance;
                rig.located[vertex].distance = plan + k_Up;
                float beside = rig.Distance(vertex);
                Assert.That(beside * beside - before * before, Is.EqualTo(k_Up * (k_Up + 2f * plan)).Within(1e-5f));
                rig.located[vertex].distance = plan;
            }
        }

        [Test]
        public void AHeight_IsMeasuredFromThatOfTheJointsAround_ByTheirWeights()
        {
            RigInspection rig = Inspect(0);
            var random = new System.Random(7);
            float[] heights = new float[rig.masses.Length];
            for (int joint = 0; joint < heights.Length; joint++)
                rig.rest.joints[joint].y = heights[joint] = (float)random.NextDouble() - 0.5f;
            for (int vertex = 0; vertex < rig.points.Length; vertex += 17)
            {
                rig.points[vertex].y = 0.3f * (float)random.NextDouble();
                float plan = rig.located[vertex].distance, height = rig.points[vertex].y - rig.Blend(vertex, heights);
                Assert.That(rig.Distance(vertex), Is.EqualTo(math.sqrt(plan * plan + height * height)).Within(1e-5f), $"{vertex}");
            }
        }

        [TestCase(0.97f, false)]
        [TestCase(1.03f, true)]
        public void AVertex_IsFar_AboveSixHundredthsOfTheWing_AndToldAlone(float share, bool isFar)
        {
            RigInspection rig = Inspect(0);
            int vertex = Enumerable.Range(0, rig.points.Length).First(v => rig.triangles.corners.Any(c => c.x == v));
            rig.located[vertex].distance = 0f;
            float height = rig.points[vertex].y, off = rig.Distance(vertex);
            rig.points[vertex].y = height - off;
            if (rig.Distance(vertex) > 0.5f * off)
                rig.points[vertex].y = height + off;
            rig.points[vertex].y += share * 0.06f;
            Assume.That(rig.Distance(vertex), Is.EqualTo(share * 0.06f).Within(1e-4f));
            List<RigProblem> problems = RigProblems.Find(rig);

            Assert.That(problems, Has.Count.EqualTo(isFar ? 1 : 0));
            if (!isFar)
                return;
            Assert.That(problems[0].Message, Is.EqualTo("1 vertex lies up to 6.2 % of the wing's length beside the joints."));
            Assert.That(problems[0].Position, Is.EqualTo(rig.Surface.positions[vertex]));
            Assert.That(problems[0].Joints, Is.EqualTo(new[] { rig.Strongest(vertex) }));
        }

        [Test]
        public void ATriangle_HangsOnRoots_WhereAllItsCornersDo_AndIsToldFromAHundredthOfTheArea()
        {
            var random = new System.Random(3);
            bool[] seen = new bool[2];
            foreach (double share in new[] { 0.05, 0.12, 0.15, 0.18, 0.2, 0.22, 0.25, 0.5 })
            {
                RigInspection rig = Inspect(0);
                bool[] held = new bool[rig.located.Length];
                for (int vertex = 0; vertex < held.Length; vertex++)
                {
                    // On roots; on the joints after them; between both.
                    held[vertex] = random.NextDouble() < share;
                    int cell = held[vertex] ? 4 * random.Next(4) : random.Next(16);
                    bool isRoot = cell % 4 == 0;
                    rig.located[vertex] = new CellPoint
                    {
                        cell = cell,
                        u = (float)random.NextDouble(),
                        v = held[vertex] || !isRoot && random.Next(2) == 0 ? 0f : 0.5f,
                    };
                    rig.points[vertex].y = 0f;
                }

                var hanging = Enumerable.Range(0, rig.triangles.Count)
                    .Where(t => Enumerable.Range(0, 3).All(corner => held[rig.triangles.corners[t][corner]])).ToList();
                double part = hanging.Sum(t => (double)rig.triangles.areas[t]) / rig.triangles.areas.ToArray().Sum(area => (double)area);
                RigProblem[] found = RigProblems.Find(rig).Where(problem => problem.Kind == RigProblemKind.HeldByRoots).ToArray();
                Assert.That(found, Has.Length.EqualTo(part > 0.01 ? 1 : 0), $"{part}");
                seen[found.Length] = true;
                if (found.Length == 0)
                    continue;
                int largest = hanging.OrderByDescending(t => rig.triangles.areas[t]).First();
                Assert.That(Vector3.Distance(found[0].Position, rig.frame.ToMesh(rig.triangles.centres[largest])), Is.LessThan(1e-5f));
                Assert.That(found[0].Joints,
                    Is.EqualTo(hanging.Select(t => rig.Strongest(rig.triangles.corners[t].x)).Distinct().OrderBy(joint => joint)));
                string told = (100.0 * part).ToString("0.#", CultureInfo.InvariantCulture);
                Assert.That(found[0].Message, Is.EqualTo($"{told} % of the wing's area hangs on roots alone and never bends."));
            }

            Assert.That(seen, Is.EqualTo(new[] { true, true }));
        }

        [Test]
        public void OneOfAKind_IsToldInTheSingular()
        {
            SurfaceMesh flat = Surface();
            flat.triangles = flat.triangles.Concat(new[] { 9, 8, 9 }).ToArray();
            RigProblem problem = RigProblems.Find(RigInspection.TryMake(Skeleton, flat, 0, out _)).Single();
            Assert.That(problem.Message, Is.EqualTo("1 triangle has no area; remove them from the mesh."));
            Assert.That(problem.Position, Is.EqualTo(flat.positions[9]));

            SurfaceMesh single = Surface();
            single.triangles = single.triangles.Take(3).ToArray();
            var rig = RigInspection.TryMake(Skeleton, single, 0, out _);
            Assert.That(RigProblems.Summary(rig), Does.StartWith("1 triangle, 1 patch, heaviest joint "));
        }

        [Test]
        public void Patches_AreTheTriangles_WhereAsManyAreAskedFor_OrNoNumberIs()
        {
            int triangles = Inspect(0).triangles.Count;
            Assert.That(Inspect(0).PatchCount, Is.EqualTo(triangles));
            Assert.That(Inspect(triangles).PatchCount, Is.EqualTo(triangles));
            Assert.That(Inspect(triangles + 9).patches, Is.EqualTo(Inspect(0).patches));
            Assert.That(Inspect(40).PatchCount, Is.InRange(16, 60));
        }

        [Test]
        public void AJointWithoutMass_IsTold_WithTheOneThatHasIt_EachAtItsPlace()
        {
            RigInspection rig = Inspect(0);
            rig.masses[7] = 0f;
            rig.masses[13] = 0.5f;
            List<RigProblem> problems = RigProblems.Find(rig);

            Assert.That(problems.Select(problem => problem.Message), Is.EqualTo(new[]
            {
                "Joint 2 of chain 1 carries no part of the mesh.", "Joint 3 of chain 2 carries 50 % of the wing's mass.",
            }));
            Assert.That(problems.Select(problem => problem.Kind),
                Is.EqualTo(new[] { RigProblemKind.NoMass, RigProblemKind.MassConcentrated }));
            Assert.That(Vector3.Distance(problems[0].Position, Skeleton.GetJoint(1, 2)), Is.LessThan(1e-5f));
            Assert.That(Vector3.Distance(problems[1].Position, Skeleton.GetJoint(2, 3)), Is.LessThan(1e-5f));
        }

        [Test]
        public void Regions_AreJoinedByAnySideOfATriangle_AndNotByACorner()
        {
            var surface = new SurfaceMesh { positions = new Vector3[7], triangles = new[] { 0, 1, 2, 2, 3, 4, 4, 5, 6 } };
            foreach ((int a, int b) in new[] { (0, 1), (1, 2), (2, 0), (5, 6), (4, 6) })
            {
                List<List<int>> found = VertexRegions.Find(surface, vertex => vertex == a || vertex == b);
                Assert.That(found.Single(), Is.EquivalentTo(new[] { a, b }), $"{a}, {b}");
            }

            List<List<int>> apart = VertexRegions.Find(surface, vertex => vertex != 2 && vertex != 4);
            Assert.That(apart.Select(region => string.Join(" ", region)), Is.EquivalentTo(new[] { "0 1", "3", "5 6" }));
        }

        [Test]
        public void AJointsOrder_IsChainByChain_FromRootToTip()
        {
            JointIndex[] all = JointPicking.All(Skeleton).ToArray();
            Assert.That(all.Reverse().OrderBy(joint => joint), Is.EqualTo(all));
            Assert.That(all.All(joint => joint.IsIn(Skeleton)), Is.True);
            JointIndex[] outside = new[] { new JointIndex(-1, 0), new JointIndex(5, 0), new JointIndex(0, -1), new JointIndex(0, 5) };
            Assert.That(outside.Any(joint => joint.IsIn(Skeleton)), Is.False);
            Assert.That(all.SelectMany(a => all.Where(b => a == b || !(a != b))).Count(), Is.EqualTo(all.Length));
            Assert.That(new JointIndex(3, 1).ToString(), Is.EqualTo("joint 1 of chain 3"));
        }

        private RigInspection Inspect(int patches) => RigInspection.TryMake(Skeleton, Surface(), patches, out _);
    }
}
