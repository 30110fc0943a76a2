using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Stiffness of joints by the widths of the veins under them.</summary>
    public sealed class VeinStiffnessTests
    {
        private const int k_Bones = 4;

        [Test]
        public void AVeinTwiceAsWide_IsEightTimesAsStiff_AndTheMeanStays()
        {
            float2[] plain = Stiffness(_ => { }), veined = Stiffness(skeleton =>
            {
                for (int i = 0; i < 3; i++)
                    skeleton.Chains[i].veinWidths = new[] { i == 0 ? 0.2f : 0.1f };
            });

            for (int bone = 0; bone < k_Bones; bone++)
            {
                Assert.That(veined[bone] / plain[bone] / (veined[k_Bones + bone] / plain[k_Bones + bone]),
                    Is.EqualTo(new float2(8f, 8f)).Using<float2>((a, b) => math.cmax(math.abs(a - b)) < 1e-3f ? 0 : 1));
            }
            Assert.That(veined.Sum(joint => joint.x), Is.EqualTo(plain.Sum(joint => joint.x)).Within(1e-3).Percent);
        }

        [Test]
        public void ChainsWithoutAVein_AreMembrane_AndTaperedVeinsSoftenToTheTip()
        {
            float2[] plain = Stiffness(_ => { }), veined = Stiffness(skeleton => skeleton.Chains[1].veinWidths = new[] { 1f, 0.5f });
            float[] factors = plain.Select((joint, bone) => veined[bone].x / joint.x).ToArray();

            Assert.That(factors[0] / factors[2 * k_Bones], Is.EqualTo(1f).Within(1e-4f), "membrane in front and behind");
            Assert.That(factors[k_Bones], Is.GreaterThan(10f * factors[0]));
            Assert.That(factors[k_Bones + 3] / factors[k_Bones], Is.EqualTo(Math.Pow(0.625, 3)).Within(0.1).Percent,
                "the last joint stands at three quarters of the way");
        }

        [Test]
        public void VeinsLeaveMeasuredChainsAlone()
        {
            void Measure(WingSkeleton skeleton) => skeleton.Chains[0].flexuralStiffness = new[] { 1e-5f };
            float2[] measured = Stiffness(Measure), veined = Stiffness(skeleton =>
            {
                Measure(skeleton);
                skeleton.Chains[0].veinWidths = new[] { 5f };
                skeleton.Chains[2].veinWidths = new[] { 1f };
            });

            Assert.That(veined.Take(k_Bones), Is.EqualTo(measured.Take(k_Bones)));
            Assert.That(
                veined.Skip(k_Bones).Sum(joint => joint.x), Is.EqualTo(measured.Skip(k_Bones).Sum(joint => joint.x)).Within(1e-3).Percent);
        }

        private static float2[] Stiffness(Action<WingSkeleton> change)
        {
            WingSkeleton skeleton = TestWings.Lattice(3, k_Bones + 1);
            change(skeleton);
            WingRig rig = TestWings.Bake(skeleton, TestWings.Rectangle(), 24);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, WingParameters.Default, default);
                rig.Release();
                WingReading reading = world.Read(wing);
                return Enumerable.Range(0, 3 * k_Bones).Select(bone => reading.JointStiffness(bone / k_Bones, bone % k_Bones)).ToArray();
            }
        }
    }
}
