using System;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Mathematics;

public sealed class QuaternionTests
{
    private const float k_Quarter = math.PI / 2f;

    private static readonly float3 s_X = new(1f, 0f, 0f);
    private static readonly float3 s_Y = new(0f, 1f, 0f);
    private static readonly float3 s_Z = new(0f, 0f, 1f);

    private static void AssertNear(float3 actual, float3 expected, float tolerance = 2e-6f, string message = null) =>
        Assert.That(math.distance(actual, expected), Is.LessThan(tolerance), $"{actual} instead of {expected}. {message}");

    private static void AssertNear(quaternion actual, quaternion expected, float tolerance = 2e-6f) =>
        Assert.That(math.length(actual.value - expected.value), Is.LessThan(tolerance), $"{actual} instead of {expected}");

    [Test]
    public void AQuarterTurn_GoesAsInUnity()
    {
        AssertNear(math.rotate(quaternion.RotateX(k_Quarter), s_Z), -s_Y);
        AssertNear(math.rotate(quaternion.RotateX(k_Quarter), s_Y), s_Z);
        AssertNear(math.rotate(quaternion.RotateY(k_Quarter), s_Z), s_X);
        AssertNear(math.rotate(quaternion.RotateY(k_Quarter), s_X), -s_Z);
        AssertNear(math.rotate(quaternion.RotateZ(k_Quarter), s_X), s_Y);
        AssertNear(math.rotate(quaternion.RotateZ(k_Quarter), s_Y), -s_X);
    }

    [Test]
    public void AxisAngle_IsTheRotationAboutThatAxis()
    {
        AssertNear(quaternion.AxisAngle(s_Y, 0.7f), quaternion.RotateY(0.7f));
        AssertNear(math.rotate(quaternion.AxisAngle(math.normalize(new float3(1f, 1f, 1f)), 2f * math.PI / 3f), s_X), s_Y);
    }

    [Test]
    public void Product_RotatesByTheRightFactorFirst()
    {
        var random = new Random(3);
        for (int i = 0; i < 50; i++)
        {
            quaternion a = random.NextQuaternionRotation(), b = random.NextQuaternionRotation();
            float3 v = random.NextFloat3Direction();
            AssertNear(math.rotate(math.mul(a, b), v), math.rotate(a, math.rotate(b, v)));
        }
    }

    [Test]
    public void Product_AgreesWithHamilton_InDoublePrecision()
    {
        var random = new Random(4);
        for (int i = 0; i < 50; i++)
        {
            float4 p = random.NextFloat4(-2f, 2f), q = random.NextFloat4(-2f, 2f);
            double x = (double)p.w * q.x + (double)p.x * q.w + (double)p.y * q.z - (double)p.z * q.y;
            double y = (double)p.w * q.y - (double)p.x * q.z + (double)p.y * q.w + (double)p.z * q.x;
            double z = (double)p.w * q.z + (double)p.x * q.y - (double)p.y * q.x + (double)p.z * q.w;
            double w = (double)p.w * q.w - (double)p.x * q.x - (double)p.y * q.y - (double)p.z * q.z;
            AssertNear(math.mul(new quaternion(p), new quaternion(q)), new quaternion((float)x, (float)y, (float)z, (float)w), 5e-6f);
        }
    }

    [Test]
    public void Inverse_UndoesTheRotation_EvenIfNotOfUnitLength()
    {
        var q = new quaternion(new float4(0.3f, -0.8f, 0.1f, 2f));
        AssertNear(math.mul(q, math.inverse(q)), quaternion.identity);
        AssertNear(math.rotate(math.conjugate(quaternion.RotateX(1f)), math.rotate(quaternion.RotateX(1f), s_Y)), s_Y);
    }

