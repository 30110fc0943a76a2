using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Motion vectors of baked insects: each call says where its insects were in the last frame.</summary>
    public sealed class CrowdMotionTests : CrowdFixture
    {
        private RenderPipelineAsset m_Pipeline;

        [SetUp]
        public void UseAPipeline()
        {
            m_Pipeline = ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>();
            GraphicsSettings.defaultRenderPipeline = m_Pipeline;
        }

        [TearDown]
        public void UseTheBuiltInPipeline()
        {
            GraphicsSettings.defaultRenderPipeline = null;
            Object.DestroyImmediate(m_Pipeline);
        }

        [UnityTest]
        public IEnumerator EachCall_HasTheLastFramesMatricesAndRows()
        {
            Scene = new CrowdScene("monarch", 2, "cruise", "rest");
            Scene.Crowd.MotionVectors = true;
            PlaceAll(0f);
            DrawnBatch before = null;
            for (int frame = 0; frame < 6; frame++)
            {
                PlaceAll(frame);
                DrawnInstances.Calls = new List<DrawnBatch>();
                yield return null;
                if (DrawnInstances.Calls.Count == 0)
                    continue;
                DrawnBatch now = DrawnInstances.Calls[0];
                Assert.That(now.Parameters.motionVectorMode, Is.EqualTo(MotionVectorGenerationMode.Object));
                Assert.That(now.Matrices, Has.Length.EqualTo(2));
                DrawnBatch last = before ?? now;
                Assert.That(now.LastMatrices, Is.EqualTo(last.Matrices), $"frame {frame}");
                Assert.That(now.Properties["_BakeLastRows"].Take(2), Is.EqualTo(last.Properties["_BakeRows"].Take(2)));
                IEnumerable<Vector4> known =
                    last.Properties["_BakeNextRows"].Take(2).Select(rows => new Vector4(rows.x, rows.y, rows.z, 1f));
                Assert.That(now.Properties["_BakeLastNextRows"].Take(2), Is.EqualTo(known));
                before = now;
            }

            Assert.That(before.LastMatrices[0], Is.Not.EqualTo(before.Matrices[0]));
            Assert.That(before.Properties["_BakeLastRows"][0], Is.Not.EqualTo(before.Properties["_BakeRows"][0]));
        }

        [UnityTest]
        public IEnumerator ACrowdThatWantsNone_OrInTheBuiltInPipeline_HasNone([Values] bool builtIn)
        {
            if (builtIn)
                GraphicsSettings.defaultRenderPipeline = null;
            Scene = new CrowdScene("monarch", 2, "cruise");
            Scene.Crowd.MotionVectors = builtIn;
            PlaceAll(0f);
            yield return null;
            DrawnInstances.Calls = new List<DrawnBatch>();
            yield return null;
            Assert.That(DrawnInstances.Calls, Is.Not.Empty);
            foreach (DrawnBatch call in DrawnInstances.Calls)
            {
                Assert.That(call.LastMatrices, Is.Null);
                Assert.That(call.Parameters.motionVectorMode, Is.EqualTo(MotionVectorGenerationMode.Camera));
                Assert.That(call.Properties.Keys, Has.None.StartWith("_BakeLast"));
            }
        }

        [UnityTest]
        public IEnumerator TheyCanBeTurnedOn_WhileTheCrowdFlies()
        {
            Scene = new CrowdScene("monarch", 2, "cruise");
            PlaceAll(0f);
            yield return Frames(3);
            float phase = Scene.Crowd.Poses[1].phase;
            foreach (bool on in new[] { true, false })
            {
                Scene.Crowd.MotionVectors = on;
                yield return Frames(2);
                DrawnInstances.Calls = new List<DrawnBatch>();
                yield return null;
                Assert.That(DrawnInstances.Calls[0].LastMatrices != null, Is.EqualTo(on));
                Assert.That(DrawnInstances.Calls[0].Matrices, Has.Length.EqualTo(2));
            }

            Assert.That(Scene.Crowd.Poses[1].phase, Is.Not.EqualTo(phase), "it flies on");
            Assert.That(Scene.Crowd.Poses[1].position.x, Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator AFrame_AllocatesNothing()
        {
            Scene = new CrowdScene("monarch", 600, "cruise");
            Scene.Crowd.MotionVectors = true;
            for (int insect = 0; insect < 600; insect++)
                Scene.Place(insect, CrowdPose.At(new float3(0.01f * insect, 0f, 0f), quaternion.identity, 0.1f));
            yield return Frames(3);

            long before = System.GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 10; frame++)
            {
                Scene.Crowd.RunFrame(0.02f);
                Scene.Crowd.RunCamera(Scene.Camera);
            }

            Assert.That(System.GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }

        private void PlaceAll(float frame)
        {
            NativeArray<CrowdPose> poses = Scene.Crowd.Poses;
            for (int insect = 0; insect < poses.Length; insect++)
            {
                var pose = CrowdPose.At(
                    new float3(insect + 0.1f * frame, 0.2f * frame, 0f), quaternion.RotateY(0.3f * frame), math.frac(0.13f * frame));
                pose.nextLoop = 1;
                pose.blend = 0.3f;
                poses[insect] = pose;
            }
        }
    }
}
