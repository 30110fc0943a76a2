using NUnit.Framework;
using Unity.Collections;
using UnityEngine;

namespace Unity.Tests.Engine;

public sealed class RaycastTests : FreshSceneFixture
{
    [Test]
    public void ARay_MeetsTheNearestFace()
    {
        BoxCollider box = Made<BoxCollider>(new Vector3(0f, 0f, 5f));
        box.size = new Vector3(2f, 2f, 2f);
        Made<SphereCollider>(new Vector3(0f, 0f, 9f));

        Assert.That(Cast(Vector3.zero, Vector3.forward, out RaycastHit hit), Is.True);
        Assert.That(hit.distance, Is.EqualTo(4f).Within(1e-5f));
        Assert.That(hit.normal, Is.EqualTo(Vector3.back));
        Assert.That(hit.collider, Is.SameAs(box));
        Assert.That(Cast(new Vector3(0f, 0f, 5f), Vector3.back, out _), Is.False, "a ray that starts within meets nothing");
    }

    [Test]
    public void ATurnedScaledBox_IsMetOnItsSlope()
    {
        BoxCollider box = Made<BoxCollider>(Vector3.zero);
        box.transform.rotation = Quaternion.Euler(0f, 0f, 30f);
        box.transform.localScale = new Vector3(10f, 1f, 10f);

        Assert.That(Cast(new Vector3(1f, 5f, 0f), Vector3.down, out RaycastHit hit), Is.True);
        Assert.That(Vector3.Angle(hit.normal, Vector3.up), Is.EqualTo(30f).Within(1e-2f));
        Assert.That(Vector3.Dot(hit.point, hit.normal), Is.EqualTo(0.5f).Within(1e-5f));
    }

    [Test]
    public void TriggersAndLayers_AreLeftOut_WhereAsked()
    {
        SphereCollider sphere = Made<SphereCollider>(new Vector3(0f, 0f, 3f));
        sphere.isTrigger = true;
        Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 10f, -1, QueryTriggerInteraction.Ignore), Is.False);
        Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 10f, -1, QueryTriggerInteraction.UseGlobal), Is.True);
        Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 10f, 2, QueryTriggerInteraction.UseGlobal), Is.False);
        Assert.That(Physics.CheckSphere(new Vector3(0f, 0f, 2f), 0.6f, -1, QueryTriggerInteraction.Collide), Is.True);
        Assert.That(Physics.CheckSphere(new Vector3(0f, 0f, 2f), 0.4f, -1, QueryTriggerInteraction.Collide), Is.False);
    }

    [Test]
    public void ABatch_IsCastLikeOneRay()
    {
        SphereCollider sphere = Made<SphereCollider>(new Vector3(0f, 0f, 3f));
        using var rays = new NativeArray<RaycastCommand>(2, Allocator.TempJob);
        using var hits = new NativeArray<RaycastHit>(2, Allocator.TempJob);
        NativeArray<RaycastCommand> asked = rays;
        asked[0] = new RaycastCommand(Vector3.zero, Vector3.forward, QueryParameters.Default, 10f);
        asked[1] = new RaycastCommand(Vector3.zero, Vector3.up, QueryParameters.Default, 10f);
        RaycastCommand.ScheduleBatch(rays, hits, 1).Complete();

        Assert.That(hits[0].collider, Is.SameAs(sphere));
        Assert.That(hits[0].distance, Is.EqualTo(2.5f).Within(1e-5f));
        Assert.That(hits[1].collider, Is.Null);
    }

    private static bool Cast(Vector3 from, Vector3 along, out RaycastHit hit) =>
        Physics.Raycast(from, along, out hit, 100f, Physics.DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);

    private static T Made<T>(Vector3 place) where T : Collider
    {
        T made = new GameObject(typeof(T).Name).AddComponent<T>();
        made.transform.position = place;
        return made;
    }
}
