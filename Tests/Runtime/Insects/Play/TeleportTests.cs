using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>A jump to another place is no motion, and fast motion is no jump.</summary>
    public sealed class TeleportTests : FlockFixture
    {
        private const float k_FrameTime = 1f / 60f;
        private static readonly Vector3 s_Velocity = new Vector3(0f, 0f, 12f);

        [UnityTest]
        public IEnumerator AJump_IsKept_WithoutAGust([Values(false, true)] bool announced)
        {
            InsectWings jumping = Hatch(), twin = Hatch();
            yield return Fly(60, jumping, twin);

            jumping.transform.position += new Vector3(500f, 0f, 0f);
            if (announced)
                jumping.Teleport();
            float worst = 0f, change = 0f;
            for (int frame = 0; frame < 30; frame++)
            {
                yield return Fly(1, jumping, twin);
                worst = math.max(worst, Farthest(Joints(jumping, 0), Joints(twin, 0)));
                change = math.max(change, math.distance(jumping.Live.flight.velocity, s_Velocity));
            }

            Assert.That(worst, Is.LessThan(0.01f));
            Assert.That(change, Is.LessThan(0.02f * s_Velocity.z), "the jump changed the velocity that is felt");
        }

        [UnityTest]
        public IEnumerator AnAnnouncedJumpBeforeTheMove_IsNotFeltEither()
        {
            InsectWings jumping = Hatch(), twin = Hatch();
            yield return Fly(60, jumping, twin);

            jumping.Teleport();
            jumping.transform.position += new Vector3(5f, 0f, 0f);
            float change = 0f;
            for (int frame = 0; frame < 30; frame++)
            {
                yield return Fly(1, jumping, twin);
                change = math.max(change, math.distance(jumping.Live.flight.velocity, s_Velocity));
            }

            Assert.That(change, Is.LessThan(0.02f * s_Velocity.z));
        }

        [UnityTest]
        public IEnumerator AShortJump_IsNotFelt_WhenItIsAnnounced()
        {
            InsectWings insect = Hatch();
            yield return Frames(30);

            insect.transform.position += new Vector3(3f, 0f, 0f);
            insect.Teleport();
            yield return Frames(2);

            Assert.That(math.length(insect.Live.flight.velocity), Is.Zero);
        }

        [UnityTest]
        public IEnumerator AJump_StartsTheWingsAnew_WhereItShould([Values(false, true)] bool announced)
        {
            InsectWings insect = Hatch(made => made.Motion.onTeleport = announced ? TeleportResponse.Keep : TeleportResponse.Reset);
            yield return Frames(60);
            Assert.That(Beats(insect), Is.GreaterThan(5f));

            insect.transform.position += new Vector3(500f, 0f, 0f);
            if (announced)
                insect.Teleport(keepMotion: false);
            yield return Frames(2);

            Assert.That(Beats(insect), Is.LessThan(0.6f));
        }

        [UnityTest]
        public IEnumerator ATurnAround_IsAJump_ATurnOfADegreeIsNot()
        {
            InsectWings insect = Hatch(made => made.Motion.onTeleport = TeleportResponse.Reset);
            yield return Frames(30);
            for (int frame = 0; frame < 30; frame++)
            {
                insect.transform.Rotate(0f, 1f, 0f);
                yield return null;
            }

            Assert.That(Beats(insect), Is.GreaterThan(5f));
            insect.transform.Rotate(0f, 170f, 0f);
            yield return Frames(2);
            Assert.That(Beats(insect), Is.LessThan(0.6f));
        }

        [UnityTest]
        public IEnumerator AnIgnoredJump_BlowsLikeAGust()
        {
            InsectWings insect = Hatch(made => made.Motion.onTeleport = TeleportResponse.Ignore);
            yield return Frames(30);

            insect.transform.position += new Vector3(30f, 0f, 0f);
            yield return Frames(2);

            Assert.That(math.length(insect.Live.flight.velocity), Is.GreaterThan(100f));
            yield return Frames(60);
            Assert.That(WingSystem.ResetCount, Is.Zero);
            Assert.That(Beats(insect), Is.GreaterThan(5f));
        }

        [UnityTest]
        public IEnumerator AFastSteadyFlight_IsNoJump()
        {
            // Forty wing lengths a frame, from one frame to the next.
            InsectWings insect = Hatch(made => made.Motion.onTeleport = TeleportResponse.Reset);
            yield return Frames(10);
            for (int frame = 0; frame < 60; frame++)
            {
                insect.transform.position += new Vector3(0f, 0f, 40f);
                yield return null;
            }

            Assert.That(insect.Live.flight.velocity.z, Is.EqualTo(2400f).Within(24f));
            Assert.That(Beats(insect), Is.GreaterThan(5f), "the wings started over again and again");
        }

        [UnityTest]
        public IEnumerator AFastSteadySpin_IsNoJump()
        {
            InsectWings insect = Hatch(made => made.Motion.onTeleport = TeleportResponse.Reset);
            yield return Frames(10);
            for (int frame = 1; frame <= 60; frame++)
            {
                insect.transform.rotation = Quaternion.Euler(0f, 120f * frame, 0f);
                yield return null;
            }

            Assert.That(insect.Live.flight.angularVelocity.y, Is.EqualTo(math.radians(7200f)).Within(1f));
            Assert.That(Beats(insect), Is.GreaterThan(5f), "the wings started over again and again");
        }

        [UnityTest]
        public IEnumerator JumpsToAndFro_StayJumps()
        {
            InsectWings insect = Hatch();
            yield return Frames(30);
            for (int frame = 0; frame < 30; frame++)
            {
                insect.transform.position = new Vector3(frame % 2 == 0 ? 500f : 0f, 0f, 0f);
                yield return null;
                Assert.That(math.length(insect.Live.flight.velocity), Is.Zero);
            }
        }

        [UnityTest]
        public IEnumerator GoingToAnotherParent_IsNotFelt([Values(false, true)] bool inPlace)
        {
            InsectWings insect = Hatch();
            Transform home = Keep(new GameObject("home")).transform;
            home.position = new Vector3(300f, 50f, 0f);
            home.localScale = 2f * Vector3.one;
            yield return Frames(30);

            insect.transform.SetParent(home, inPlace);
            float worst = 0f;
            for (int frame = 0; frame < 10; frame++)
            {
                yield return null;
                worst = math.max(worst, math.length(insect.Live.flight.velocity));
            }

            Assert.That(worst, Is.LessThan(1e-3f));
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }

        private static IEnumerator Fly(int frames, params InsectWings[] insects)
        {
            for (int frame = 0; frame < frames; frame++)
            {
                foreach (InsectWings insect in insects)
                    insect.transform.position += k_FrameTime * s_Velocity;
                yield return null;
            }
        }
    }
}
