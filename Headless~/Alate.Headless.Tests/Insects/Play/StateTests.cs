using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>States that only a build or an importer brings about.</summary>
    public sealed class StateTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator AWingMergedByStaticBatching_SaysSo_AndLivesWhenItIsSeparate()
        {
            InsectWings healthy = Hatch();
            InsectWings patient = Hatch(insect => insect.Wings[1].Renderer.StaticallyBatched = true, "patient");
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.StaticBatch));
            Assert.That(patient.Problem.Message, Does.Contain("'patient', wing 1").And.Contain("Batching Static"));
            Assert.That(healthy.State, Is.EqualTo(InsectState.Ready));

            patient.Wings[1].Renderer.StaticallyBatched = false;
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AMeshThatIsMadeReadable_LivesByItself()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.SetReadable(false);
            InsectWings patient = Hatch(insect => Filter(insect, 0).sharedMesh = mesh);
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.MeshNotReadable));

            mesh.SetReadable(true);
            yield return Frames(3);
            Assert.That(patient.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AMeshOfNoUsableNumbers_BreaksItsOwnInsectOnly([Values("not a number", "endless", "huge")] string kind)
        {
            InsectWings patient = Hatch(insect => Filter(insect, 0).sharedMesh = Keep(Specimens.NoWing(kind)), "patient");
            InsectWings healthy = Hatch();
            yield return Frames(3);

            Assert.That(patient.State, Is.EqualTo(InsectState.SkeletonDoesNotFit));
            Assert.That(patient.Problem.Message, Does.Contain("'patient', wing 0").And.Contain(kind));
            Assert.That(healthy.State, Is.EqualTo(InsectState.Ready));
        }

        [UnityTest]
        public IEnumerator AMessage_LeadsToItsInsect()
        {
            var contexts = new List<Object>();
            void Hear(string text, string trace, LogType type, Object context)
            {
                if (type == LogType.Warning)
                    contexts.Add(context);
            }

            LogChannel.Received += Hear;
            InsectWings patient = Hatch(insect => insect.Wings[0].Renderer = null);
            yield return Frames(3);
            LogChannel.Received -= Hear;

            Assert.That(contexts, Is.EqualTo(new Object[] { patient }));
        }
    }
}
