using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = UnityEngine.TestTools.Constraints.Is;

namespace Alate.Tests.Play.Flight
{
    /// <summary>
    /// The pilots as components: colliders, marks, neighbours, goals that are none. A point with an insect's limits flies.
    /// </summary>
    public sealed class PilotTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator Wanderer_FliesIntoNoWall([Values(1, 2, 3)] int seed)
        {
            BoxCollider[] walls = new[] { Wall(new Vector3(6f, 5f, 0f), new Vector3(1f, 8f, 6f)),
                Wall(new Vector3(-5f, 4f, 4f), new Vector3(5f, 5f, 1f)), Wall(new Vector3(0f, -0.5f, 0f), new Vector3(60f, 1f, 60f)) };
            WanderPilot pilot = Made<WanderPilot>();
            pilot.Seed = seed;
            pilot.Volume = new FlightVolume(VolumeShape.Box, new Vector3(0f, 5f, 0f), new Vector3(30f, 8f, 30f));
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 5f, -8f);
            float nearest = float.MaxValue;
            for (int frame = 0; frame < 1500; frame++)
            {
                flyer.Fly(pilot);
                foreach (BoxCollider wall in walls)
                    nearest = math.min(nearest, Distance(wall, flyer.situation.position));
                yield return null;
            }

            TestContext.Progress.WriteLine($"{nearest / 10f:0.000} m from a wall at least");
            Assert.That(nearest, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator AGoalBehindAWall_IsReachedRoundIt()
        {
            BoxCollider wall = Wall(new Vector3(0f, 5f, 0f), new Vector3(8f, 40f, 1f));
            FollowPilot pilot = Made<FollowPilot>();
            pilot.GoTo(new Vector3(0.5f, 5f, 12f));
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 5f, -12f);
            for (int frame = 0; frame < 2000 && !pilot.HasArrived; frame++)
            {
                flyer.Fly(pilot);
                Assert.That(Distance(wall, flyer.situation.position), Is.GreaterThan(0f));
                yield return null;
            }

            Assert.That(pilot.HasArrived, Is.True, $"{flyer.situation.position}");
            pilot.Target = pilot.transform;
            Assert.That(pilot.HasArrived, Is.False, "it follows an object");
            pilot.Target = null;
            pilot.Points.Clear();
            Assert.That(pilot.HasArrived, Is.False, "nowhere");
        }

        [UnityTest]
        public IEnumerator AGoalWithinAWall_IsToldOnce_AndTheInsectStaysBeforeIt()
        {
            BoxCollider wall = Wall(new Vector3(0f, 5f, 0f), new Vector3(20f, 20f, 4f));
            FollowPilot pilot = Made<FollowPilot>();
            pilot.GoTo(new Vector3(0f, 5f, 0f));
            LogAssert.Expect(LogType.Warning, new Regex("goal of 'FollowPilot' at .* lies within a collider"));
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 5f, -15f);
            for (int frame = 0; frame < 800; frame++)
            {
                flyer.Fly(pilot);
                Assert.That(Distance(wall, flyer.situation.position), Is.GreaterThan(0f));
                yield return null;
            }

            Assert.That(math.length(flyer.situation.velocity), Is.LessThan(0.1f));
            Assert.That(Distance(wall, flyer.situation.position) / 10f, Is.LessThan(0.3f));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator GoalsThatAreNoNumbers_AreToldOnce_AndNothingIsLost()
        {
            FollowPilot pilot = Made<FollowPilot>();
            pilot.Points.Add(new Vector3(float.NaN, 0f, 0f));
            pilot.Points.Add(new Vector3(0f, 5f, 5f));
            LogAssert.Expect(LogType.Warning, new Regex("Point 0 of 'FollowPilot' is .*must be finite"));
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 5f, -5f);
            for (int frame = 0; frame < 400; frame++)
            {
                FlightCommand command = pilot.Command(flyer.situation);
                Assert.That(math.all(math.isfinite(command.velocity)), Is.True);
                flyer.Fly(command);
                yield return null;
            }

            Assert.That(math.distance(flyer.situation.position, new float3(0f, 5f, 5f)), Is.LessThan(1f));

            PerchPilot perch = Made<PerchPilot>();
            LogAssert.Expect(LogType.Warning, new Regex("'PerchPilot' cannot land at .*must be finite"));
            Assert.That(perch.LandOn(new PerchSpot { position = float.NaN, normal = new float3(0f, 1f, 0f) }), Is.False);
            Assert.That(perch.Stage, Is.EqualTo(PerchStage.Between));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Follower_KeepsUpWithItsTarget()
        {
            Transform target = Keep(new GameObject("target")).transform;
            FollowPilot pilot = Made<FollowPilot>();
            pilot.Target = target;
            pilot.Offset = new Vector3(0f, 2f, 0f);
            var flyer = new PointFlyer();
            for (int frame = 0; frame < 600; frame++)
            {
                float time = frame * 0.02f;
                target.position = new Vector3(10f * Mathf.Sin(0.5f * time), 5f, 10f * Mathf.Cos(0.5f * time));
                flyer.Fly(pilot);
                if (frame > 400)
                {
                    Assert.That(math.distance(flyer.situation.position, (float3)target.position + new float3(0f, 2f, 0f)) / 10f,
                        Is.LessThan(0.25f));
                }
                yield return null;
            }
        }

