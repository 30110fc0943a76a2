using Alate.Flight;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Flight
{
    /// <summary>Settings of a pilot that follows.</summary>
    public sealed class FollowPilotTests
    {
        private GameObject m_Object;
        private FollowPilot m_Pilot;

        [SetUp]
        public void Make()
        {
            m_Object = new GameObject("follower");
            m_Pilot = m_Object.AddComponent<FollowPilot>();
        }

        [TearDown]
        public void Clear() => Object.DestroyImmediate(m_Object);

        [TestCase(0.4f, 0.4f)]
        [TestCase(-1f, 0.05f)]
        [TestCase(50f, 5f)]
        [TestCase(float.NaN, 1f)]
        public void ASpeed_IsKeptInItsRange(float asked, float kept)
        {
            m_Pilot.Speed = asked;
            Assert.That(m_Pilot.Speed, Is.EqualTo(kept));
        }

        [Test]
        public void WhatIsSet_IsThere()
        {
            m_Pilot.Offset = Vector3.up;
            m_Pilot.Origin = m_Object.transform;
            m_Pilot.Loop = !m_Pilot.Loop;
            bool loop = m_Pilot.Loop;
            m_Pilot.Target = m_Object.transform;

            Assert.That((m_Pilot.Offset, m_Pilot.Origin, m_Pilot.Target), Is.EqualTo((Vector3.up, m_Object.transform, m_Object.transform)));
            m_Pilot.Loop = !loop;
            Assert.That(m_Pilot.Loop, Is.EqualTo(!loop));
        }

        [Test]
        public void APointToGoTo_IsTheOnlyOne_RelativeToTheOrigin()
        {
            m_Object.transform.SetPositionAndRotation(new Vector3(3f, 2f, 1f), Quaternion.Euler(0f, 90f, 0f));
            m_Pilot.Points.AddRange(new[] { Vector3.one, Vector3.zero });
            m_Pilot.Target = m_Object.transform;
            m_Pilot.GoTo(new Vector3(4f, 5f, 6f));
            Assert.That(m_Pilot.Points, Is.EqualTo(new[] { new Vector3(4f, 5f, 6f) }));
            Assert.That(m_Pilot.Target == null, Is.True);

            m_Pilot.Origin = m_Object.transform;
            m_Pilot.GoTo(new Vector3(4f, 5f, 6f));
            Assert.That((m_Object.transform.TransformPoint(m_Pilot.Points[0]) - new Vector3(4f, 5f, 6f)).magnitude, Is.LessThan(1e-5f));
        }
    }
}
