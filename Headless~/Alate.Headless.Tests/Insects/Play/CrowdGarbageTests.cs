using System;
using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    public sealed class CrowdGarbageTests : PlayFixture
    {
        [SetUp]
        public void AddTheShader() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

        [TearDown]
        public void TakeTheShader() => ProjectShaders.Clear();

        [UnityTest]
        public IEnumerator AFrame_AllocatesNothing_AndSchedulesTheSameJobs(
            [Values(1, 20)] int insects, [Values] bool motion, [Values(WingSkinning.Cpu, WingSkinning.Gpu)] WingSkinning skinning) =>
            Check(insects, motion, skinning);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AFrameOfFourHundred_AllocatesNothing_AndSchedulesTheSameJobs() => Check(400, false, WingSkinning.Cpu);

        private IEnumerator Check(int insects, bool motion, WingSkinning skinning)
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            WingSkeleton skeleton = Keep(TestWings.Fan());
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            Material material = Keep(new Material(Shader.Find(WingMaterial.ShaderName)));
            for (int k = 0; k < insects; k++)
                Hatch(mesh, skeleton, preset, motion, skinning, material);
            yield return Frames(60);
            Assert.That(WingSystem.InsectCount, Is.EqualTo(insects));
            Assert.That(WingSystem.Loop.Skins.Table.Joints, skinning == WingSkinning.Gpu ? Is.GreaterThan(0) : Is.Zero);

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

        private void Hatch(Mesh mesh, WingSkeleton skeleton, WingPreset preset, bool motion, WingSkinning skinning, Material material)
        {
            GameObject root = Keep(new GameObject("insect"));
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            insect.Preset = preset;
            insect.Quality.motionVectors = motion;
            insect.Quality.skinning = skinning;
            foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
            {
                var wing = new GameObject("wing");
                wing.transform.SetParent(root.transform, false);
                wing.transform.localScale = new Vector3(side == WingSide.Right ? 1f : -1f, 1f, 1f);
                wing.AddComponent<MeshFilter>().sharedMesh = mesh;
                wing.AddComponent<MeshRenderer>().sharedMaterial = material;
                insect.Wings.Add(new Wing { Renderer = wing.GetComponent<MeshRenderer>(), Side = side, Skeleton = skeleton });
            }

            insect.Quality.culling = WingCulling.AlwaysSimulate;
            root.SetActive(true);
        }
    }
}
