using System.Collections;
using Alate.Flight;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Flight
{
    /// <summary>Wish of an insect of a flock, by its neighbours: keep apart, fly as they fly, to their middle.</summary>
    public sealed class FlockLaws : PlayFixture
    {
        private const float k_Length = 0.06f;

        private static readonly float3 s_Own = new float3(0f, 0f, 0.8f), s_Other = new float3(0.1f, 0.02f, 1f);

        // Alignment is towards the neighbour's velocity in metres of the insect, whatever the scale of the scene.
        [UnityTest]
        public IEnumerator ANeighboursVelocity_CountsInMetres([Values(0.5f, 1f, 10f)] float units)
        {
            FlockSettings settings = Settings();
            settings.alignment = 0.5f;
            FlightCommand command = default;
            yield return Fly(settings, units, new float3(0.05f, 0f, 0f), made => command = made);
            Assert.That(math.distance(command.velocity, s_Own + 0.5f * (s_Other - s_Own)), Is.LessThan(1e-4f));
        }

        [UnityTest]
        public IEnumerator ANeighbour_IsFlownTo_ByItsDistanceOverTheSight([Values(1f, 10f)] float units)
        {
            FlockSettings settings = Settings();
            settings.cohesion = 0.5f;
            FlightCommand command = default;
            yield return Fly(settings, units, new float3(0.3f, 0f, 0.3f), made => command = made);
            float sight = 20f * k_Length;
            Assert.That(math.distance(command.velocity, s_Own + 0.5f * 0.8f * new float3(0.3f, 0f, 0.3f) / sight), Is.LessThan(1e-4f));
        }

        [UnityTest]
        public IEnumerator OneThatIsTooNear_IsFlownAwayFrom([Values(1f, 10f)] float units, [Values(0, 1)] int group)
        {
            FlockSettings settings = Settings();
            settings.separation = 0.5f;
            FlightCommand command = default;
            yield return Fly(settings, units, new float3(0.1f, 0f, 0f), made => command = made, group);
            float near = 1f - 0.1f / (5f * k_Length);
            Assert.That(math.distance(command.velocity, s_Own + 0.5f * 0.8f * near * new float3(-1f, 0f, 0f)), Is.LessThan(1e-4f),
                "of whatever group");
        }

        [UnityTest]
        public IEnumerator OneOfAnotherGroup_OrOutOfSight_IsNoNeighbour([Values(false, true)] bool far)
        {
            FlockSettings settings = Settings();
            settings.alignment = settings.cohesion = 1f;
            FlightCommand command = default;
            yield return Fly(settings, 1f, new float3(far ? 20.1f * k_Length : 0.5f, 0f, 0f), made => command = made, far ? 0 : 1);
            Assert.That(math.distance(command.velocity, s_Own), Is.LessThan(1e-5f));
        }

        [UnityTest]
        public IEnumerator InAHurry_NobodyIsMoreThanAThirdFaster()
        {
            FlockSettings settings = Settings();
            settings.alignment = 1f;
            FlightCommand command = default;
            yield return Fly(settings, 1f, new float3(0.5f, 0f, 0f), made => command = made, 0, 9f);
            Assert.That(math.length(command.velocity), Is.EqualTo(1.3f * 0.8f).Within(1e-4f));
        }

        [Test]
        public void OneThatWasNotAskedYet_IsSeenByNobody()
        {
            FlockPilot fresh = Keep(new GameObject("fresh")).AddComponent<FlockPilot>();
            var members = new NativeArray<FlockMember>(2, Allocator.TempJob);
            var views = new NativeArray<FlockView>(2, Allocator.TempJob);
            members[0] = new FlockMember
            {
                position = new float3(3f, 1f, 1f),
                sight = 100f,
                room = 100f,
                group = fresh.Member.group,
            };
            members[1] = fresh.Member;
            FlockGrid.Look(members, views);
            FlockView view = views[0];
            members.Dispose();
            views.Dispose();

            Assert.That(view.count, Is.Zero);
            Assert.That(math.length(view.apart), Is.Zero);
        }

        private static FlockSettings Settings() => new FlockSettings { speed = 0.8f, sight = 20f, room = 5f };

        // Two pilots, each asked twice: the first time the neighbour is not there yet.
        private IEnumerator Fly(FlockSettings settings, float units, float3 way, System.Action<FlightCommand> take, int group = 0,
            float fast = 1f)
        {
            FlockPilot one = Keep(new GameObject("one")).AddComponent<FlockPilot>(),
                other = Keep(new GameObject("other")).AddComponent<FlockPilot>();
            one.Settings = other.Settings = settings;
            other.Settings.group = group;
            one.Obstacles.avoid = other.Obstacles.avoid = false;
            FlightSituation self = Situation(units, s_Own), beside = Situation(units, fast * s_Other);
            beside.position += units * way;
            for (int frame = 0; frame < 3; frame++)
            {
                other.Command(beside);
                take(one.Command(self));
                yield return null;
                yield return new WaitForFixedUpdate();
            }

            take(one.Command(self));
        }

        private static FlightSituation Situation(float units, float3 velocity) => new FlightSituation
        {
            position = new float3(3f, 4f, 5f),
            rotation = quaternion.identity,
            velocity = velocity,
            referenceVelocity = velocity,
            limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f),
            deltaTime = 0.02f,
            wingLength = k_Length,
            unitsPerMetre = units,
        };
    }
}
