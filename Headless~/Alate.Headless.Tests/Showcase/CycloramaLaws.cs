using System.Collections;
using System.Linq;
using Alate.Catalogue;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>Laws of a studio's walls: closed, seen from inside alone, level below what is looked at.</summary>
public sealed class CycloramaLaws : PlayFixture
{
    private const float k_Below = 0.7f, k_Distance = 2f;

    private static readonly Vector3 s_Target = new(1f, 2f, -3f);

    [Test]
    public void EveryTriangle_LooksAtTheTarget_AndSoDoesEachNormal()
    {
        Mesh walls = Made().GetComponent<MeshFilter>().sharedMesh;
        Vector3[] places = walls.vertices, normals = walls.normals;
        Vector3 eye = k_Below * Vector3.up;
        for (int k = 0; k < walls.triangles.Length; k += 3)
        {
            Vector3 a = places[walls.triangles[k]], b = places[walls.triangles[k + 1]], c = places[walls.triangles[k + 2]];
            var front = Vector3.Cross(b - a, c - a);
            Assert.That(front.magnitude, Is.GreaterThan(1e-4f), $"triangle {k / 3} is none");
            Assert.That(Vector3.Dot(front.normalized, (eye - a).normalized), Is.GreaterThan(0.05f), $"triangle {k / 3}");
            foreach (Vector3 normal in walls.triangles[k..(k + 3)].Select(corner => normals[corner]))
                Assert.That(Vector3.Dot(normal, front.normalized), Is.GreaterThan(0.95f), $"triangle {k / 3}");
        }
    }

    [Test]
    public void ItIsClosed()
    {
        Mesh walls = Made().GetComponent<MeshFilter>().sharedMesh;
        int[] triangles = walls.triangles;
        Vector3[] places = walls.vertices;
        ((int, int, int) From, (int, int, int) To)[] edges =
            [.. Enumerable.Range(0, triangles.Length).Select(k => (Place(k), Place(k % 3 == 2 ? k - 2 : k + 1)))];
        Assert.That(edges.Distinct().Count(), Is.EqualTo(edges.Length));
        Assert.That(edges.Select(edge => (edge.To, edge.From)), Is.EquivalentTo(edges), "each edge has a triangle on either side");

        (int, int, int) Place(int corner)
        {
            Vector3 place = 1e4f * places[triangles[corner]];
            return (Mathf.RoundToInt(place.x), Mathf.RoundToInt(place.y), Mathf.RoundToInt(place.z));
        }
    }

    [Test]
    public void TheFloor_IsLevelBelowTheTarget_AndTheCameraIsInside([Values(0f, 30f)] float turned)
    {
        OrbitCamera camera = Camera();
        camera.transform.parent.rotation = Quaternion.Euler(turned, 0f, turned);
        var made = Cyclorama.Create(camera, k_Below, WingMaterial.ForVertexColours(false, false));

        Assert.That(Vector3.Distance(made.transform.position, s_Target - k_Below * Vector3.up), Is.LessThan(1e-5f));
        Assert.That(Vector3.Angle(made.transform.up, Vector3.up), Is.LessThan(0.01f));
        Vector3[] places = made.GetComponent<MeshFilter>().sharedMesh.vertices;
        Assert.That(places.Min(place => place.y), Is.EqualTo(0f).Within(1e-5f));
        foreach (Vector3 floor in places.Where(place => new Vector2(place.x, place.z).magnitude < k_Distance))
            Assert.That(floor.y > k_Distance || floor.y == 0f, Is.True, $"{floor}");
        Assert.That(places.Max(place => new Vector2(place.x, place.z).magnitude), Is.GreaterThan(3f * k_Distance));
        Assert.That(places.Max(place => place.y), Is.GreaterThan(k_Below + 3f * k_Distance));
    }

    [Test]
    public void ShadowsFallOnIt_AndItCastsNone()
    {
        OrbitCamera camera = Camera();
        Light lamp = camera.GetComponentInChildren<Light>();
        Assert.That(lamp.shadows, Is.EqualTo(LightShadows.None));
        MeshRenderer shown = Cyclorama.Create(camera, k_Below, WingMaterial.ForVertexColours(false, false)).GetComponent<MeshRenderer>();
        Assert.That(lamp.shadows, Is.EqualTo(LightShadows.Soft));
        Assert.That(shown.shadowCastingMode, Is.EqualTo(ShadowCastingMode.Off));
        Assert.That(shown.receiveShadows, Is.True);
    }

    [UnityTest]
    public IEnumerator ItsMeshAndMaterial_EndWithIt()
    {
        Cyclorama made = Made();
        Mesh walls = made.GetComponent<MeshFilter>().sharedMesh;
        Material material = made.GetComponent<MeshRenderer>().sharedMaterial;
        Object.Destroy(made.gameObject);
        yield return Frames(2);
        Assert.That(walls == null && material == null, Is.True);
    }

    [TestCase(0f)]
    [TestCase(-1f)]
    [TestCase(float.NaN)]
    [TestCase(float.PositiveInfinity)]
    public void AFloorThatIsNotBelow_IsRefused(float below)
    {
        Material material = Keep(WingMaterial.ForVertexColours(false, false));
        Assert.That(() => Cyclorama.Create(Camera(), below, material),
            Throws.InstanceOf<System.ArgumentOutOfRangeException>().With.Message.Contains("below the target"));
        Assert.That(() => Cyclorama.Create(null, 1f, material), Throws.ArgumentNullException);
        Assert.That(() => Cyclorama.Create(Camera(), 1f, null), Throws.ArgumentNullException);
    }

    private Cyclorama Made() => Cyclorama.Create(Camera(), k_Below, WingMaterial.ForVertexColours(false, false));

    private OrbitCamera Camera() => OrbitCamera.Create(Keep(new GameObject("stage")).transform, s_Target, k_Distance);
}
