using NUnit.Framework;
using StandIns;

namespace Alate.Tests.Play
{
    /// <summary>Checks that no native memory is left after all play-mode tests.</summary>
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
