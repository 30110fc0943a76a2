using System.Collections;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>A flight controller's levers, pulled while the wings beat.</summary>
    public sealed class SteeringTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator Frequency_AndAmplitude_FollowTheirFactors_WithoutRebuilding()
        {
            WingPreset preset = Keep(InsectCatalogue.Monarch());
            InsectWings insect = Hatch(made => made.Preset = preset), other = Hatch(made => made.Preset = preset);
            yield return Frames(30);
            Mesh living = Shown(insect, 0);
            float frequency = insect.Frequency, range = insect.FlapRange, most = preset.Beat.maxFrequency;

            insect.Steering.frequencyScale = 1.5f;
            insect.Steering.amplitudeScale = 0.5f;
            yield return Frames(60);

            Assert.That(insect.Frequency, Is.EqualTo(1.5f * frequency).Within(0.01f * frequency));
            Assert.That(insect.FlapRange, Is.EqualTo(0.5f * range).Within(0.01f * range));
            Assert.That(Shown(insect, 0), Is.SameAs(living));
            Assert.That(other.Frequency, Is.EqualTo(frequency).Within(1e-3f), "the preset's other insects are steered too");
            Assert.That(preset.Beat.maxFrequency, Is.EqualTo(most));
        }

        [UnityTest]
        public IEnumerator AmplitudeOfZero_Glides_AndTheBeatComesBack()
        {
            InsectWings insect = Hatch(made => made.Steering.amplitudeScale = 0f);
            yield return Frames(60);
            float least = float.MaxValue, most = float.MinValue;
            yield return Heights(insect, 30, (low, high) => (least, most) = (low, high));
            Assert.That(most - least, Is.LessThan(0.02f), "the wings beat");

            insect.Steering = InsectSteering.Default;
            yield return Frames(60);
            yield return Heights(insect, 30, (low, high) => (least, most) = (low, high));
            Assert.That(most - least, Is.GreaterThan(0.3f), "the wings do not beat again");
        }

        [UnityTest]
        public IEnumerator MeanFlap_RaisesTheStroke([Values(-20f, 20f)] float degrees)
        {
            InsectWings insect = Hatch(), raised = Hatch(made => made.Steering.meanFlap = degrees);
            yield return Frames(60);
            float level = 0f, moved = 0f;
            yield return Heights(insect, 60, (low, high) => level = 0.5f * (low + high));
            yield return Heights(raised, 60, (low, high) => moved = 0.5f * (low + high));

            Assert.That(moved - level, Is.EqualTo(Mathf.Sin(Mathf.Deg2Rad * degrees)).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator ValuesOutOfRange_AreClamped_AndNonsenseIsThePresets()
        {
            InsectWings insect = Hatch();
            yield return Frames(30);
            float frequency = insect.Frequency;

            insect.Steering.frequencyScale = 1e9f;
            insect.Steering.amplitudeScale = float.NaN;
            insect.Steering.tilt = float.NaN;
            yield return Frames(60);

            Assert.That(insect.Frequency, Is.EqualTo(4f * frequency).Within(0.04f * frequency));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(WingSystem.ResetCount, Is.Zero);
        }

        [UnityTest]
        public IEnumerator TurningThatAScriptTells_IsFelt()
        {
            InsectWings still = Hatch(Scripted), turning = Hatch(Scripted);
            turning.AngularVelocity = new Vector3(0f, 20f, 0f);
            yield return Frames(60);

            Vector3 difference = turning.AirForceOf(0) - still.AirForceOf(0);
            Assert.That(difference.magnitude, Is.GreaterThan(0.05f * still.AirForceOf(0).magnitude));
        }

        // A body turns its hinges through the air only where they are off its middle.
        private static void Scripted(InsectWings made)
        {
            made.Motion.source = VelocitySource.Script;
            foreach (Wing wing in made.Wings)
                wing.Renderer.transform.localPosition = new Vector3(wing.Side == WingSide.Right ? 1f : -1f, 0f, 0f);
        }

        private static IEnumerator Heights(InsectWings insect, int frames, System.Action<float, float> tell)
        {
            float least = float.MaxValue, most = float.MinValue;
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                float height = insect.JointPosition(0, 0, 4).y;
                least = Mathf.Min(least, height);
                most = Mathf.Max(most, height);
            }

            tell(least, most);
        }
    }
}
