using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using StandIns;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.PlaySessions
{
    /// <summary>Playing, leaving and playing again without a reload of the domain: what is static survives, nothing else may.</summary>
    public sealed class PlaySessionTests
    {
        private Mesh m_Mesh;
        private WingSkeleton m_Skeleton;

        [SetUp]
        public void MakeTheWing()
        {
            m_Mesh = TestWings.ToMesh(TestWings.Ellipse());
            m_Skeleton = TestWings.Fan();
        }

        [TearDown]
        public void DestroyTheWing()
        {
            if (PlayerLoop.IsPlaying)
                PlayerLoop.ExitPlayMode();
            Object.DestroyImmediate(m_Mesh);
            Object.DestroyImmediate(m_Skeleton);
        }

        [UnityTest]
        public IEnumerator LeavingPlayWithLivingInsects_LeavesNothing_AndPlayCanBeginAgain()
        {
            int memory = NativeMemoryLedger.LiveCount;
            for (int session = 0; session < 3; session++)
            {
                InsectWings insect = Make(), disabled = Make();
                disabled.enabled = false;
                yield return new EnterPlayMode(false);
                for (int frame = 0; frame < 10; frame++)
                    yield return null;
                Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
                Assert.That(WingSystem.InsectCount, Is.EqualTo(1));
                insect.WingBeat += _ => { };

                yield return new ExitPlayMode();
                Assert.That(WingSystem.Loop, Is.Null);
                Assert.That(WingSystem.InsectCount, Is.Zero);
                Assert.That(LivingMeshes.Count, Is.Zero);
                Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory), NativeMemoryLedger.Describe());
                Assert.That(Resources.FindObjectsOfTypeAll<Mesh>().Where(m => m.name.Contains("(living)")), Is.Empty);
            }
        }

        [UnityTest]
        public IEnumerator LeavingPlayInTheMiddleOfBirthsAndEnds_LeavesNothing()
        {
            int memory = NativeMemoryLedger.LiveCount;
            Make();
            yield return new EnterPlayMode(false);
            yield return null;
            InsectWings going = Make();
            yield return null;
            Object.Destroy(going.gameObject);
            Object.Instantiate(Make());
            InsectWings broken = Make();
            broken.Wings[0].Renderer = null;

            yield return new ExitPlayMode();
            Assert.That(WingSystem.Loop, Is.Null);
            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory), NativeMemoryLedger.Describe());
            Assert.That(Resources.FindObjectsOfTypeAll<Mesh>().Where(m => m.name.Contains("(living)")), Is.Empty);
        }

        [UnityTest]
        public IEnumerator LeavingPlay_AfterTheSystemHasGone_LeavesNothingOfGeneratedInsects([Values] bool isRecompiled)
        {
            yield return new EnterPlayMode(false);
            int before = Hidden();
            WingSystem.Patience = 0f;
            InsectWings insect = InsectFactory.Create("monarch");
            yield return null;
            if (isRecompiled)
                DomainReload.Run();
            insect.enabled = false;
            WingSystem.Patience = 0f;
            yield return null;
            yield return null;
            Assert.That(WingSystem.Loop, Is.Null);
            Assert.That(Resources.FindObjectsOfTypeAll<WingSystem>(), Is.Empty);
            Assert.That(Hidden(), Is.GreaterThan(before));

            yield return new ExitPlayMode();
            Assert.That(Hidden(), Is.EqualTo(before), "what play no longer ends stays hidden in the editor");
        }

        [UnityTest]
        public IEnumerator TheEndOfPlay_IsToldOnce_InEachSession()
        {
            for (int session = 1; session <= 3; session++)
            {
                int told = 0;
                yield return new EnterPlayMode(false);
                PlayEnd.Ended += () => told++;
                Assert.That(PlayEnd.HasCome, Is.False);
                yield return new ExitPlayMode();
                Assert.That(told, Is.EqualTo(1), $"session {session}");
            }
        }

        [UnityTest]
        public IEnumerator AfterTheEndOfPlay_NothingStarts()
        {
            yield return new EnterPlayMode(false);
            Application.quitting += StartLate;
            yield return new ExitPlayMode();
            Application.quitting -= StartLate;
            Assert.That(WingSystem.Loop, Is.Null);

            // A new session is not at its end.
            yield return new EnterPlayMode(false);
            InsectWings insect = Make();
            yield return null;
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            yield return new ExitPlayMode();
        }

        [UnityTest]
        public IEnumerator WhatStaticsRemember_IsForgottenAtTheNextPlay()
        {
            try
            {
                for (int session = 0; session < 2; session++)
                {
                    yield return new EnterPlayMode(false);
                    Assert.That(GeneratedAssets.InUse, Is.Empty);
                    Assert.That(Flock.Pilots, Is.Empty);
                    Assert.That(WingSystem.DetailCameras, Is.Empty);
                    WingSystem.DetailCameras.Add(null);
                    BuiltPlayer.IsRunning = true;
                    LogAssert.Expect(LogType.Warning, new Regex("'hind wing'.*_ALPHABLEND_ON of Standard"));
                    var look = new SurfaceLook(null, true, PictureOpacity.Clear);
                    Material one = WingMaterial.Create(ProjectShaders.Add("Standard"), "hind wing", look);
                    Material two = WingMaterial.Create(one.shader, "fore wing", look);
                    LogAssert.NoUnexpectedReceived();
                    BuiltPlayer.IsRunning = false;
                    GeneratedAssets.Acquire("firefly");
                    Assert.That(GeneratedAssets.InUse.Single().Users, Is.EqualTo(1));
                    SharedAssets left = GeneratedAssets.InUse.Single();
                    yield return new ExitPlayMode();
                    left.Free();
                    Object.DestroyImmediate(one);
                    Object.DestroyImmediate(two);
                }
            }
            finally
            {
                BuiltPlayer.IsRunning = false;
                ProjectShaders.Clear();
                GeneratedAssets.Return("firefly");
                WingSystem.DetailCameras.Clear();
            }
        }

        private void StartLate()
        {
            Make();
            Assert.That(WingSystem.Loop, Is.Null, "an insect started after the end of play");
        }

        private static int Hidden() => Resources.FindObjectsOfTypeAll<Object>().Count(o => o.hideFlags == HideFlags.HideAndDontSave);

        [UnityTest]
        public IEnumerator InTheEditor_AnInsectDoesNotLive()
        {
            InsectWings insect = Make();
            yield return null;

            Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));
            Assert.That(insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(m_Mesh));
            insect.ResetState();
            insect.Teleport();
            Assert.That(insect.Frequency, Is.Zero);
            Object.DestroyImmediate(insect.gameObject);
        }

        private InsectWings Make()
        {
            var root = new GameObject("insect");
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            var drawn = new GameObject("wing");
            drawn.transform.SetParent(root.transform, false);
            drawn.AddComponent<MeshFilter>().sharedMesh = m_Mesh;
            insect.Wings.Add(new Wing { Renderer = drawn.AddComponent<MeshRenderer>(), Skeleton = m_Skeleton });
            insect.Quality.culling = WingCulling.AlwaysSimulate;
            root.SetActive(true);
            return insect;
        }
    }
}
