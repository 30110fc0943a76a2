using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class ElasticStepTests
    {
        [Test]
        public void Retention_OfTheRate_IsThatOfADampedAnchor()
        {
            float anchorRate = 2f * 2f * math.PI * 11f;
            double expected = Math.Exp(-2.0 * 0.3 * 44.0 * Math.PI / 240.0);
            Assert.That(ElasticStep.Retention(0.3f, anchorRate, 1f / 240f).x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }
    }
}
