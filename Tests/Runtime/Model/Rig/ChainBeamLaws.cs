using System;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Hinges of a chain of measured stiffness, against the beam that they stand for.</summary>
    public sealed class ChainBeamLaws
    {
        private static readonly double[] s_Places = { 0.0, 0.2, 0.5, 1.0 }, s_Distances = { 0.0, 0.1, 0.3, 0.7 };

        [Test]
        public void ABeamOfOneStiffness_TwistsAtEachHinge_AsTheHalfBonesBesideIt()
        {
            double[] twists = new ChainBeam(s_Places, s_Distances).Twists(new[] { 3e-9f, 3e-9f });

            // GJ over length: half of the bone beyond, and half of that before.
            Assert.That(twists, Is.EqualTo(new[] { 3e-9 / 0.05, 3e-9 / (0.05 + 0.1), 3e-9 / (0.1 + 0.2) }).Within(0.01).Percent);
        }

        [Test]
        public void ATaperedBeam_TwistsAsItsSections()
        {
            float[] stiffness = { 4e-9f, 1e-9f };
            double[] twists = new ChainBeam(s_Places, s_Distances).Twists(stiffness);
            for (int hinge = 0; hinge < 3; hinge++)
            {
                double turn = 0.0;
                foreach (int beside in hinge == 0 ? new[] { 1 } : new[] { hinge - 1, hinge + 1 })
                {
                    // From the joint to the middle of the bone, in small pieces.
                    double half = 0.5 * Math.Abs(s_Distances[beside] - s_Distances[hinge]);
                    for (int k = 0; k < 4000; k++)
                    {
                        double place = s_Places[hinge] + 0.5 * (s_Places[beside] - s_Places[hinge]) * (k + 0.5) / 4000;
                        turn += half / 4000 / ChainValues.At(stiffness, place);
                    }
                }

                Assert.That(twists[hinge], Is.EqualTo(1.0 / turn).Within(0.1).Percent, $"hinge {hinge}");
            }
        }
    }
}