        [UnityTest]
        public IEnumerator OneMark_HasOneGuest_AndIsFreeWhenItLeaves()
        {
            PerchMark mark = Made<PerchMark>();
            mark.transform.position = new Vector3(0f, 5f, 0f);
            var flyers = new List<PointFlyer>();
            var pilots = new List<PerchPilot>();
            for (int k = 0; k < 3; k++)
            {
                PerchPilot pilot = Made<PerchPilot>();
                pilot.Seed = k + 1;
                pilot.Settings.flightTime = 0.5f;
                pilot.Settings.stayTime = 2f;
                pilots.Add(pilot);
                flyers.Add(new PointFlyer());
                flyers[k].situation.position = new float3(3f * k - 3f, 8f, -4f);
            }

            var landed = new HashSet<PerchPilot>();
            for (int frame = 0; frame < 3000; frame++)
            {
                int sitting = 0;
                for (int k = 0; k < pilots.Count; k++)
                {
                    flyers[k].Fly(pilots[k]);
                    if (pilots[k].Stage != PerchStage.Perched)
                        continue;
                    sitting++;
                    landed.Add(pilots[k]);
                    Assert.That(mark.Guest, Is.SameAs(pilots[k]));
                }

                Assert.That(sitting, Is.LessThan(2));
                yield return null;
            }

            // An insect does not come back to the mark that it has just left.
            Assert.That(landed, Has.Count.EqualTo(3));
            Assert.That(mark.IsFree, Is.True);
        }

        [UnityTest]
        public IEnumerator Surfaces_AreLandedOn_UnlessTheyAreSteep([Values(20f, 60f)] float slope)
        {
            BoxCollider ground = Wall(Vector3.zero, new Vector3(60f, 1f, 60f));
            ground.transform.rotation = Quaternion.Euler(0f, 0f, slope);
            PerchPilot pilot = Made<PerchPilot>();
            pilot.Settings.flightTime = 0.2f;
            pilot.Settings.landsOnSurfaces = true;
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 6f, 0f);
            bool sat = false;
            for (int frame = 0; frame < 800 && !sat; frame++)
            {
                flyer.Fly(pilot);
                sat = pilot.Stage == PerchStage.Perched;
                yield return null;
            }

            Assert.That(sat, Is.EqualTo(slope < 45f));
        }

        [UnityTest]
        public IEnumerator AFlock_StaysTogether_AndApart()
        {
            const int k_Count = 60;
            var pilots = new List<FlockPilot>();
            var flyers = new List<PointFlyer>();
            var random = new Unity.Mathematics.Random(5);
            for (int k = 0; k < k_Count; k++)
            {
                FlockPilot pilot = Made<FlockPilot>();
                pilot.Obstacles.avoid = false;
                pilot.Settings.sight = 100f;
                pilot.Settings.cohesion = 0.8f;
                pilots.Add(pilot);
                var flyer = new PointFlyer();
                flyer.situation.position = random.NextFloat3(-8f, 8f);
                flyer.situation.referenceVelocity = flyer.situation.velocity = random.NextFloat3(-0.5f, 0.5f);
                flyers.Add(flyer);
            }

            for (int frame = 0; frame < 500; frame++)
            {
                for (int k = 0; k < k_Count; k++)
                    flyers[k].Fly(pilots[k]);
                yield return null;
            }

            float3 mean = default;
            foreach (PointFlyer flyer in flyers)
                mean += flyer.situation.velocity / k_Count;
            float aligned = 0f, nearest = float.MaxValue, farthest = 0f;
            foreach (PointFlyer flyer in flyers)
            {
                aligned += math.dot(math.normalizesafe(flyer.situation.velocity), math.normalizesafe(mean)) / k_Count;
                foreach (PointFlyer other in flyers)
                {
                    float distance = math.distance(flyer.situation.position, other.situation.position) / 10f;
                    nearest = ReferenceEquals(flyer, other) ? nearest : math.min(nearest, distance);
                    farthest = math.max(farthest, distance);
                }
            }

            TestContext.Progress.WriteLine($"aligned {aligned:0.00}, {nearest:0.00} to {farthest:0.0} m apart");
            Assert.That(aligned, Is.GreaterThan(0.8f));
            Assert.That(nearest, Is.GreaterThan(0.061f), "a wing length");
            Assert.That(farthest, Is.LessThan(6f));
            Assert.That(pilots, Has.All.Property(nameof(FlockPilot.NeighbourCount)).GreaterThan(0));
        }

        [UnityTest]
        public IEnumerator Pilots_AllocateNothing()
        {
            Wall(new Vector3(0f, -0.5f, 0f), new Vector3(60f, 1f, 60f));
            GameObject insect = Keep(new GameObject("insect"));
            PerchPilot perch = insect.AddComponent<PerchPilot>();
            insect.AddComponent<FlockPilot>();
            insect.AddComponent<WanderPilot>().Seed = 3;
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 8f, 0f);
            for (int frame = 0; frame < 50; frame++)
            {
                flyer.Fly(perch);
                yield return null;
            }

            FlightSituation situation = flyer.situation;
            Assert.That(() => { perch.Command(situation); }, Is.Not.AllocatingGCMemory());
        }

        private T Made<T>() where T : Component => Keep(new GameObject(typeof(T).Name)).AddComponent<T>();

        private BoxCollider Wall(Vector3 place, Vector3 size)
        {
            BoxCollider wall = Made<BoxCollider>();
            wall.transform.position = place;
            wall.size = size;
            return wall;
        }

        private static float Distance(BoxCollider wall, float3 place)
        {
            float3 within = math.abs(place - (float3)wall.transform.position) - 0.5f * (float3)wall.size;
            return math.cmax(within) < 0f ? math.cmax(within) : math.length(math.max(within, 0f));
        }
    }
}
