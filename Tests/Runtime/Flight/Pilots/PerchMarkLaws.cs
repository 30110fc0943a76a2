using System.Collections;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Marks that move, are taken or are gone, and who goes for them.</summary>
    public sealed class PerchMarkLaws : PlayFixture
    {
        private const float k_Length = 0.05f;

        // Where the mark goes the landing goes, and the insect that sits; a mark that is destroyed lets it fly off.
        [UnityTest]
        public IEnumerator AMark_TakesTheInsectAlong_UntilItIsGone()
        {
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            pilot.Settings.stayTime = 100f;
            PerchMark mark = Keep(new GameObject("flower")).AddComponent<PerchMark>();
            FlightSituation situation = Situation();
            Assert.That(pilot.LandOn(mark));
            Assert.That(mark.Guest, Is.SameAs(pilot));
            ComeDown(pilot, ref situation, Height);
            mark.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 40f, 20f));
            FlightCommand command = pilot.Command(situation);
            Assert.That(command.wish, Is.EqualTo(FlightWish.Perch));
            Assert.That((Vector3)command.spot.position, Is.EqualTo(mark.transform.position));
            Assert.That((Vector3)command.spot.normal, Is.EqualTo(mark.transform.up));
            situation.position = mark.transform.position;
            Object.DestroyImmediate(mark.gameObject);
            pilot.Command(situation);
            Assert.That(pilot.Stage, Is.EqualTo(PerchStage.TakingOff));
            yield return null;
        }

        [UnityTest]
        public IEnumerator AMarkThatIsTaken_OrNone_IsRefused()
        {
            PerchPilot first = Keep(new GameObject("first")).AddComponent<PerchPilot>(),
                second = Keep(new GameObject("second")).AddComponent<PerchPilot>();
            PerchMark mark = Keep(new GameObject("flower")).AddComponent<PerchMark>();
            Assert.That(first.LandOn(mark) && first.LandOn(mark), "again is no other");
            LogAssert.Expect(LogType.Warning, "'second' cannot land on 'flower': 'first' sits there, or goes there. It flies on.");
            Assert.That(second.LandOn(mark), Is.False);
            Assert.That((second.Stage, mark.Guest), Is.EqualTo((PerchStage.Between, (FlightPilot)first)));
            Assert.That(() => second.LandOn(null), Throws.ArgumentNullException);
            yield return null;
        }

        // Of the flower that it sat on before it knows no more.
        [UnityTest]
        public IEnumerator OffASurface_ItDoesNotFollowTheFlowerBefore()
        {
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            PerchMark mark = Keep(new GameObject("flower")).AddComponent<PerchMark>();
            FlightSituation situation = Situation();
            pilot.LandOn(mark);
            pilot.LandOn(new PerchSpot { normal = Vector3.up, heading = 0f });
            mark.transform.position = new Vector3(5f, 0f, 0f);
            ComeDown(pilot, ref situation, Height);
            pilot.TakeOff();
            for (int step = 0; step < 3; step++)
            {
                FlightCommand command = pilot.Command(situation);
                Assert.That(pilot.Stage, Is.EqualTo(PerchStage.TakingOff));
                Assert.That(command.spot.position, Is.EqualTo(default(float3)));
            }

            yield return null;
        }

        // Over the middle, and as much higher as the sway reaches up: a flower that rises does not meet a downstroke.
        [UnityTest]
        public IEnumerator ASway_IsComeToOverItsTop([Values(0f, 0.04f)] float sway)
        {
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            PerchMark mark = Keep(new GameObject("flower")).AddComponent<PerchMark>();
            FlightSituation situation = Situation();
            Assert.That(pilot.LandOn(mark));
            situation.position = new float3(0f, 3f, -3f);
            for (int step = 0; step < 200; step++)
            {
                mark.transform.position = sway * Mathf.Sin(2f * Mathf.PI * 0.02f * step) * Vector3.up;
                pilot.Command(situation);
            }

            mark.transform.position = Vector3.zero;
            ComeDown(pilot, ref situation, Height + 0.04f);
            Assert.That(pilot.Stage == PerchStage.Perched, Is.EqualTo(sway > 0f), "held so high over what stays it would not be");
            yield return null;
        }

        private static float Height => 6.1e-3f + 1.2f * k_Length;

        // By the line to over the spot, and there.
        private static void ComeDown(PerchPilot pilot, ref FlightSituation situation, float height)
        {
            pilot.Settings.stayTime = 100f;
            situation.position = new float3(0f, height, 0f) + 0.4f * math.normalize(new float3(0f, 0.45f, -1f));
            for (int step = 0; step < 5 && pilot.Stage != PerchStage.Perched; step++)
            {
                pilot.Command(situation);
                situation.position = new float3(0f, height, 0f);
            }

            situation.state = FlightState.Perched;
        }

        private static FlightSituation Situation() => new FlightSituation
        {
            position = new float3(0f, 1f, -1f),
            rotation = quaternion.identity,
            limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f),
            deltaTime = 0.02f,
            wingLength = k_Length,
            unitsPerMetre = 1f,
        };
    }
}
