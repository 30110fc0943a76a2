using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Laws of a velocity that rays have changed.</summary>
    public sealed class ObstacleSenseLaws
    {
        private const float k_Length = 0.05f, k_Clearance = 1.5f * k_Length, k_Near = 0.001f;

        private static readonly FlightLimits s_Limits = new FlightLimits(1.3f, -0.3f, 0.25f, 2.5f);
        private static readonly float3 s_Ahead = new float3(0f, 0f, 1f), s_Place = new float3(4f, 5f, 6f);

        [Test]
        public void RaysLookAheadAndToAllSides_AsFarAsItTakesToStopAndToTurn([Values(1f, 10f)] float units)
        {
            var sense = new ObstacleSense();
            var wanted = new float3(0.6f, 0f, 0.8f);
            Assert.That(sense.Avoid(wanted, At(s_Place, units), ObstacleSettings.Default), Is.EqualTo(wanted), "nothing is met yet");

            Assert.That(math.distance(sense.Direction(0), wanted), Is.LessThan(1e-5f));
            float3 off = default;
            for (int ray = 1; ray < ObstacleSense.RayCount; ray++)
            {
                Assert.That(math.length(sense.Direction(ray)), Is.EqualTo(1f).Within(1e-5f));
                Assert.That(math.dot(sense.Direction(ray), wanted), Is.EqualTo(1f / math.sqrt(1f + 0.49f)).Within(1e-5f), "35° off");
                off += sense.Direction(ray) - wanted * math.dot(sense.Direction(ray), wanted);
            }

            Assert.That(math.length(off), Is.LessThan(1e-5f), "evenly around");
            Assert.That(math.abs(math.dot(sense.Direction(1) - sense.Direction(2), sense.Direction(3) - sense.Direction(4))),
                Is.LessThan(1e-5f));
            Assert.That((sense.From, sense.Layers), Is.EqualTo((s_Place, ObstacleSettings.Default.layers.value)));
            Assert.That(sense.Reach,
                Is.EqualTo(units * (s_Limits.StoppingDistance(1f) + s_Limits.TurnRadius(1f) + 2f * k_Clearance)).Within(1e-4f * units));
        }

        [Test]
        public void BeforeAWall_TheSpeedIsThatWhichStopsInTime([Values(1f, 10f)] float units, [Values(0.1f, 0.2f, 0.4f)] float distance,
            [Values(0f, 0.02f)] float moved)
        {
            ObstacleSense sense = Looking(s_Ahead, units);
            sense.SetHit(0, -s_Ahead, distance * units);
            float3 allowed = sense.Avoid(new float3(0.3f, 0f, 1f), At(s_Place + moved * units * s_Ahead, units), ObstacleSettings.Default,
                k_Near);

            Assert.That(allowed.x, Is.EqualTo(0.3f).Within(1e-5f), "along the wall nothing is lost");
            Assert.That(allowed.z, Is.EqualTo(math.min(s_Limits.SpeedToStopWithin(distance - moved - k_Clearance), 1f)).Within(1e-4f));
        }

        [Test]
        public void TooNearToAWall_ItBacksAway_AtMostByThreeTenths([Values(0.001f, 0.03f, 0.07f)] float distance)
        {
            ObstacleSense sense = Looking(s_Ahead, 1f);
            sense.SetHit(0, -s_Ahead, distance);
            float3 allowed = sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default, k_Near);

            Assert.That(allowed.z,
                Is.EqualTo(-math.min(s_Limits.SpeedToStopWithin(k_Clearance - distance), 0.3f)).Within(1e-4f).And.Negative);
        }

        // The distance from a surface is the part of a ray along its normal.
        [Test]
        public void AWallBesideTheWay_CountsByItsOwnDistance()
        {
            ObstacleSense sense = Looking(s_Ahead, 1f);
            float3 right = math.normalize(new float3(sense.Direction(1).x, 0f, 0f)), wanted = 0.9f * right + 0.3f * s_Ahead;
            float along = 0.4f, off = along * math.dot(sense.Direction(1), right) - k_Clearance;
            sense.SetHit(1, -right, along);
            float3 allowed = sense.Avoid(wanted, At(s_Place, 1f), ObstacleSettings.Default, k_Near);

            Assert.That(math.dot(allowed, right), Is.EqualTo(s_Limits.SpeedToStopWithin(off)).Within(1e-4f));
            Assert.That(allowed.z, Is.EqualTo(0.3f).Within(1e-5f));
        }

        [Test]
        public void BlockedAhead_ItTurnsToTheFreestSide([Range(1, 4)] int free)
        {
            ObstacleSense sense = Looking(s_Ahead, 1f);
            float3 side = sense.Direction(free) - s_Ahead * math.dot(sense.Direction(free), s_Ahead);
            for (int ray = 0; ray < ObstacleSense.RayCount; ray++)
                sense.SetHit(ray, -s_Ahead, ray == free ? 0.5f : 0.1f);
            float3 allowed = sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default);

            float most = s_Limits.SpeedToStopWithin(0.1f / math.sqrt(1.49f) - k_Clearance);
            Assert.That(math.dot(math.normalize(side), math.normalize(allowed * new float3(1f, 1f, 0f))), Is.EqualTo(1f).Within(1e-4f));
            Assert.That(allowed.z, Is.EqualTo(most).Within(1e-4f));
            Assert.That(math.length(allowed.xy), Is.EqualTo(1f - most).Within(1e-4f), "what it lost ahead");
            Assert.That(sense.IsBlocked, Is.True);
        }

        [Test]
        public void AGoalBeforeTheWall_IsFlownTo()
        {
            foreach ((float goal, bool turns) in new[] { (0.05f, false), (0.14f, false), (0.2f, true) })
            {
                ObstacleSense sense = Looking(s_Ahead, 1f);
                sense.SetHit(0, -s_Ahead, 0.1f);
                sense.SetHit(4, -s_Ahead, 0.6f);
                float3 allowed = sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default, goal);
                Assert.That(math.length(allowed.xy) > 0.1f, Is.EqualTo(turns), $"a goal {goal} m ahead");
            }
        }

        [Test]
        public void WhatIsBehindOrForgotten_OrNotToBeAvoided_ChangesNothing()
        {
            ObstacleSense sense = Looking(s_Ahead, 1f);
            sense.SetHit(0, s_Ahead, 0.2f);
            Assert.That(sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default, k_Near), Is.EqualTo(s_Ahead),
                "away from a surface");
            sense.SetHit(0, -s_Ahead, 0.1f);
            ObstacleSettings settings = ObstacleSettings.Default;
            settings.avoid = false;
            Assert.That(sense.Avoid(s_Ahead, At(s_Place, 1f), settings), Is.EqualTo(s_Ahead));
            sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default, k_Near);
            Assert.That(sense.Avoid(s_Ahead, At(s_Place, 1f), ObstacleSettings.Default, k_Near), Is.EqualTo(s_Ahead),
                "rays are asked anew each time");
            Assert.That(sense.Avoid(s_Ahead, At(s_Place + 0.97f * s_Ahead, 1f), ObstacleSettings.Default, k_Near), Is.EqualTo(s_Ahead));
        }

        private static ObstacleSense Looking(float3 wanted, float units)
        {
            var sense = new ObstacleSense();
            sense.Avoid(wanted, At(s_Place, units), ObstacleSettings.Default);
            return sense;
        }

        private static FlightSituation At(float3 position, float units) => new FlightSituation
        {
            position = position,
            rotation = quaternion.identity,
            limits = s_Limits,
            wingLength = k_Length,
            unitsPerMetre = units,
        };
    }
}
