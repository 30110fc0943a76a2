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
        public IEnumerator AHundredAtOnce_AppearOverAFewFrames()
        {
            Mesh fine = Keep(TestWings.ToMesh(TestWings.Ellipse(60, 40)));
            var swarm = new List<InsectWings>();
            for (int k = 0; k < 100; k++)
                swarm.Add(Hatch(made => Filter(made, 0).sharedMesh = Filter(made, 1).sharedMesh = fine));
            yield return null;
            var counts = new List<int>();
            for (int frame = 0; frame < 12; frame++)
            {
                yield return null;
                counts.Add(WingSystem.InsectCount);
            }

            Assert.That(counts[0], Is.InRange(1, 50), "all of them in one frame");
            Assert.That(counts[11], Is.EqualTo(100), "they do not all come");
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
