using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the delays by which the chains of an insect are coloured.</summary>
    public sealed class ChainSketchLaws : InsectFixture
    {
        [Test]
        public void ADelay_GrowsWithTheDistanceOfTheRoots_AndEvenlyAlongTheChain()
        {
            InsectWings insect = Insect();
            insect.Preset = Preset(0.6f, 0.2f);
            WingSkeleton skeleton = insect.Wings[0].Skeleton;
            var sketch = ChainSketch.Of(insect, 0);
            float width = Vector3.Distance(skeleton.GetJoint(4, 0), skeleton.GetJoint(0, 0));

            for (int i = 0; i < 5; i++)
            {
                float root = Vector3.Distance(skeleton.GetJoint(i, 0), skeleton.GetJoint(0, 0)) / width;
                for (int j = 0; j < 5; j++)
                    Assert.That(sketch.Delay(i, j), Is.EqualTo(0.75f * root + 0.25f * j / 4f).Within(1e-5f), $"{i}, {j}");
            }
        }

        [Test]
        public void OfChainsWithOneRoot_TheChainsCountEvenly()
        {
            InsectWings insect = Insect();
            insect.Preset = Preset(0.6f, 0.2f);
            WingSkeleton skeleton = insect.Wings[0].Skeleton;
            for (int i = 1; i < 5; i++)
                skeleton.Chains[i].joints[0] = skeleton.GetJoint(0, 0);
            var sketch = ChainSketch.Of(insect, 0);

            for (int i = 0; i < 5; i++)
            {
                for (int j = 0; j < 5; j++)
                    Assert.That(sketch.Delay(i, j), Is.EqualTo(0.75f * i / 4f + 0.25f * j / 4f).Within(1e-5f), $"{i}, {j}");
            }
        }

        [Test]
        public void AWingsOwnPreset_CountsBeforeThatOfTheInsect()
        {
            InsectWings insect = Insect();
            insect.Preset = Preset(0.6f, 0.2f);
            insect.Wings[1].Preset = Preset(0.1f, 0.3f);

            Assert.That(ChainSketch.Of(insect, 0).Delay(0, 4), Is.EqualTo(0.25f).Within(1e-5f));
            Assert.That(ChainSketch.Of(insect, 1).Delay(0, 4), Is.EqualTo(0.75f).Within(1e-5f));
            Assert.That(ChainSketch.Of(insect, 1).Delay(4, 0), Is.EqualTo(0.25f).Within(1e-5f));
        }

        private WingPreset Preset(float chord, float span)
        {
            WingPreset preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            preset.Wave.chordDelay = chord;
            preset.Wave.spanDelay = span;
            return preset;
        }
    }
}
