using System;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Flight
{
    /// <summary>The position loop along points.</summary>
    public sealed class PathTests
    {
        private static readonly Vector3[] s_Square = { new Vector3(0f, 5f, 0f), new Vector3(30f, 5f, 0f), new Vector3(30f, 8f, 30f),
            new Vector3(0f, 6f, 30f) };

        [Test]
        public void Follower_FliesNearThePath_AndStopsAtItsEnd([Values(0.3f, 0.8f, 1.3f)] float speed)
        {
            var flyer = new PointFlyer();
            flyer.situation.position = s_Square[0];
            var path = new PathFollower();
            path.Restart();
            float farthest = 0f;
            int step = 0;
            for (; step < 60 * 50 && !path.HasArrived; step++)
            {
                flyer.Fly(FlightCommand.Fly(path.Along(flyer.situation, s_Square, false, speed)));
                farthest = math.max(farthest, DistanceToPath(flyer.situation.position, s_Square, false) / 10f);
            }

            TestContext.Progress.WriteLine(
                FormattableString.Invariant($"{speed} m/s: {farthest:0.00} m from the path at most, there after {step / 50f:0.0} s"));
            Assert.That(path.HasArrived, Is.True);
            Assert.That(farthest, Is.LessThan(0.3f));
            for (int more = 0; more < 200; more++)
                flyer.Fly(FlightCommand.Fly(path.Along(flyer.situation, s_Square, false, speed)));
            Assert.That(math.distance(flyer.situation.position, s_Square[3]) / 10f, Is.LessThan(0.05f));
            Assert.That(math.length(flyer.situation.velocity), Is.LessThan(0.02f));
        }

        [Test]
        public void Loop_IsFlownRoundAndRound()
        {
            var flyer = new PointFlyer();
            flyer.situation.position = s_Square[0];
            var path = new PathFollower();
            path.Restart();
            int[] visits = new int[s_Square.Length];
            int last = -1;
            for (int step = 0; step < 90 * 50; step++)
            {
                flyer.Fly(FlightCommand.Fly(path.Along(flyer.situation, s_Square, true, 1f)));
                if (path.Next != last)
                    visits[last = path.Next]++;
                if (step > 50)
                    Assert.That(DistanceToPath(flyer.situation.position, s_Square, true) / 10f, Is.LessThan(0.3f));
            }

            Assert.That(visits, Has.All.GreaterThan(4));
        }

        [Test]
        public void Follower_BlownAside_ComesBackToThePath()
        {
            var flyer = new PointFlyer();
            flyer.situation.position = s_Square[0] + new Vector3(10f, 0f, -12f);
            var path = new PathFollower();
            path.Restart();
            for (int step = 0; step < 6 * 50; step++)
                flyer.Fly(FlightCommand.Fly(path.Along(flyer.situation, s_Square, true, 0.8f)));
            Assert.That(DistanceToPath(flyer.situation.position, s_Square, true) / 10f, Is.LessThan(0.2f));
        }

        [Test]
        public void PointsAtOnePlace_AreNoWay()
        {
            var points = new List<Vector3> { Vector3.up, Vector3.up, Vector3.up };
            var flyer = new PointFlyer();
            var path = new PathFollower();
            path.Restart();
            for (int step = 0; step < 500; step++)
            {
                var command = FlightCommand.Fly(path.Along(flyer.situation, points, true, 1f));
                Assert.That(math.all(math.isfinite(command.velocity)), Is.True);
                flyer.Fly(command);
            }

            Assert.That(math.distance(flyer.situation.position, points[0]), Is.LessThan(5f));
        }

        private static float DistanceToPath(float3 place, Vector3[] points, bool loop)
        {
            float nearest = float.MaxValue;
            for (int k = 0; k < (loop ? points.Length : points.Length - 1); k++)
            {
                float3 a = points[k], b = points[(k + 1) % points.Length];
                float share = math.saturate(math.dot(place - a, b - a) / math.lengthsq(b - a));
                nearest = math.min(nearest, math.distance(place, math.lerp(a, b, share)));
            }

            return nearest;
        }
    }
}
