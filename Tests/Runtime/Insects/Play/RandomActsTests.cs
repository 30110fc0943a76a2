using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Random sequences of acts on insects break nothing, and all resources come back.</summary>
    public class RandomActsTests : PlayFixture
    {
        private const int k_ManyActs = 10000, k_ActsPerFrame = 20;

        /// <summary>Acts of the plain run.</summary>
        protected virtual int Acts => 3000;

        [UnityTest]
        public IEnumerator RandomActs_LeaveNothingBroken()
        {
            yield return Act(20240817, Acts);
        }

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator ManyRandomActs_LeaveNothingBroken()
        {
            yield return Act(20240817, k_ManyActs);
        }

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator ManyRandomActsOfAnySeed_LeaveNothingBroken()
        {
            int seed = System.Environment.TickCount;
            TestContext.WriteLine($"seed {seed}");
            yield return Act(seed, k_ManyActs);
        }

        private IEnumerator Act(int seed, int acts)
        {
            var zoo = new Zoo(seed);
            ActInFixedUpdate early = new GameObject("early").AddComponent<ActInFixedUpdate>();
            early.zoo = zoo;
            for (int act = 0; act < acts; act += k_ActsPerFrame)
            {
                Time.captureDeltaTime = zoo.FrameTime();
                for (int k = 0; k < k_ActsPerFrame; k++)
                    zoo.ActOnce();
                yield return null;
                if (act % 1000 == 0)
                    zoo.CheckVertices();
            }

            Object.Destroy(early.gameObject);
            Time.timeScale = 1f;
            Time.captureDeltaTime = 1f / 60f;
            yield return Frames(3);
            zoo.CheckVertices();
            zoo.DisableAll();
            zoo.CheckAuthoredMeshes();
            zoo.DestroyAll();
            yield return Frames(2);
        }
    }
}
