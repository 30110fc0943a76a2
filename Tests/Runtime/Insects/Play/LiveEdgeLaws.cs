using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Living insects at the ends of what they take: restarts, renderers that change or go, clocks that go back, crowds.</summary>
    public sealed class LiveEdgeLaws : FlockFixture
    {
        // By hand and in a pause nothing else lets the wings be drawn.
        [UnityTest]
        public IEnumerator ARestart_IsSeen_ThoughNoStepFollows([Values] bool byHand)
        {
            InsectWings insect = Hatch(made => made.UpdateMode = byHand ? WingUpdateMode.Manual : WingUpdateMode.Update);
            yield return Frames(1);
            while (insect.State != InsectState.Ready)
                yield return null;
            Time.timeScale = 0f;
            insect.ResetState();
            yield return Frames(3);
            Vector3[] start = Shown(insect, 0).vertices;
            Time.timeScale = 1f;
            if (byHand)
                insect.Step(0.03f);
            yield return Frames(4);
            Time.timeScale = 0f;
            yield return Frames(3);
            Assert.That(Farthest(start, Shown(insect, 0).vertices), Is.GreaterThan(0.05f));
            insect.ResetState();
            yield return Frames(3);
            Assert.That(Farthest(start, Shown(insect, 0).vertices), Is.LessThan(1e-4f));
        }

        // Wings are looked for where none is listed; whoever lists one wants that one.
        [UnityTest]
        public IEnumerator AnInsectOfOneWing_KeepsThatOne_AndOneWithoutFindsAll([Values(0, 1)] int listed)
        {
            InsectWings insect = Hatch(made => made.Wings.RemoveRange(listed, 2 - listed));
            yield return Frames(3);

            Assert.That(insect.Wings, Has.Count.EqualTo(listed == 0 ? 2 : 1));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
        }

        [UnityTest]
        public IEnumerator ModeOfMotionVectors_IsGivenBack_WhereItWasTaken([Values] bool vectors)
        {
            InsectWings insect = Hatch(made =>
            {
                made.Quality.motionVectors = vectors;
                made.Wings[0].Renderer.motionVectorGenerationMode = MotionVectorGenerationMode.ForceNoMotion;
            });
            yield return Frames(3);
            MeshRenderer renderer = insect.Wings[0].Renderer;
            Assert.That(renderer.motionVectorGenerationMode,
                Is.EqualTo(vectors ? MotionVectorGenerationMode.Object : MotionVectorGenerationMode.ForceNoMotion));
            renderer.motionVectorGenerationMode = MotionVectorGenerationMode.Camera;
            insect.enabled = false;
            Assert.That(renderer.motionVectorGenerationMode,
                Is.EqualTo(vectors ? MotionVectorGenerationMode.ForceNoMotion : MotionVectorGenerationMode.Camera),
                "else it is a script's");
        }

        [UnityTest]
        public IEnumerator ARendererThatIsGone_IsNotAskedForAnything()
        {
            InsectWings insect = Hatch(made => made.Quality.motionVectors = true);
            yield return Frames(3);
            MeshFilter filter = Filter(insect, 0);
            Object.DestroyImmediate(insect.Wings[0].Renderer);
            insect.enabled = false;
            Assert.That(filter.sharedMesh, Is.SameAs(WingMesh));
            LogAssert.NoUnexpectedReceived();
        }

        // A clock that begins anew is behind the time at which it fell asleep.
        [UnityTest]
        public IEnumerator OneThatWakesBeforeItSlept_BeatsOnFromWhereItWas()
        {
            InsectWings insect = Hatch();
            yield return Frames(5);
            LiveInsect live = insect.Live;
            WingWorld world = WingSystem.Loop.World;
            var clocks = new Clocks();
            clocks.times[live.Clock].time = 100.0;
            live.Pace(world, WingDetail.Full, true, clocks);
            Assert.That(live.Detail, Is.EqualTo(WingDetail.Frozen));
            float beats = Beats(insect);
            clocks.times[live.Clock].time = 99.93;
            live.Pace(world, WingDetail.Full, false, clocks);
            Assert.That(live.Detail, Is.EqualTo(WingDetail.Full));
            Assert.That(Beats(insect), Is.EqualTo(beats).Within(1e-4f));
        }

        // A thousand metres a second of the real insect, in the units in which it is drawn.
        [UnityTest]
        public IEnumerator AWind_IsTakenUpToAThousandMetresASecond([Values(0f, 2f)] float metresPerUnit, [Values] bool isWithin)
        {
            InsectWings insect = Hatch(made =>
            {
                made.Motion.metresPerUnit = metresPerUnit;
                made.transform.localScale = 3f * Vector3.one;
            });
            yield return Frames(3);
            LiveWing wing = insect.Live.wings[0];
            Assert.That(wing.placed.length, Is.EqualTo(3f).Within(5).Percent);
            float most = metresPerUnit > 0f ? 1000f / metresPerUnit : 1000f * wing.placed.length / wing.values.size.wingLength;
            float speed = (isWithin ? 0.99f : 1.01f) * most;
            if (!isWithin)
                LogAssert.Expect(LogType.Warning, new Regex("'insect': a wind of .* is refused"));
            insect.Air.wind = new Vector3(0f, 0f, speed);
            yield return Frames(3);
            Assert.That(insect.Live.flight.wind.z, Is.EqualTo(isWithin ? speed : 0f).Within(1e-3).Percent);
        }

        // 131,072 vertices a frame while none lives, 10,240 later: the insect with which they are reached is the last. Each has two meshes.
        [UnityTest]
        public IEnumerator AFrame_StartsInsects_UntilItsVerticesAreReached([Values(33000, 32500)] int vertices)
        {
            HatchFour(vertices);
            int waited = 0;
            while (WingSystem.InsectCount == 0 && waited++ < 4)
                yield return null;
            int first = vertices == 33000 ? 2 : 3;
            for (int count = first; count <= 4; count++)
            {
                Assert.That(WingSystem.InsectCount, Is.EqualTo(count));
                yield return null;
            }
        }

        [UnityTest]
        public IEnumerator ALaterFrame_StartsFewerInsects([Values(2560, 2559)] int vertices)
        {
            Hatch();
            yield return Frames(3);
            HatchFour(vertices);
            int waited = 0;
            while (WingSystem.InsectCount == 1 && waited++ < 4)
                yield return null;
            Assert.That(WingSystem.InsectCount, Is.EqualTo(vertices == 2560 ? 3 : 4));
            yield return null;
            Assert.That(WingSystem.InsectCount, Is.EqualTo(5));
        }

        private void HatchFour(int vertices)
        {
            var positions = new Vector3[vertices];
            WingMesh.vertices.CopyTo(positions, 0);
            Mesh mesh = Keep(new Mesh { vertices = positions, triangles = WingMesh.triangles });
            for (int k = 0; k < 4; k++)
            {
                Hatch(made =>
                {
                    Filter(made, 0).sharedMesh = mesh;
                    Filter(made, 1).sharedMesh = mesh;
                });
            }
        }

        [UnityTest]
        public IEnumerator WhenOneComesBackInTime_TheSystemStays_LongerThanItsPatience()
        {
            WingSystem.Patience = 0.2f;
            InsectWings insect = Hatch();
            yield return Frames(3);
            FrameLoop loop = WingSystem.Loop;
            insect.gameObject.SetActive(false);
            yield return Frames(5);
            insect.gameObject.SetActive(true);
            yield return Frames(40);
            Assert.That(WingSystem.Loop, Is.SameAs(loop));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            WingSystem.Patience = 0f;
        }

        [UnityTest]
        public IEnumerator UnderAnotherBody_ItHasThatOnesVelocity()
        {
            InsectWings insect = Hatch(made => made.Motion.source = VelocitySource.Rigidbody);
            var bodies = new Rigidbody[2];
            for (int k = 0; k < 2; k++)
            {
                bodies[k] = Keep(new GameObject("body")).AddComponent<Rigidbody>();
                bodies[k].useGravity = false;
                bodies[k].AddForce(new Vector3(0f, 2f * k, 1f), ForceMode.VelocityChange);
            }

            foreach (Rigidbody body in bodies.Concat(bodies))
            {
                insect.transform.SetParent(body.transform, false);
                yield return Frames(5);
                Assert.That(math.distance(insect.Live.flight.velocity, new float3(0f, body == bodies[1] ? 2f : 0f, 1f)), Is.LessThan(0.1f));
            }

            insect.Motion.body = bodies[0];
            yield return Frames(3);
            Assert.That(insect.Live.flight.velocity.y, Is.Zero.Within(0.1f), "the one that it is given");
            insect.transform.SetParent(null, false);
        }

        private static float Farthest(Vector3[] a, Vector3[] b) => a.Zip(b, Vector3.Distance).Max();
    }
}
