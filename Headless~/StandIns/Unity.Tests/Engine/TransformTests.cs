using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Engine;

public sealed class TransformTests : FreshSceneFixture
{
    [Test]
    public void EulerAngles_TurnAboutZThenXThenY()
    {
        var turn = Quaternion.Euler(10f, 20f, 30f);
        Quaternion oneByOne = Quaternion.AngleAxis(20f, Vector3.up)
            * Quaternion.AngleAxis(10f, Vector3.right)
            * Quaternion.AngleAxis(30f, Vector3.forward);

        Assert.That(Quaternion.Angle(turn, oneByOne), Is.LessThan(0.01f));
        AssertClose(turn.eulerAngles, new Vector3(10f, 20f, 30f), 1e-3f);
    }

    [Test]
    public void EulerAngles_RoundTrip_AlsoAtThePoles([Values(-90f, -60f, 0f, 45f, 90f)] float x, [Values(-170f, 0f, 80f)] float y)
    {
        var turn = Quaternion.Euler(x, y, 33f);
        Assert.That(Quaternion.Angle(turn, Quaternion.Euler(turn.eulerAngles)), Is.LessThan(0.2f));
    }

    [Test]
    public void LookRotation_TurnsForwardAndUp()
    {
        var look = Quaternion.LookRotation(new Vector3(1f, 2f, 3f), Vector3.up);
        AssertClose(look * Vector3.forward, new Vector3(1f, 2f, 3f).normalized, 1e-5f);
        Assert.That(Vector3.Dot(look * Vector3.right, Vector3.up), Is.Zero.Within(1e-6f));
    }

    [Test]
    public void FromToRotation_TurnsOneIntoTheOther_AlsoAround()
    {
        AssertClose(Quaternion.FromToRotation(Vector3.right, Vector3.left) * Vector3.right, Vector3.left, 1e-5f);
        Vector3 aslant = new Vector3(1f, 2f, -1f).normalized;
        AssertClose(Quaternion.FromToRotation(Vector3.up, aslant) * Vector3.up, aslant, 1e-5f);
    }

