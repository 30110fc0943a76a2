using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Attitudes as quaternions tell them.</summary>
    public sealed unsafe class AttitudeLaws
    {
        [Test]
        public void AQuaternionAndItsNegative_AreOneTurnOutOfTheTrim([Values(-2.5f, -0.5f, 0.3f, 2f)] float off)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = 0f;
            FlyingBody body = default;
            body.rotation = math.mul(quaternion.RotateY(off), quaternion.RotateX(0.2f));
            float3 apart = BodyFeedback.TurnApart(body, point, default, out _);
            body.rotation.value = -body.rotation.value;

            Assert.That(math.distance(apart, BodyFeedback.TurnApart(body, point, default, out _)), Is.LessThan(1e-6f));
            Assert.That(apart.y * off, Is.GreaterThan(0f), "to the side that it looks to");
        }
    }
}
