using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class RenderingTests : FreshSceneFixture
{
    private Mesh m_Mesh;

    [SetUp]
    public void MakeMesh() => m_Mesh = Meshes.Square();

    [TearDown]
    public void DestroyMesh() => Object.DestroyImmediate(m_Mesh);

    [Test]
    public void Bounds_FollowTheTransform()
    {
        Renderer renderer = Draw();
        renderer.transform.SetPositionAndRotation(new Vector3(10f, 0f, 0f), Quaternion.Euler(0f, 0f, 90f));
        renderer.transform.localScale = new Vector3(2f, 1f, 1f);

        Assert.That((renderer.bounds.center - new Vector3(9.5f, 1f, 0f)).magnitude, Is.LessThan(1e-5f));
        Assert.That((renderer.bounds.size - new Vector3(1f, 2f, 0f)).magnitude, Is.LessThan(1e-5f));
    }

    [Test]
    public void ARenderer_IsVisible_WhileItsBoundsAreInACamerasView()
    {
        Transform camera = new GameObject("camera", typeof(Camera)).transform;
        camera.position = new Vector3(0f, 0f, -5f);
        Renderer renderer = Draw();
        Witness witness = renderer.gameObject.AddComponent<Witness>();

        PlayerLoop.Tick(0f);
        Assert.That((renderer.isVisible, witness.seen), Is.EqualTo((true, 1)));

        camera.Rotate(0f, 180f, 0f);
        PlayerLoop.Tick(0f);
        Assert.That((renderer.isVisible, witness.lost), Is.EqualTo((false, 1)));

        camera.rotation = Quaternion.identity;
        renderer.transform.position = new Vector3(3f, 0f, 0f);
        PlayerLoop.Tick(0f);
        Assert.That(renderer.isVisible, Is.True, "at 5 m a view of 60 degrees and 16:9 reaches 5.1 m to the side");
        renderer.transform.position = new Vector3(6f, 0f, 0f);
        PlayerLoop.Tick(0f);
        Assert.That(renderer.isVisible, Is.False);
    }

    [Test]
    public void WorldToViewport_PutsTheAxisInTheMiddle_AndTheFrustumsEdgeAtOne()
    {
        Camera camera = new GameObject("camera").AddComponent<Camera>();
        camera.fieldOfView = 90f;
        Vector3 edge = camera.WorldToViewportPoint(new Vector3(0f, 4f, 4f));
        Assert.That((edge - new Vector3(0.5f, 1f, 4f)).magnitude, Is.LessThan(1e-5f));
    }

    [Test]
    public void ASkin_FollowsItsBones()
    {
        SkinnedMeshRenderer renderer = new GameObject("skin").AddComponent<SkinnedMeshRenderer>();
        Transform bone = new GameObject("bone").transform;
        m_Mesh.bindposes = new[] { Matrix4x4.identity };
        m_Mesh.boneWeights = System.Array.ConvertAll(m_Mesh.vertices, _ => new BoneWeight { weight0 = 1f });
        renderer.sharedMesh = m_Mesh;
        renderer.bones = new[] { bone };
        bone.position = new Vector3(0f, 3f, 0f);
        var baked = new Mesh();

        renderer.BakeMesh(baked);

        Assert.That(baked.vertices[2], Is.EqualTo(new Vector3(1f, 4f, 0f)));
        Assert.That(baked.triangles, Is.EqualTo(m_Mesh.triangles));
        Object.DestroyImmediate(baked);
    }

    [Test]
    public void ARenderersOwnMaterial_IsACopy()
    {
        Renderer renderer = Draw();
        var shared = new Material(Shader.Find("Standard")) { color = Color.red };
        renderer.sharedMaterial = shared;
        renderer.material.color = Color.blue;

        Assert.That(shared.color, Is.EqualTo(Color.red));
        Assert.That(renderer.material, Is.SameAs(renderer.sharedMaterial));
        Object.DestroyImmediate(renderer.sharedMaterial);
        Object.DestroyImmediate(shared);
    }

    [Test]
    public void ACopiedHierarchy_UsesItsOwnBones_AnchorsAndLevels()
    {
        Transform root = new GameObject("root").transform;
        Transform bone = new GameObject("bone").transform;
        Transform outside = new GameObject("outside").transform;
        bone.SetParent(root);
        SkinnedMeshRenderer skin = root.gameObject.AddComponent<SkinnedMeshRenderer>();
        skin.bones = new[] { bone, outside, null };
        skin.rootBone = bone;
        skin.probeAnchor = bone;
        skin.sortingOrder = 7;
        root.gameObject.AddComponent<LODGroup>().SetLODs(new[] { new LOD(0.5f, new Renderer[] { skin }) });

        Transform copy = Object.Instantiate(root);

        SkinnedMeshRenderer twin = copy.GetComponent<SkinnedMeshRenderer>();
        Assert.That(twin.bones, Is.EqualTo(new[] { copy.GetChild(0), outside, null }));
        Assert.That(twin.rootBone, Is.SameAs(copy.GetChild(0)));
        Assert.That(twin.probeAnchor, Is.SameAs(copy.GetChild(0)));
        Assert.That(twin.sortingOrder, Is.EqualTo(7));
        Assert.That(copy.GetComponent<LODGroup>().GetLODs()[0].renderers, Is.EqualTo(new[] { twin }));
    }

    [Test]
    public void LevelsOfDetail_AreCopies_InFallingOrder()
    {
        Renderer renderer = Draw();
        LODGroup group = renderer.gameObject.AddComponent<LODGroup>();
        group.SetLODs(new[] { new LOD(0.5f, new[] { renderer }), new LOD(0.2f, null) });
        group.GetLODs()[0].renderers[0] = null;

        Assert.That(group.GetLODs()[0].renderers[0], Is.SameAs(renderer));
        Assert.That(group.lodCount, Is.EqualTo(2));
        LogAssert.Expect(LogType.Error, new Regex("SetLODs"));
        group.SetLODs(new[] { new LOD(0.2f, null), new LOD(0.2f, null) });
        Assert.That(group.GetLODs()[0].screenRelativeTransitionHeight, Is.EqualTo(0.5f));
    }

    [Test]
    public void PropertiesOfAMaterial_AreItsOwn()
    {
        Renderer renderer = Draw();
        renderer.sharedMaterials = new Material[2];
        var block = new MaterialPropertyBlock();
        block.SetFloat("_A", 2f);

        renderer.SetPropertyBlock(block, 1);

        renderer.GetPropertyBlock(block);
        Assert.That(block.isEmpty && renderer.HasPropertyBlock());
        renderer.GetPropertyBlock(block, 1);
        Assert.That(block.GetFloat("_A"), Is.EqualTo(2f));
        Assert.That(() => renderer.SetPropertyBlock(block, 2), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void BlendShapes_HaveFramesOfRisingWeight()
    {
        Vector3[] deltas = m_Mesh.vertices;
        m_Mesh.AddBlendShapeFrame("smile", 50f, deltas, null, null);
        m_Mesh.AddBlendShapeFrame("smile", 100f, deltas, deltas, null);
        Assert.That(() => m_Mesh.AddBlendShapeFrame("smile", 80f, deltas, null, null), Throws.ArgumentException);
        Assert.That(() => m_Mesh.AddBlendShapeFrame("frown", 80f, new Vector3[1], null, null), Throws.ArgumentException);

        Mesh copy = Object.Instantiate(m_Mesh);
        (Vector3[] moves, Vector3[] turns) = (new Vector3[4], new Vector3[4]);
        copy.GetBlendShapeFrameVertices(copy.GetBlendShapeIndex("smile"), 0, moves, turns, null);
        Assert.That((copy.blendShapeCount, copy.GetBlendShapeFrameCount(0), copy.GetBlendShapeFrameWeight(0, 1)), Is.EqualTo((1, 2, 100f)));
        Assert.That((moves[2], turns[2]), Is.EqualTo((deltas[2], Vector3.zero)));
        copy.ClearBlendShapes();
        Assert.That((copy.blendShapeCount, m_Mesh.blendShapeCount), Is.EqualTo((0, 1)));
        Object.DestroyImmediate(copy);
    }

    private Renderer Draw()
    {
        var drawn = new GameObject("drawn", typeof(MeshFilter), typeof(MeshRenderer));
        drawn.GetComponent<MeshFilter>().sharedMesh = m_Mesh;
        return drawn.GetComponent<Renderer>();
    }

    private sealed class Witness : MonoBehaviour
    {
        public int seen;
        public int lost;

        private void OnBecameVisible() => seen++;

        private void OnBecameInvisible() => lost++;
    }
}