    [Test]
    public void AMatrix_TimesItsInverse_IsTheIdentity()
    {
        var m = Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 20f, 30f), new Vector3(2f, -3f, 0.5f));
        AssertClose(m * m.inverse, Matrix4x4.identity, 1e-5f);
        Assert.That(m.determinant, Is.EqualTo(-3f).Within(1e-4f));
        AssertClose((Vector3)(m * new Vector4(1f, 1f, 1f, 1f)), m.MultiplyPoint3x4(Vector3.one), 1e-5f);
    }

    [Test]
    public void WorldPoints_FollowTheMatrices_OfAnyChain([Values(1, 2, 3, 4, 5, 6, 7, 8)] int seed)
    {
        Transform tip = Chain((uint)seed, 4);
        Vector3 local = new(0.3f, -0.7f, 1.1f);
        Vector3 world = tip.localToWorldMatrix.MultiplyPoint3x4(local);

        AssertClose(tip.TransformPoint(local), world, 1e-4f);
        AssertClose(tip.InverseTransformPoint(world), local, 1e-3f);
        AssertClose(tip.worldToLocalMatrix.MultiplyPoint3x4(world), local, 1e-3f);
        AssertClose(tip.InverseTransformVector(tip.TransformVector(local)), local, 1e-3f);
        AssertClose(tip.InverseTransformDirection(tip.TransformDirection(local)), local, 1e-4f);
    }

    [Test]
    public void RotationAndLossyScale_MakeTheMatrix_UnderMirrors()
    {
        Transform parent = new GameObject("parent").transform;
        parent.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(40f, 50f, 60f));
        parent.localScale = new Vector3(-2f, 2f, 2f);
        Transform child = Child(parent, new Vector3(0.5f, 0f, 1f), Quaternion.Euler(-30f, 15f, 70f), new Vector3(1f, 3f, 0.5f));

        var made = Matrix4x4.TRS(child.position, child.rotation, child.lossyScale);
        AssertClose(made, child.localToWorldMatrix, 1e-4f);
        Assert.That(child.lossyScale.x * child.lossyScale.y * child.lossyScale.z, Is.EqualTo(-12f).Within(1e-3f));
    }

    [Test]
    public void SettingAWorldRotation_GivesItBack_UnderMirrors([Values(1, 2, 3, 4, 5, 6)] int seed)
    {
        Transform tip = Chain((uint)seed, 4);
        var wanted = Quaternion.Euler(11f, 222f, 33f);

        tip.SetPositionAndRotation(new Vector3(4f, 5f, 6f), wanted);

        Assert.That(Quaternion.Angle(tip.rotation, wanted), Is.LessThan(0.1f));
        AssertClose(tip.position, new Vector3(4f, 5f, 6f), 1e-3f);
    }

    [Test]
    public void ANewParent_MovesNothing_UnlessAsked()
    {
        Transform parent = new GameObject("parent").transform;
        parent.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f));
        parent.localScale = new Vector3(2f, 2f, -2f);
        Transform child = new GameObject("child").transform;
        child.SetPositionAndRotation(new Vector3(5f, 6f, 7f), Quaternion.Euler(10f, 20f, 30f));
        Matrix4x4 before = child.localToWorldMatrix;

        child.SetParent(parent);
        Assert.That(child.parent, Is.SameAs(parent));
        AssertClose(child.position, new Vector3(5f, 6f, 7f), 1e-4f);
        Assert.That(Quaternion.Angle(child.rotation, Quaternion.Euler(10f, 20f, 30f)), Is.LessThan(0.1f));

        child.SetParent(null, true);
        AssertClose(child.localToWorldMatrix, before, 1e-4f);

        child.SetParent(parent, false);
        AssertClose(child.localPosition, new Vector3(5f, 6f, 7f), 1e-4f);
    }

    [Test]
    public void AScaleOfZero_GivesNoInfinities()
    {
        Transform parent = new GameObject("parent").transform;
        parent.localScale = Vector3.zero;
        Transform child = Child(parent, Vector3.one, Quaternion.identity, Vector3.one);

        child.position = new Vector3(1f, 2f, 3f);

        AssertClose(child.position, Vector3.zero, 0f);
        AssertClose(child.InverseTransformPoint(Vector3.one), -child.localPosition, 1e-6f);
    }

    [Test]
    public void NotANumber_IsRefusedWithAnError()
    {
        Transform t = new GameObject("t").transform;
        LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("not valid"));
        t.localPosition = new Vector3(float.NaN, 0f, 0f);
        AssertClose(t.localPosition, Vector3.zero, 0f);
    }

    [Test]
    public void AnAncestor_CannotBecomeAChild()
    {
        Transform parent = new GameObject("parent").transform;
        Transform child = Child(parent, default, Quaternion.identity, Vector3.one);
        LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("parent"));
        parent.SetParent(child);
        Assert.That(parent.parent, Is.Null);
    }

    [Test]
    public void Names_FindDescendants_AndOrderCanBeChanged()
    {
        Transform root = new GameObject("root").transform;
        Transform a = Child(root, default, Quaternion.identity, Vector3.one), b = Child(root, default, Quaternion.identity, Vector3.one);
        a.name = "a";
        b.name = "b";
        Transform c = Child(b, default, Quaternion.identity, Vector3.one);
        c.name = "c";

        Assert.That(root.Find("b/c"), Is.SameAs(c));
        Assert.That(root.Find("c") == null, Is.True);
        b.SetAsFirstSibling();
        Assert.That(root.GetChild(0), Is.SameAs(b));
        Assert.That(c.root, Is.SameAs(root));
    }

    private static Transform Chain(uint seed, int length)
    {
        var random = new Random(seed);
        Transform tip = null;
        for (int i = 0; i < length; i++)
        {
            float scale = random.NextFloat(0.5f, 2f);
            float3 mirror = math.select(new float3(1f), new float3(-1f), random.NextFloat3() > 0.5f);
            tip = Child(tip, random.NextFloat3(-2f, 2f), random.NextQuaternionRotation(), scale * mirror);
        }

        return tip;
    }

    private static Transform Child(Transform parent, Vector3 position, Quaternion rotation, Vector3 scale)
    {
        Transform child = new GameObject("child").transform;
        child.SetParent(parent, false);
        child.localPosition = position;
        child.localRotation = rotation;
        child.localScale = scale;
        return child;
    }

    private static void AssertClose(Vector3 actual, Vector3 expected, float within) =>
        Assert.That((actual - expected).magnitude, Is.LessThanOrEqualTo(within), $"{actual:F5} is not {expected:F5}");

    private static void AssertClose(Matrix4x4 actual, Matrix4x4 expected, float within)
    {
        for (int i = 0; i < 16; i++)
            Assert.That(actual[i], Is.EqualTo(expected[i]).Within(within), $"element {i}");
    }
}
