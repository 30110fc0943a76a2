using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class CopyTests : FreshSceneFixture
{
    [SetUp]
    public void OpenDiary() => Diary.Lines.Clear();

    [Test]
    public void ACopy_HasWhatIsSaved_AndNothingElse()
    {
        Bag original = new GameObject("a").AddComponent<Bag>();
        original.Fill();

        Bag copy = Object.Instantiate(original);

        Assert.That(copy.name, Is.EqualTo("a(Clone)"));
        Assert.That((copy.number, copy.Hidden, copy.unsaved), Is.EqualTo((3, 4f, 0)));
        Assert.That(copy.list, Is.EqualTo(original.list).And.Not.SameAs(original.list));
        Assert.That(copy.part.values, Is.EqualTo(original.part.values).And.Not.SameAs(original.part.values));
        Assert.That(copy.colour, Is.EqualTo(original.colour));
        Assert.That(copy.table, Is.Null);
    }

    [Test]
    public void WhatIsSavedInPlace_IsNeverNull()
    {
        Bag copy = Object.Instantiate(new GameObject("a").AddComponent<Bag>());
        Assert.That(copy.part, Is.Not.Null);
        Assert.That(copy.text, Is.Empty);
        Assert.That(copy.list, Is.Empty);
    }

    [Test]
    public void ReferencesInsideTheHierarchy_LeadToTheCopies_OthersStay()
    {
        var outside = new GameObject("outside");
        Bag root = new GameObject("root").AddComponent<Bag>();
        var child = new GameObject("child");
        child.transform.SetParent(root.transform);
        root.target = child.transform;
        root.objects = new[] { root.gameObject, outside };

        Bag copy = Object.Instantiate(root);

        Assert.That(copy.target, Is.SameAs(copy.transform.GetChild(0)).And.Not.SameAs(child.transform));
        Assert.That(copy.objects, Is.EqualTo(new[] { copy.gameObject, outside }));
    }

    [Test]
    public void ACopy_AwakesWithItsFieldsInPlace_ParentsFirst()
    {
        var root = new GameObject("root");
        root.SetActive(false);
        root.AddComponent<Reader>().value = 7;
        root.AddComponent<Diary>();
        var child = new GameObject("child");
        child.transform.SetParent(root.transform);
        child.AddComponent<EarlyDiary>();
        GameObject sleeping = Object.Instantiate(root);
        Assert.That(Diary.Lines, Is.Empty);

        sleeping.SetActive(true);
        Assert.That(sleeping.GetComponent<Reader>().seen, Is.EqualTo(7));
        Assert.That(Diary.Lines, Is.EqualTo(new[]
        {
            "child.Awake", "child.OnEnable", "root(Clone).Awake", "root(Clone).OnEnable",
        }));
    }

    [Test]
    public void ACopy_StandsWhereItIsPut()
    {
        Transform parent = new GameObject("parent").transform;
        parent.position = new Vector3(1f, 0f, 0f);
        var original = new GameObject("a");
        original.transform.position = new Vector3(0f, 5f, 0f);

        Assert.That(Object.Instantiate(original, parent).transform.position, Is.EqualTo(new Vector3(1f, 5f, 0f)));
        Assert.That(Object.Instantiate(original, parent, true).transform.position, Is.EqualTo(new Vector3(0f, 5f, 0f)));
        GameObject placed = Object.Instantiate(original, new Vector3(2f, 2f, 2f), Quaternion.identity, parent);
        Assert.That(placed.transform.position, Is.EqualTo(new Vector3(2f, 2f, 2f)));
    }

    [Test]
    public void AMesh_IsCopiedWhole()
    {
        Mesh mesh = Meshes.Square();
        Mesh copy = Object.Instantiate(mesh);
        copy.vertices = Array.ConvertAll(copy.vertices, v => v * 2f);

        Assert.That(mesh.vertices[2], Is.EqualTo(new Vector3(1f, 1f, 0f)));
        Assert.That(copy.triangles, Is.EqualTo(mesh.triangles));
        Object.DestroyImmediate(mesh);
        Object.DestroyImmediate(copy);
    }

    [Test]
    public void EngineComponents_AreCopiedWithTheirState()
    {
        var original = new GameObject("a", typeof(MeshFilter), typeof(MeshRenderer), typeof(Camera), typeof(Rigidbody));
        Mesh mesh = Meshes.Square();
        original.GetComponent<MeshFilter>().sharedMesh = mesh;
        original.GetComponent<MeshRenderer>().enabled = false;
        original.GetComponent<Camera>().fieldOfView = 33f;
        original.GetComponent<Rigidbody>().mass = 3f;

        GameObject copy = Object.Instantiate(original);

        Assert.That(copy.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(mesh));
        Assert.That(copy.GetComponent<MeshRenderer>().enabled, Is.False);
        Assert.That(copy.GetComponent<Camera>().fieldOfView, Is.EqualTo(33f));
        Assert.That(copy.GetComponent<Rigidbody>().mass, Is.EqualTo(3f));
        Object.DestroyImmediate(mesh);
    }

    public sealed class Bag : MonoBehaviour
    {
        public int number;
        public string text;
        public List<Vector3> list;
        public Part part;
        public Color colour;
        public Transform target;
        public GameObject[] objects;
        public Dictionary<string, int> table;

        [NonSerialized]
        public int unsaved;

        [SerializeField]
        private float m_Hidden;

        public float Hidden => m_Hidden;

        public void Fill()
        {
            (number, m_Hidden, unsaved) = (3, 4f, 5);
            list = new List<Vector3> { Vector3.one };
            part = new Part { values = new[] { 1f, 2f } };
            colour = Color.red;
            table = new Dictionary<string, int>();
        }
    }

    [Serializable]
    public sealed class Part
    {
        public float[] values;
    }

    private sealed class Reader : MonoBehaviour
    {
        public int value;

        [NonSerialized]
        public int seen;

        private void Awake() => seen = value;
    }
}