    [Test]
    public void Matrix_OfAQuaternion_RotatesAsItDoes_AndGivesItBack()
    {
        var random = new Random(5);
        for (int i = 0; i < 200; i++)
        {
            quaternion q = random.NextQuaternionRotation();
            float3 v = random.NextFloat3Direction();
            AssertNear(math.mul(new float3x3(q), v), math.rotate(q, v));
            quaternion back = new(new float3x3(q));
            AssertNear(new quaternion(back.value * math.sign(math.dot(back, q))), q, 4e-6f);
        }
    }

    [Test]
    public void Matrix_OfAHalfTurn_GivesItBack()
    {
        foreach (float3 axis in new[] { s_X, s_Y, s_Z, math.normalize(new float3(1f, 2f, -1f)) })
        {
            var q = quaternion.AxisAngle(axis, math.PI);
            quaternion back = new(new float3x3(q));
            Assert.That(math.abs(math.dot(back, q)), Is.EqualTo(1f).Within(1e-6f));
        }
    }

    [Test]
    public void LookRotation_TurnsForwardAndUpToTheArguments()
    {
        float3 forward = math.normalize(new float3(1f, 2f, 3f));
        float3 up = math.normalize(math.cross(forward, s_X));
        var q = quaternion.LookRotation(forward, up);
        AssertNear(math.rotate(q, s_Z), forward);
        AssertNear(math.rotate(q, s_Y), up);
        AssertNear(quaternion.LookRotationSafe(default, s_Y), quaternion.identity);
    }

    [Test]
    public void EulerZXY_RotatesAboutZThenXThenY()
    {
        var angles = new float3(0.3f, -1.1f, 0.7f);
        float3 v = math.rotate(quaternion.RotateZ(angles.z), s_X);
        v = math.rotate(quaternion.RotateX(angles.x), v);
        v = math.rotate(quaternion.RotateY(angles.y), v);
        AssertNear(math.rotate(quaternion.EulerZXY(angles), s_X), v);
    }

    [Test]
    public void Nlerp_GoesTheShorterWay_AsInDoublePrecision()
    {
        var random = new Random(6);
        for (int i = 0; i < 100; i++)
        {
            quaternion a = random.NextQuaternionRotation(), b = random.NextQuaternionRotation();
            float t = random.NextFloat();
            (double x, double y, double z, double w) = Nlerp(a.value, b.value, t);
            AssertNear(math.nlerp(a, b, t), new quaternion((float)x, (float)y, (float)z, (float)w), 4e-6f);
        }
    }

    [Test]
    public void Slerp_GoesTheShorterWay_AtConstantSpeed()
    {
        quaternion from = quaternion.RotateY(0.2f), to = quaternion.RotateY(1.7f);
        for (float t = 0f; t <= 1f; t += 0.125f)
        {
            AssertNear(math.slerp(from, to, t), quaternion.RotateY(0.2f + 1.5f * t));
            AssertNear(math.slerp(from, new quaternion(-to.value), t), quaternion.RotateY(0.2f + 1.5f * t));
        }

        AssertNear(math.slerp(from, quaternion.RotateY(0.201f), 0.5f), quaternion.RotateY(0.2005f));
    }

    [Test]
    public void NormalizeSafe_OfNothing_IsTheIdentity()
    {
        AssertNear(math.normalizesafe(default(quaternion)), quaternion.identity);
        AssertNear(math.normalizesafe(new quaternion(0f, 0f, 3f, 0f)), new quaternion(0f, 0f, 1f, 0f));
    }

    private static (double X, double Y, double Z, double W) Nlerp(float4 a, float4 b, double t)
    {
        double dot = (double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z + (double)a.w * b.w;
        double s = dot < 0.0 ? -t : t;
        double x = (1.0 - t) * a.x + s * b.x, y = (1.0 - t) * a.y + s * b.y, z = (1.0 - t) * a.z + s * b.z, w = (1.0 - t) * a.w + s * b.w;
        double length = Math.Sqrt(x * x + y * y + z * z + w * w);
        return (x / length, y / length, z / length, w / length);
    }
}
