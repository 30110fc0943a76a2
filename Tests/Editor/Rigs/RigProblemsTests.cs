using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class RigProblemsTests : EditingFixture
    {
        [Test]
        public void MonarchsOwnSkeleton_HasNoWeakness([Values(3, 5, 8)] int chains, [Values(3, 5, 8)] int joints)
        {
            Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, chains, joints));

            Assert.That(Find(Surface()).Select(problem => problem.Message), Is.Empty);
        }

        [Test]
        public void TipsDrawnIn_LeaveFarVertices_WhichAreFoundWhereTheyAre_AndVanish()
        {
            Select((0, 4), (0, 3));
            Editing.Do("Slide", (draft, selected) => SlideCommands.By(draft, selected, -0.15f));

            RigProblem far = Find(Surface()).First(problem => problem.Kind == RigProblemKind.FarVertices);

            Vector3 tip = Surface().positions.OrderByDescending(p => p.x).First();
            Assert.That(Vector3.Distance(far.Position, tip), Is.LessThan(0.1f));
            Assert.That(far.Joints.Single().joint, Is.EqualTo(4));
            Assert.That(far.Message, Does.Match(@"^\d+ vertices lie up to [\d.]+ % of the wing's length beside the joints\.$"));

            Undo.Undo();
            Assert.That(Find(Surface()), Is.Empty);
        }

        [Test]
        public void FarRegions_AreListedOneByOne()
        {
            SurfaceMesh surface = Surface();
            Lift(surface, p => p.x > 0.5f);
            Lift(surface, p => p.x < 0.2f && p.z < -0.05f);

            Assert.That(Find(surface).Count(problem => problem.Kind == RigProblemKind.FarVertices), Is.EqualTo(2));
        }

        [Test]
        public void PartBehindTheRoots_NeverBends()
        {
            SurfaceMesh surface = Surface();
            int first = surface.positions.Length;
            surface.positions = surface.positions
                .Concat(new[] { new Vector3(-0.03f, 0f, 0.001f), new Vector3(-0.03f, 0f, -0.012f), new Vector3(-0.001f, 0f, -0.006f) })
                .ToArray();
            surface.normals = null;
            surface.triangles = surface.triangles.Concat(new[] { first, first + 1, first + 2 }).ToArray();
            for (int i = 0; i < 5; i++)
                Skeleton.Chains[i].joints[0].z *= 3f;
            int share = Find(surface).Count(problem => problem.Kind == RigProblemKind.HeldByRoots);
            Assert.That(share, Is.Zero, "a small part does no harm");

            for (int k = 0; k < 40; k++)
            {
                // Forty of them, side by side in height, so that none is another's double.
                surface.positions = surface.positions
                    .Concat(new[] { first, first + 1, first + 2 }.Select(c => surface.positions[c] + new Vector3(0f, 1e-5f * (k + 1), 0f)))
                    .ToArray();
                int own = surface.positions.Length - 3;
                surface.triangles = surface.triangles.Concat(new[] { own, own + 1, own + 2 }).ToArray();
            }

            RigProblem held = Find(surface).Single(problem => problem.Kind == RigProblemKind.HeldByRoots);
            Assert.That(held.Position.x, Is.LessThan(0f));
            Assert.That(held.Joints.All(joint => joint.joint == 0));
        }

        [Test]
        public void TrianglesWithoutArea_AreCounted()
        {
            SurfaceMesh surface = Surface();
            surface.triangles = surface.triangles.Concat(new[] { 5, 5, 6, 7, 8, 7 }).ToArray();

            RigProblem flat = Find(surface).Single();

            Assert.That(flat.Kind, Is.EqualTo(RigProblemKind.NoArea));
            Assert.That(flat.Message, Is.EqualTo("2 triangles have no area; remove them from the mesh."));
            Assert.That(flat.Position, Is.EqualTo(surface.positions[5]));
        }

        [Test]
        public void CrowdedJoints_CarryNothing_UntilTheyAreSpacedEvenly()
        {
            for (int i = 0; i < 5; i++)
            {
                for (int j = 1; j < 4; j++)
                    Skeleton.Chains[i].joints[j] = Vector3.Lerp(Skeleton.GetJoint(i, 0), Skeleton.GetJoint(i, 4), 1e-3f * j);
            }

            List<RigProblem> problems = Find(Surface());

            Assert.That(problems.Where(p => p.Kind == RigProblemKind.NoMass), Is.Not.Empty);
            RigProblem none = problems.First(p => p.Kind == RigProblemKind.NoMass);
            JointIndex joint = none.Joints.Single();
            Assert.That(none.Message, Is.EqualTo($"Joint {joint.joint} of chain {joint.chain} carries no part of the mesh."));
            Assert.That(Vector3.Distance(none.Position, Skeleton.GetJoint(joint.chain, joint.joint)), Is.LessThan(1e-5f));
            Do("Space Evenly");
            Assert.That(Find(Surface()).Where(p => p.Kind == RigProblemKind.NoMass), Is.Empty);
        }

        [Test]
        public void MeshAroundOneJoint_ConcentratesTheMass()
        {
            SurfaceMesh surface = Surface();
            for (int k = 0; k < surface.positions.Length; k++)
            {
                Vector3 joint = Skeleton.GetJoint(2, 2);
                surface.positions[k] = joint + 0.12f * (surface.positions[k] - joint)
                    + new Vector3(0.2f * Mathf.Max(0f, surface.positions[k].x - 0.58f), 0f, 0f);
            }

            List<RigProblem> problems = Find(surface);

            RigProblem heavy = problems.First(problem => problem.Kind == RigProblemKind.MassConcentrated);
            Assert.That(heavy.Joints, Is.EqualTo(new[] { new JointIndex(2, 2) }));
            Assert.That(heavy.Message, Does.Match(@"^Joint 2 of chain 2 carries [\d.]+ % of the wing's mass\.$"));
        }

        [TestCase(5, 5, 0.2f)]
        [TestCase(3, 3, 0.4f)]
        [TestCase(3, 5, 1f / 3f)]
        public void Mass_IsConcentrated_FromFiveTimesTheMean_OrTwoFifthsOfTheWing(int chains, int joints, float limit)
        {
            Editing.Do("Set Counts", (draft, selected) => ResampleCommands.ToCounts(draft, chains, joints));
            var rig = RigInspection.TryMake(Skeleton, Surface(), 0, out _);
            rig.masses[joints + 1] = 0.97f * limit;
            Assert.That(RigProblems.Find(rig), Is.Empty);
            rig.masses[joints + 1] = 1.03f * limit;
            RigProblem heavy = RigProblems.Find(rig).Single();

            Assert.That(heavy.Kind, Is.EqualTo(RigProblemKind.MassConcentrated));
            Assert.That(heavy.Joints, Is.EqualTo(new[] { new JointIndex(1, 1) }));
            Assert.That(RigProblems.Summary(rig), Is.EqualTo(System.FormattableString.Invariant(
                $"{rig.triangles.Count} triangles, {rig.PatchCount} patches, heaviest joint {103f * limit:0.#} %")));
        }

        [Test]
        public void WingOfOtherSize_DoesNotFit_AndSaysSoAsBakingDoes()
        {
            SurfaceMesh surface = Surface();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k] *= 5f;

            RigProblem misfit = Find(surface)[0];

            Assert.That(misfit.Kind, Is.EqualTo(RigProblemKind.DoesNotFit));
            Assert.That(() => WingRig.Bake(Skeleton, surface, WingRigSettings.Default),
                Throws.ArgumentException.With.Message.EqualTo(misfit.Message));
            Assert.That(misfit.Joints, Has.Count.EqualTo(25));
        }

        private static void Lift(SurfaceMesh surface, System.Predicate<Vector3> part)
        {
            for (int k = 0; k < surface.positions.Length; k++)
            {
                if (part(surface.positions[k]))
                    surface.positions[k].y += 0.08f;
            }
        }

        private List<RigProblem> Find(SurfaceMesh surface)
        {
            var rig = RigInspection.TryMake(Skeleton, surface, 0, out string refusal);
            Assert.That(refusal, Is.Null);
            return RigProblems.Find(rig);
        }
    }
}
