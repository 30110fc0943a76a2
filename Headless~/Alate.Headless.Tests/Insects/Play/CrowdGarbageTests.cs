using System;
using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    public sealed class CrowdGarbageTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator AFrame_AllocatesNothing_AndSchedulesTheSameJobs(
            [Values(1, 20)] int insects, [Values] bool motion) => Check(insects, motion);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AFrameOfFourHundred_AllocatesNothing_AndSchedulesTheSameJobs() => Check(400, false);

        private IEnumerator Check(int insects, bool motion)
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            WingSkeleton skeleton = Keep(TestWings.Fan());
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            for (int k = 0; k < insects; k++)
                Hatch(mesh, skeleton, preset, motion);
            yield return Frames(60);
            Assert.That(WingSystem.InsectCount, Is.EqualTo(insects));

            FrameLoop loop = WingSystem.Loop;
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int round = 0; round < 10; round++)
            {
                loop.FixedStep(0.02f);
                loop.Frame(0.02f, 0.02f);
            }

            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
            long steps = loop.StepCount, jobs = loop.World.JobCount;
            loop.FixedStep(0.02f);
            loop.Frame(0f, 0f);
            Assert.That(loop.World.JobCount - jobs, Is.EqualTo(2), "one step job and one skinning job, however many insects");
            Assert.That(loop.StepCount - steps, Is.EqualTo(1), "one step job a fixed step, however many insects");
        }

        private void Hatch(Mesh mesh, WingSkeleton skeleton, WingPreset preset, bool motion)
        {
            GameObject root = Keep(new GameObject("insect"));
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            insect.Preset = preset;
            insect.Quality.motionVectors = motion;
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
            {
                var wing = new GameObject("wing");
                wing.transform.SetParent(root.transform, false);
                wing.transform.localScale = new Vector3(side == WingSide.Right ? 1f : -1f, 1f, 1f);
                wing.AddComponent<MeshFilter>().sharedMesh = mesh;
                insect.Wings.Add(new Wing { Renderer = wing.AddComponent<MeshRenderer>(), Side = side, Skeleton = skeleton });
            }

            insect.Quality.culling = WingCulling.AlwaysSimulate;
            root.SetActive(true);
        }
    }
}
