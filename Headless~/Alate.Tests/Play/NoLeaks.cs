using NUnit.Framework;
using StandIns;

namespace Alate.Tests.Play
{
    /// <summary>When all play-mode tests are over, no native memory is left.</summary>
    [SetUpFixture]
    public sealed class NoLeaks
    {
        private int m_Before;

        [OneTimeSetUp]
        public void Count() => m_Before = NativeMemoryLedger.LiveCount;

        [OneTimeTearDown]
        public void Compare() => Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(m_Before), NativeMemoryLedger.Describe());
    }
}
