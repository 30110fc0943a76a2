using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>The middle of a sway and its width, of what moves for seconds.</summary>
    public sealed class PerchSwayTests
    {
        private const float k_Step = 0.02f;

        [Test]
        public void WhatStays_IsItsOwnMiddle_ToTheBit()
        {
            var place = new float3(0.1f, -7.3f, 1e5f / 3f);
            var sway = new PerchSway(place);
            for (int step = 0; step < 1000; step++)
                sway.Add(place, k_Step);
            Assert.That((sway.Middle, sway.Along(new float3(0.6f, 0.8f, 0f))), Is.EqualTo((place, 0f)));
        }

        [Test]
        public void WhatSwaysOnceASecond_HasItsMiddleAndWidth_AfterOneSway(
            [Values(0f, 0.3f, 0.7f)] float phase, [Values(1f, 2.5f)] float rate)
        {
            float3 middle = new float3(1f, 2f, 3f), way = new float3(0.05f, -0.02f, 0.01f);
            float3 At(float time) => middle + math.sin(2f * math.PI * (rate * time + phase)) * way;
            var sway = new PerchSway(At(0f));
            for (int step = 1; step <= 500; step++)
            {
                sway.Add(At(step * k_Step), k_Step);
                if (step * k_Step * rate < 1f)
                    continue;
                Assert.That(math.distance(sway.Middle, middle), Is.LessThan(0.02f * math.length(way)), $"step {step}");
                Assert.That(sway.Along(new float3(-1f, 0f, 0f)), Is.EqualTo(0.05f).Within(0.001f), $"step {step}");
                Assert.That(sway.Along(new float3(0f, 1f, 0f)), Is.EqualTo(0.02f).Within(0.0004f), $"step {step}");
            }
        }

        [Test]
        public void WhatHasStopped_IsItsOwnMiddle_WithinThreeSeconds()
        {
            var sway = new PerchSway(default);
            float3 place = default;
            for (int step = 0; step < 200; step++)
            {
                place += new float3(0.01f, 0f, 0f);
                sway.Add(place, k_Step);
            }

            for (int step = 0; step < 151; step++)
                sway.Add(place, k_Step);
            Assert.That(sway.Middle, Is.EqualTo(place));
        }
    }
}
