using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that go and come back, and what waits for them.</summary>
    public sealed class PoolTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator ThePool_TakesItsLastInsectBack_WithoutBakingAnew()
        {
            WingSystem.Patience = 10f;
            InsectWings insect = Hatch();
            yield return Frames(5);
            MeshTemplate baked = insect.Live.meshes[0].template;
            FrameLoop loop = WingSystem.Loop;

            insect.gameObject.SetActive(false);
            yield return Frames(60);
            Assert.That(Shown(insect, 0), Is.SameAs(WingMesh));
            Assert.That(WingSystem.InsectCount, Is.Zero);
            insect.gameObject.SetActive(true);
            yield return Frames(3);

            Assert.That(WingSystem.Loop, Is.SameAs(loop));
            Assert.That(insect.Live.meshes[0].template, Is.SameAs(baked));
            WingSystem.Patience = 0f;
        }

        [UnityTest]
        public IEnumerator WhenNobodyComesBack_EverythingGoes()
        {
            WingSystem.Patience = 0.5f;
            InsectWings insect = Hatch();
            yield return Frames(5);
            insect.gameObject.SetActive(false);
            yield return Frames(20);
            Assert.That(WingSystem.Loop, Is.Not.Null);
            yield return Frames(30);
            Assert.That(WingSystem.Loop, Is.Null);
            Assert.That(Object.FindAnyObjectByType<WingSystem>(), Is.Null);
        }

        [UnityTest]
        public IEnumerator AMeshThatAScriptChanged_IsTakenUpByAllThatShareIt()
        {
            InsectWings insect = Hatch(), twin = Hatch();
            yield return Frames(5);
            Vector3[] vertices = WingMesh.vertices;
            Color[] colours = System.Array.ConvertAll(vertices, _ => Color.red);
            WingMesh.colors = colours;
            yield return Frames(3);
            Assert.That(Shown(insect, 0).colors, Is.Empty, "it was read without being asked to");

            insect.Rebuild();
            yield return Frames(3);

            Assert.That(Shown(insect, 0).colors, Has.Length.EqualTo(vertices.Length).And.All.EqualTo(Color.red));
            Assert.That(Shown(twin, 1).colors, Has.Length.EqualTo(vertices.Length));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator ASystemThatNobodyCalled_Goes_AndTroublesNobody()
        {
            InsectWings insect = Hatch();
            yield return Frames(3);
            FrameLoop loop = WingSystem.Loop;
            GameObject stray = Keep(new GameObject("stray", typeof(WingSystem)));
            yield return Frames(4);

            Assert.That(stray == null, Is.True, "two systems run");
            Assert.That(WingSystem.Loop, Is.SameAs(loop));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AnInsectMadeByScript_MayGetItsListAfterwards()
        {
            GameObject root = Keep(new GameObject("made"));
            Wing right = MakeWing(root.transform, WingSide.Right), left = MakeWing(root.transform, WingSide.Left);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Add(right);
            insect.Wings.Add(left);
            yield return Frames(3);

            Assert.That(insect.Wings, Is.EqualTo(new[] { right, left }));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
        }
    }
}
