using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Problems that are found without baking, whom they name, and how often they are told.</summary>
    public sealed class InsectCheckLaws : FlockFixture
    {
        [UnityTest]
        public IEnumerator ASubmesh_IsOneOfTheMesh()
        {
            InsectWings insect = Hatch(made => made.enabled = false);
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.subMeshCount = 3;
            Filter(insect, 1).sharedMesh = mesh;
            Wing wing = insect.Wings[1];
            wing.Part = WingPart.Submesh;
            foreach ((int submesh, InsectState state) in new[]
                { (-1, InsectState.NoSuchPart), (0, InsectState.Ready), (2, InsectState.Ready), (3, InsectState.NoSuchPart) })
            {
                wing.Submesh = submesh;
                InsectProblem problem = InsectCheck.Find(insect);
                Assert.That((problem.State, problem.Wing), Is.EqualTo((state, state == InsectState.Ready ? -1 : 1)), $"{submesh}");
                if (problem.IsProblem)
                    Assert.That(problem.Message, Does.Contain($"no submesh {submesh}. Choose one from 0 to 2."));
            }

            wing.Submesh = 9;
            wing.Part = WingPart.WholeMesh;
            Assert.That(InsectCheck.Find(insect).IsProblem, Is.False, "nobody asks for it");
            yield return null;
        }

        // The one that draws wings is the one to convert; without such a one any.
        [UnityTest]
        public IEnumerator AnInsectWithoutWings_IsToldWhichSkinToConvert([Values] bool hasWings)
        {
            InsectWings insect = Hatch(made =>
            {
                made.enabled = false;
                made.Wings.ForEach(wing => Object.DestroyImmediate(wing.Renderer.gameObject));
                made.Wings.Clear();
            });
            InsectProblem none = InsectCheck.Find(insect);
            Assert.That((none.State, none.Wing), Is.EqualTo((InsectState.NoWings, -1)), "no wing is named");
            Skin(insect, "fur");
            if (hasWings)
                Skin(insect, "wings");
            InsectProblem problem = InsectCheck.Find(insect);
            Assert.That((problem.State, problem.Wing), Is.EqualTo((InsectState.SkinnedWings, -1)));
            Assert.That(problem.Message, Does.Contain(hasWings ? "'wings' is a SkinnedMeshRenderer" : "'fur' is a SkinnedMeshRenderer"));
            yield return null;
        }

        [UnityTest]
        public IEnumerator TheSameProblem_OfAnotherWing_IsToldAgain()
        {
            LogAssert.Expect(LogType.Warning, new Regex("'insect', wing 1: it has no renderer"));
            InsectWings insect = Hatch(made => made.Wings[1].Renderer = null);
            yield return Frames(3);
            LogAssert.NoUnexpectedReceived();
            LogAssert.Expect(LogType.Warning, new Regex("'insect', wing 0: it has no renderer"));
            insect.Wings.Reverse();
            yield return Frames(3);
            Assert.That((insect.Problem.State, insect.Problem.Wing), Is.EqualTo((InsectState.NoRenderer, 0)));
            insect.Quality.patches++;
            yield return Frames(3);
            LogAssert.NoUnexpectedReceived();
        }

        [TestCase(-1f, 0f)]
        [TestCase(1f, 1f)]
        [TestCase(359f, 359f)]
        [TestCase(361f, 360f)]
        [TestCase(float.NaN, 0f)]
        public void TheStartPhase_IsAnAngleOfTheBeat(float degrees, float wanted)
        {
            InsectWings insect = Hatch(made => made.enabled = false);
            insect.StartPhase = degrees;
            Assert.That(insect.StartPhase, Is.EqualTo(wanted));
        }

        private void Skin(InsectWings insect, string name)
        {
            SkinnedMeshRenderer skin = new GameObject(name).AddComponent<SkinnedMeshRenderer>();
            skin.transform.SetParent(insect.transform, false);
            skin.sharedMesh = WingMesh;
        }
    }
}
