using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>A million units from the origin, where neighbouring floats are a sixteenth of a unit apart.</summary>
    public sealed class FarTests : FlockFixture
    {
        private const float k_Same = 0.01f;

        private static readonly Vector3 s_Far = new Vector3(1e6f, 0f, -1e6f);

        [UnityTest]
        public IEnumerator AtRest_TheWingIsThatOfTheOrigin()
        {
            InsectWings near = Hatch(), far = Hatch(made => made.transform.position = s_Far);
            float worst = 0f;
            for (int frame = 0; frame < 60; frame++)
            {
                yield return null;
                if (frame > 1)
                    worst = math.max(worst, Farthest(Joints(near, 0), Joints(far, 0)));
            }

            Assert.That(worst, Is.LessThan(k_Same));
        }

        [UnityTest]
        public IEnumerator AtSteadySpeed_ItFeelsAboutThatSpeed()
        {
            // From a place where single steps are rounded to whole sixteenths.
            var velocity = new float3(0f, 0f, 10f);
            InsectWings insect = Hatch(made => made.transform.position = s_Far);
            double z = s_Far.z;
            float least = float.PositiveInfinity, most = 0f;
            for (int frame = 0; frame < 240; frame++)
            {
                z += velocity.z / 60.0;
                insect.transform.position = new Vector3(s_Far.x, 0f, (float)z);
                yield return null;
                if (frame < 60)
                    continue;
                float felt = insect.Live.flight.velocity.z;
                least = math.min(least, felt);
                most = math.max(most, felt);
            }

            Assert.That(least, Is.GreaterThan(0.8f * velocity.z));
            Assert.That(most, Is.LessThan(1.2f * velocity.z));
        }

        [UnityTest]
        public IEnumerator AtSteadySpeed_TheWingBarelyTrembles()
        {
            InsectWings near = Hatch(), far = Hatch(made => made.transform.position = s_Far);
            float worst = 0f;
            for (int frame = 0; frame < 240; frame++)
            {
                near.transform.position = new Vector3(0f, 0f, frame / 6f);
                far.transform.position = s_Far + new Vector3(0f, 0f, frame / 6f);
                yield return null;
                if (frame > 90)
                    worst = math.max(worst, Farthest(Joints(near, 0), Joints(far, 0)));
            }

            Assert.That(worst, Is.LessThan(2f * k_Same));
        }

        [UnityTest]
        public IEnumerator ATinyInsectAtRestFarAway_FeelsNoWind()
        {
            InsectWings insect = Hatch(made =>
            {
                made.transform.position = s_Far;
                made.transform.localScale = 0.01f * Vector3.one;
            });
            yield return Frames(30);

            Assert.That(math.length(insect.Live.flight.velocity), Is.Zero);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        }
    }
}
