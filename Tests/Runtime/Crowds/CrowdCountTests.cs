using System;
using Alate.Crowds;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Crowds
{
    /// <summary>The number of insects of a crowd.</summary>
    public sealed class CrowdCountTests
    {
        private InsectCrowd m_Crowd;

        [SetUp]
        public void Make() => m_Crowd = new GameObject("crowd").AddComponent<InsectCrowd>();

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(m_Crowd.gameObject);

        [Test]
        public void ACountWithinTheRange_IsTaken([Values(0, 1, InsectCrowd.MaxCount)] int count)
        {
            m_Crowd.Count = count;
            Assert.That(m_Crowd.Count, Is.EqualTo(count));
        }

        [Test]
        public void ACountBeyondTheRange_IsRefused_AndNothingChanges(
            [Values(-1, int.MinValue, InsectCrowd.MaxCount + 1, int.MaxValue)] int count)
        {
            m_Crowd.Count = 7;
            Assert.That(() => m_Crowd.Count = count,
                Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains($"A crowd has 0 to {InsectCrowd.MaxCount} insects."));
            Assert.That(m_Crowd.Count, Is.EqualTo(7));
        }
    }
}
