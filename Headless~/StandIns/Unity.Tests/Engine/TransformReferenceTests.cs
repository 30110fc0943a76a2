using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;
using Random = System.Random;

namespace Unity.Tests.Engine;

/// <summary>Transforms against chains of scale, rotation and translation that are worked out in double precision.</summary>
public sealed class TransformReferenceTests
{
    private readonly List<Transform> m_Chain = new();
    private Random m_Random;

    [SetUp]
    public void Seed() => m_Random = new Random(7);

    [TearDown]
    public void DestroyChain()
    {
        if (m_Chain.Count > 0)
            Object.DestroyImmediate(m_Chain[0].gameObject);
        m_Chain.Clear();
    }

    [Test]
    public void APoint_GoesThroughAllLevels([Values(false, true)] bool mirrored)
    {
        Build(5, mirrored);
        for (int i = 0; i < 20; i++)
        {
            Vector3 point = Any(3f);
            Near(m_Chain[^1].TransformPoint(point), Reference(point), 1e-3);
            Near(m_Chain[^1].localToWorldMatrix.MultiplyPoint3x4(point), Reference(point), 1e-3);
        }
    }

    [Test]
    public void TheWayBack_EndsWhereItBegan([Values(false, true)] bool mirrored)
    {
        Build(4, mirrored);
        Transform last = m_Chain[^1];
        for (int i = 0; i < 20; i++)
        {
            Vector3 point = Any(3f);
            Near(last.InverseTransformPoint(last.TransformPoint(point)), Double(point), 2e-3);
            Near(last.InverseTransformVector(last.TransformVector(point)), Double(point), 2e-3);
            Near(last.InverseTransformDirection(last.TransformDirection(point)), Double(point), 1e-4);
        }
    }

    [Test]
    public void ADirection_KeepsItsLength()
    {
        Build(4, false);
        Vector3 direction = Any(2f);
        Assert.That(m_Chain[^1].TransformDirection(direction).magnitude, Is.EqualTo(direction.magnitude).Within(1e-4f));
    }

    [Test]
    public void AWorldPlace_IsReachedUnderAnyParent()
    {
        Build(4, true);
        var target = new Vector3(1f, -2f, 3f);
        m_Chain[^1].position = target;
        Near(m_Chain[^1].position, Double(target), 1e-4);
    }

    [Test]
    public void ANewParent_LeavesTheWorldPlace_OrTheLocalOne()
    {
        Build(3, false);
        Transform free = new GameObject("free").transform;
        free.position = new Vector3(1f, 2f, 3f);
        free.SetParent(m_Chain[2], true);
        Near(free.position, (1.0, 2.0, 3.0), 1e-4);

        Vector3 local = free.localPosition;
        free.SetParent(m_Chain[1], false);

        Assert.That(free.localPosition, Is.EqualTo(local));
    }

    private void Build(int levels, bool mirrored)
    {
        for (int i = 0; i < levels; i++)
        {
            Transform made = new GameObject($"level {i}").transform;
            made.SetParent(i == 0 ? null : m_Chain[^1], false);
            made.localPosition = Any(2f);
            made.localRotation = Quaternion.Euler(Any(180f));
            made.localScale = Vector3.one * (0.5f + (float)m_Random.NextDouble());
            m_Chain.Add(made);
        }

        Vector3 scale = m_Chain[^1].localScale;
        m_Chain[^1].localScale = new Vector3(mirrored ? -scale.x : scale.x, 2f * scale.y, scale.z);
    }

    private (double X, double Y, double Z) Reference(Vector3 point)
    {
        (double x, double y, double z) = Double(point);
        for (int i = m_Chain.Count - 1; i >= 0; i--)
        {
            Transform level = m_Chain[i];
            (x, y, z) = (x * level.localScale.x, y * level.localScale.y, z * level.localScale.z);
            (x, y, z) = Rotated(level.localRotation, x, y, z);
            (x, y, z) = (x + level.localPosition.x, y + level.localPosition.y, z + level.localPosition.z);
        }

        return (x, y, z);
    }

    // p + 2 q × (q × p + w p)
    private static (double X, double Y, double Z) Rotated(Quaternion q, double x, double y, double z)
    {
        double a = (double)q.y * z - (double)q.z * y + q.w * x;
        double b = (double)q.z * x - (double)q.x * z + q.w * y;
        double c = (double)q.x * y - (double)q.y * x + q.w * z;
        return (x + 2.0 * (q.y * c - q.z * b), y + 2.0 * (q.z * a - q.x * c), z + 2.0 * (q.x * b - q.y * a));
    }

    private Vector3 Any(float size) => new(Number(size), Number(size), Number(size));

    private float Number(float size) => size * (float)(2.0 * m_Random.NextDouble() - 1.0);

    private static (double X, double Y, double Z) Double(Vector3 v) => (v.x, v.y, v.z);

    private static void Near(Vector3 actual, (double X, double Y, double Z) expected, double tolerance)
    {
        Assert.That((double)actual.x, Is.EqualTo(expected.X).Within(tolerance));
        Assert.That((double)actual.y, Is.EqualTo(expected.Y).Within(tolerance));
        Assert.That((double)actual.z, Is.EqualTo(expected.Z).Within(tolerance));
    }
}
