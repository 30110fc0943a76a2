using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class ElasticStepTests
    {
        [Test]
        public void Retention_OfTheRate_IsTheCheckedOne()
        {
            float anchorRate = 2f * 2f * math.PI * 11f;
            Assert.That(ElasticStep.Retention(0.3f, anchorRate, 1f / 240f).x, Is.EqualTo(0.707813).Within(0.707813 * Lanes.CheckTolerance));
        }
    }
}
