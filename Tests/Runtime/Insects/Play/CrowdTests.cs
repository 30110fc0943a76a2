using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Many insects at once.</summary>
    public sealed class CrowdTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator AHundredAtOnce_AppearOverManyFrames_FewInEachAfterTheFirst()
        {
            Mesh fine = Keep(TestWings.ToMesh(TestWings.Ellipse(60, 40)));
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 100; k++)
                swarm.Add(Hatch(made => Filter(made, 0).sharedMesh = Filter(made, 1).sharedMesh = fine));
            yield return null;
            yield return null;
            Assert.That(WingSystem.InsectCount, Is.InRange(10, 50), "in the first frame");
            int frames = 0, each = 2 * fine.vertexCount;
            while (WingSystem.InsectCount < 100 && frames++ < 100)
            {
                int before = WingSystem.InsectCount;
                yield return null;
                int came = WingSystem.InsectCount - before;
                Assert.That(came, Is.EqualTo(System.Math.Min(100 - before, (10240 + each - 1) / each)), "in each after it");
            }

            Assert.That(WingSystem.InsectCount, Is.EqualTo(100), "they do not all come");
            Assert.That(swarm.TrueForAll(insect => insect.State == InsectState.Ready));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator SmallOnes_AllComeAtOnce_AndShareOneTemplateAndFewPacks()
        {
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 60; k++)
                swarm.Add(Hatch());
            yield return Frames(2);

            Assert.That(WingSystem.InsectCount, Is.EqualTo(60));
            Assert.That(WingSystem.Loop.World.PackCount, Is.EqualTo(30), "four wings a pack");
            Assert.That(swarm[59].Live.meshes[1].template, Is.SameAs(swarm[0].Live.meshes[0].template));
        }

        // A frame compares 64 insects with what they were built of.
        [UnityTest]
        public IEnumerator OfALargeCrowd_EachChange_IsSeenWithinAFewFrames_AndDestroyedWingsHarmNobody()
        {
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 200; k++)
                swarm.Add(Hatch());
            while (WingSystem.InsectCount < 200)
                yield return null;
            Mesh other = Keep(Object.Instantiate(WingMesh));
            foreach (int k in new[] { 0, 100, 199 })
                Filter(swarm[k], 1).sharedMesh = other;
            Object.Destroy(swarm[50].Wings[0].Renderer.gameObject);
            Object.Destroy(Filter(swarm[150], 0).sharedMesh);
            yield return Frames(1 + (200 + 63) / 64);

            foreach (int k in new[] { 0, 100, 199 })
                Assert.That(swarm[k].Live.meshes[1].template.Source, Is.SameAs(other));
            Assert.That(swarm[50].State, Is.EqualTo(InsectState.NoRenderer));
            Assert.That(swarm[150].State, Is.EqualTo(InsectState.Ready), "its mesh was made again");
            Assert.That(Filter(swarm[150], 0).sharedMesh, Is.Not.Null);
            Assert.That(WingSystem.InsectCount, Is.EqualTo(199));
        }

        [UnityTest]
        public IEnumerator AThinnedCrowd_StaysDense()
        {
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 40; k++)
                swarm.Add(Hatch());
            yield return Frames(5);
            for (int k = 0; k < 40; k++)
            {
                if (k % 4 != 0)
                    Object.Destroy(swarm[k].gameObject);
            }

            yield return Frames(3);
            Assert.That(WingSystem.InsectCount, Is.EqualTo(10));
            Assert.That(WingSystem.Loop.World.PackCount, Is.LessThanOrEqualTo(6));
        }

        [UnityTest]
        public IEnumerator StartPhases_SpreadTheBeats()
        {
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 4; k++)
            {
                float phase = 90f * k;
                swarm.Add(Hatch(made => made.StartPhase = phase));
            }

            yield return Frames(30);
            for (int k = 1; k < 4; k++)
                Assert.That(Mathf.Repeat(swarm[k].Phase - swarm[0].Phase, 360f), Is.EqualTo(90f * k).Within(0.5f));
        }
    }
}
