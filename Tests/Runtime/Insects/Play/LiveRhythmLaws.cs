using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Thresholds of jumps and of rest, times that content waits, and the order in which components run.</summary>
    public sealed class LiveRhythmLaws : FlockFixture
    {
        // Distances are in wing lengths as they are drawn: two units here.
        [UnityTest]
        public IEnumerator AMoveBeyondItsDistance_IsAJump([Values(4f, 25f)] float lengths, [Values] bool isBeyond)
        {
            InsectWings insect = Jumping(made =>
            {
                made.Motion.teleportDistance = lengths;
                made.transform.localScale = 2f * Vector3.one;
            });
            yield return Frames(30);
            float drawn = insect.Live.wings[0].placed.length;
            Assert.That(drawn, Is.EqualTo(2f).Within(5).Percent);
            float beats = Beats(insect);
            insect.transform.position += (isBeyond ? 1.02f : 0.98f) * lengths * drawn * Vector3.forward;
            yield return Frames(2);
            Assert.That(Beats(insect), isBeyond ? Is.LessThan(0.6f) : Is.GreaterThan(beats));
        }

        // At 180 degrees, beyond which there is nothing, none is.
        [UnityTest]
        public IEnumerator ATurnBeyondItsAngle_IsAJump([Values(40f, 170f, 180f)] float most, [Values] bool isBeyond)
        {
            InsectWings insect = Jumping(made => made.Motion.teleportAngle = most);
            yield return Frames(30);
            float beats = Beats(insect);
            insect.transform.Rotate(0f, math.min(most + (isBeyond ? 2f : -2f), 179.9f), 0f);
            yield return Frames(2);
            Assert.That(Beats(insect), isBeyond && most < 180f ? Is.LessThan(0.6f) : Is.GreaterThan(beats));
        }

        // Against a spin the change is more than half a turn.
        [UnityTest]
        public IEnumerator ATurnAgainstASpin_IsAJump_WhereTurnsMayBe([Values(170f, 180f)] float most)
        {
            InsectWings insect = Jumping(made => made.Motion.teleportAngle = most);
            for (int frame = 0; frame < 40; frame++)
            {
                insect.transform.Rotate(0f, -20f, 0f);
                yield return null;
            }

            float beats = Beats(insect);
            Assert.That(beats, Is.GreaterThan(3f));
            insect.transform.Rotate(0f, 175f, 0f);
            yield return Frames(2);
            Assert.That(Beats(insect), most < 180f ? Is.LessThan(0.6f) : Is.GreaterThan(beats));
        }

        // Two wings of one mesh and one of another, listed in any order.
        [UnityTest]
        public IEnumerator WingsOfOneMesh_AreBuiltTogether_AndAgainWhereTheListOfThemChanges()
        {
            Mesh both = Keep(Both());
            InsectWings insect = Hatch(made =>
            {
                TakeOneOf(both, made.Wings[0]);
                made.Wings.Add(new Wing
                {
                    Renderer = made.Wings[0].Renderer,
                    Part = WingPart.Submesh,
                    Submesh = 1,
                    Side = WingSide.Left,
                });
            });
            yield return Frames(3);
            LiveMesh shared = Of(0), other = Of(1);
            Assert.That((insect.State, shared.wings.Length), Is.EqualTo((InsectState.Ready, 2)), insect.Problem.Message);
            yield return Built(2);
            Assert.That(Of(2), Is.SameAs(shared));

            insect.Wings[0].PhaseLead = 10f;
            insect.Wings.Insert(0, insect.Wings[1]);
            insect.Wings.RemoveAt(2);
            yield return Built(2);
            Assert.That((Of(1), Of(0)), Is.EqualTo((shared, other)), "another order among the meshes");

            (insect.Wings[1], insect.Wings[2]) = (insect.Wings[2], insect.Wings[1]);
            yield return Built(2);
            Assert.That(Of(1), Is.Not.SameAs(shared), "another order within the mesh");
            Assert.That(Of(0), Is.SameAs(other));
            shared = Of(1);

            Wing last = insect.Wings[2];
            insect.Wings.RemoveAt(2);
            yield return Built(1);
            Assert.That(Of(1), Is.Not.SameAs(shared));
            insect.Wings.Add(last);
            yield return Built(2);
            Assert.That(Of(0), Is.SameAs(other));

            LiveMesh Of(int wing) => insect.Live.meshes.Find(mesh => mesh.wings.Contains(insect.Live.wings[wing]));

            IEnumerator Built(int wings)
            {
                yield return Frames(3);
                Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
                Assert.That(insect.Live.wings.Select(wing => wing.renderer), Is.EqualTo(insect.Wings.Select(wing => wing.Renderer)));
                Assert.That(insect.Live.meshes.Sum(mesh => mesh.wings.Length), Is.EqualTo(wings + 1));
                Assert.That(insect.Live.meshes.Select(mesh => mesh.renderer), Is.Unique);
            }
        }

        // What is no wing stays where the mesh has it: its vertices have no joint.
        [UnityTest]
        public IEnumerator OnlyVerticesOfWings_HaveJoints()
        {
            Mesh both = Keep(Both());
            InsectWings insect = Hatch(made => TakeOneOf(both, made.Wings[0]));
            yield return Frames(3);
            MeshTemplate template = insect.Live.meshes.Find(mesh => mesh.wings.Contains(insect.Live.wings[0])).template;
            var joints = new List<Vector4>();
            template.Skinned.GetUVs(SkinnedMesh.Channel, joints);

            float[] held = template.Skinned.GetTriangles(0).Select(vertex => joints[vertex].x).ToArray();
            Assert.That(held.Min(), Is.Zero);
            Assert.That(held.Max(), Is.InRange(1f, template.JointCount - 1f));
            Assert.That(template.Skinned.GetTriangles(1).Select(vertex => joints[vertex].x), Is.All.Negative);
        }

        // The first submesh is the wing.
        private static void TakeOneOf(Mesh both, Wing wing)
        {
            wing.Renderer.GetComponent<MeshFilter>().sharedMesh = both;
            wing.Part = WingPart.Submesh;
            wing.Skeleton = null;
        }

        private static Mesh Both()
        {
            SurfaceMesh wing = TestWings.Ellipse();
            int count = wing.positions.Length;
            Vector3[] right = System.Array.ConvertAll(wing.positions, p => p + 0.1f * Vector3.right);
            Vector3[] left = System.Array.ConvertAll(right, p => Vector3.Scale(p, new Vector3(-1f, 1f, 1f)));
            var mesh = new Mesh { name = "both", vertices = right.Concat(left).ToArray(), subMeshCount = 2 };
            mesh.SetTriangles(wing.triangles, 0);
            mesh.SetTriangles(SurfaceMesh.Turned(System.Array.ConvertAll(wing.triangles, vertex => vertex + count)), 1);
            mesh.RecalculateNormals();
            mesh.RecalculateBounds();
            return mesh;
        }

        // A wing that comes to rest is at rest for the choice of its detail, though it still moves.
        [UnityTest]
        public IEnumerator OneThatComesToRest_GoesOn_ThoughItGrowsALittle()
        {
            Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            camera.farClipPlane = 1e5f;
            camera.fieldOfView = 60f;
            WingSystem.DetailCameras.Add(camera);
            InsectWings insect = Hatch(made => made.Quality.screenHeights.restBelow = 0.01f);
            Look(0.009f);
            yield return Frames(10);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.WavesOnly));
            Look(0.0113f);
            yield return Frames(60);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.Frozen));
            Look(0.0117f);
            yield return Frames(3);
            Assert.That(insect.Detail, Is.EqualTo(WingDetail.WavesOnly));

            void Look(float height) => camera.transform.position =
                QualitySettings.lodBias / (height * math.tan(math.radians(30f))) * Vector3.back;
        }

        // Content waits from when the last of its insects went.
        [UnityTest]
        public IEnumerator APoolOfContent_CountsFromItsLastUse()
        {
            InsectWings keeper = Hatch(made => Filter(made, 0).sharedMesh = Keep(TestWings.ToMesh(TestWings.Ellipse(10, 8))));
            InsectWings insect = Hatch();
            yield return Frames(40);
            WingSystem.Patience = 0.5f;
            MeshTemplate baked = insect.Live.meshes[0].template;
            keeper.Wings.RemoveAt(1);
            yield return Frames(3);
            insect.enabled = false;
            yield return Frames(20);
            insect.enabled = true;
            yield return Frames(3);
            Assert.That(insect.Live.meshes[0].template, Is.SameAs(baked), "a third of a second");
            insect.enabled = false;
            yield return Frames(35);
            insect.enabled = true;
            yield return Frames(3);
            Assert.That(insect.Live.meshes[0].template, Is.Not.SameAs(baked));
            WingSystem.Patience = 0f;
        }

        [UnityTest]
        public IEnumerator AZoneThatCameWithAnInsect_IsFound()
        {
            InsectWings first = Hatch();
            yield return Frames(130);
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            (zone.windMain, zone.windTurbulence, zone.windPulseMagnitude) = (5f, 0f, 0f);
            yield return Frames(5);
            Assert.That(math.length(first.Live.flight.wind), Is.Zero);
            Hatch();
            yield return Frames(5);
            Assert.That(math.length(first.Live.flight.wind), Is.EqualTo(5f).Within(1e-4f));
        }

        // Insects begin before scripts that ask for them; wings move after all that moves them, and before what reads them.
        [Test]
        public void Components_RunInTheOrderOfTheirWork()
        {
            int[] orders =
            {
                ExecutionOrders.InsectWings, 0, ExecutionOrders.CrowdPoses, ExecutionOrders.Crowd, ExecutionOrders.WingSystem,
                ExecutionOrders.AfterWings, 32000,
            };
            Assert.That(orders, Is.Ordered.And.Unique);
            Assert.That(orders.Skip(2).Zip(orders.Skip(3), (a, b) => b - a), Is.All.GreaterThanOrEqualTo(100), "with room for others");
            Assert.That(orders.Last(), Is.LessThan(short.MaxValue));
        }

        private InsectWings Jumping(System.Action<InsectWings> prepare) => Hatch(made =>
        {
            made.Motion.onTeleport = TeleportResponse.Reset;
            prepare(made);
        });
    }
}
