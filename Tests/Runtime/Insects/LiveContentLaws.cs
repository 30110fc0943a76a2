using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Content that living insects share: when it is the same, and the mesh of which each has a copy.</summary>
    public sealed class LiveContentLaws
    {
        private readonly List<Object> m_Made = new List<Object>();

        [TearDown]
        public void EndAll()
        {
            m_Made.ForEach(Object.DestroyImmediate);
            m_Made.Clear();
        }

        // Submesh and point count only for the part that they name.
        [Test]
        public void AWing_IsTheOneThatWasBuilt_WhileWhatMattersOfItIsTheSame([Values] WingPart part)
        {
            WingSkeleton skeleton = Keep(TestWings.Fan()), other = Keep(TestWings.Fan());
            var key = new TemplateKey.WingKey(Made(), 7u);
            Assert.That(key.Describes(Made(), 7u));
            Assert.That(key.Describes(Made(), 8u), Is.False, "the skeleton was edited");
            Assert.That(key.Equals(new TemplateKey.WingKey(Made(), 8u)), Is.False);
            Assert.That(Describes(wing => wing.Submesh = 3), Is.EqualTo(part != WingPart.Submesh));
            Assert.That(Describes(wing => wing.Point = Vector3.up), Is.EqualTo(part != WingPart.ConnectedPart));
            Assert.That(Describes(wing => wing.Skeleton = other), Is.False);
            Assert.That(Describes(wing => wing.Skeleton = null), Is.False);
            foreach (WingPart changed in Enum.GetValues(typeof(WingPart)))
                Assert.That(Describes(wing => wing.Part = changed), Is.EqualTo(changed == part));
            Assert.That(Describes(wing => (wing.Side, wing.PhaseLead, wing.AmplitudeScale) = (WingSide.Left, 5f, 0.5f)));
            Assert.That(key.IsAutomatic, Is.False);

            Wing none = Made();
            none.Skeleton = null;
            var automatic = new TemplateKey.WingKey(none, 7u);
            Assert.That(automatic.IsAutomatic && automatic.Describes(none, 7u));
            Assert.That(automatic.Describes(Made(), 7u), Is.False);

            bool Describes(Action<Wing> change)
            {
                Wing wing = Made();
                change(wing);
                Assert.That(key.Equals(new TemplateKey.WingKey(wing, 7u)), Is.EqualTo(key.Describes(wing, 7u)));
                return key.Describes(wing, 7u);
            }

            Wing Made() => new Wing { Part = part, Submesh = 2, Point = Vector3.right, Skeleton = skeleton };
        }

        [Test]
        public void InsectsShareATemplate_OfOneMesh_ItsPatches_AndItsWings()
        {
            WingSkeleton skeleton = Keep(TestWings.Fan());
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse())), another = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            GameObject here = Keep(new GameObject("here")), aside = Keep(new GameObject("aside"));
            aside.transform.position = Vector3.one;
            var place = new AutomaticSkeleton(here.transform, here.transform);
            var away = new AutomaticSkeleton(here.transform, aside.transform);
            TemplateKey.WingKey laid = Key(skeleton, 1), automatic = Key(null, 1), second = Key(skeleton, 2);
            var key = new TemplateKey(mesh, 64, true, new[] { laid, second }, place);

            Assert.That(key.Matches(new TemplateKey(mesh, 64, true, new[] { laid, second }, place)));
            Assert.That(key.Matches(new TemplateKey(mesh, 64, true, new[] { laid, second }, away)), "laid out by hand");
            Assert.That(key.Matches(new TemplateKey(another, 64, true, new[] { laid, second }, place)), Is.False);
            Assert.That(key.Matches(new TemplateKey(mesh, 65, true, new[] { laid, second }, place)), Is.False);
            Assert.That(key.Matches(new TemplateKey(mesh, 64, false, new[] { laid, second }, place)), Is.False);
            Assert.That(key.Matches(new TemplateKey(mesh, 64, true, new[] { laid }, place)), Is.False);
            Assert.That(new TemplateKey(mesh, 64, true, new[] { laid }, place).Matches(key), Is.False);
            Assert.That(key.Matches(new TemplateKey(mesh, 64, true, new[] { second, laid }, place)), Is.False);
            Assert.That(key.Matches(new TemplateKey(mesh, 64, true, new[] { laid, laid }, place)), Is.False);
            var free = new TemplateKey(mesh, 64, true, new[] { laid, automatic }, place);
            Assert.That(free.Matches(new TemplateKey(mesh, 64, true, new[] { laid, automatic }, place)));
            Assert.That(
                free.Matches(new TemplateKey(mesh, 64, true, new[] { laid, automatic }, away)), Is.False, "one is laid out by its place");
        }

        // Whatever the vertices are called by, a corner has the same place, direction, colour and coordinates.
        [Test]
        public void ALivingMesh_HasItsSourcesVertices_InAnotherOrder([Values] bool packed, [Values] bool tangents, [Values] bool bytes)
        {
            Mesh source = Keep(TestWings.ToMesh(TestWings.Ellipse(5, 3)));
            int count = source.vertexCount;
            source.normals = Array.ConvertAll(source.vertices, p => new Vector3(p.x, 1f, p.z).normalized);
            if (tangents)
                source.tangents = Array.ConvertAll(source.vertices, p => Tangent(new Vector3(1f, -p.x, p.z).normalized, p.x > 0.5f));
            if (bytes)
                source.colors32 = Array.ConvertAll(source.vertices, p => (Color32)new Color(p.x, -p.z, 0.3f, 0.6f));
            else
                source.colors = Array.ConvertAll(source.vertices, p => new Color(p.x, -p.z, 3f, 0.6f));
            source.SetUVs(0, Array.ConvertAll(source.vertices, p => new Vector2(p.z, p.x)));
            source.SetUVs(2, Array.ConvertAll(source.vertices, p => new Vector3(p.z, p.x, 4f)));
            source.SetUVs(7, Array.ConvertAll(source.vertices, p => new Vector4(p.z, p.x, 4f, -p.x)));
            source.bounds = new Bounds(Vector3.one, 7f * Vector3.one);
            int[] order = Enumerable.Range(0, count).Select(place => (7 * place + 3) % count).ToArray();
            Assert.That(order.Distinct().Count(), Is.EqualTo(count));

            Mesh made = Keep(DeformableMesh.Build(source, order, packed, moves: false));

            Assert.That((made.name, made.bounds), Is.EqualTo((source.name + " (living)", source.bounds)));
            Assert.That(made.vertices, Is.EqualTo(Ordered(source.vertices)));
            Assert.That(Array.ConvertAll(made.triangles, place => order[place]), Is.EqualTo(source.triangles));
            float near = packed ? 0.02f : 0f;
            Assert.That(made.normals.Zip(Ordered(source.normals), Vector3.Distance), Is.All.LessThanOrEqualTo(near));
            Assert.That(made.tangents.Zip(Ordered(source.tangents), (a, b) => (a - b).magnitude).ToArray(),
                Has.Length.EqualTo(tangents ? count : 0).And.All.LessThanOrEqualTo(near));
            Assert.That(made.GetVertexAttributeFormat(VertexAttribute.Normal),
                Is.EqualTo(packed ? VertexAttributeFormat.SNorm8 : VertexAttributeFormat.Float32));
            Assert.That(made.GetVertexAttributeFormat(VertexAttribute.Color),
                Is.EqualTo(bytes ? VertexAttributeFormat.UNorm8 : VertexAttributeFormat.Float32));
            Assert.That(made.colors, Is.EqualTo(Ordered(source.colors)));
            for (int channel = 0; channel < 8; channel++)
            {
                VertexAttribute attribute = VertexAttribute.TexCoord0 + channel;
                Assert.That(made.HasVertexAttribute(attribute), Is.EqualTo(source.HasVertexAttribute(attribute)));
                Assert.That(made.GetVertexAttributeDimension(attribute), Is.EqualTo(source.GetVertexAttributeDimension(attribute)));
                Assert.That(Coordinates(made, channel), Is.EqualTo(Ordered(Coordinates(source, channel))));
            }

            T[] Ordered<T>(T[] all) => all.Length == 0 ? all : Array.ConvertAll(order, vertex => all[vertex]);
        }

        [Test]
        public void AMeshWithoutNormals_HasNoneInItsCopies([Values] bool packed)
        {
            Vector3[] corners = { Vector3.zero, Vector3.right, Vector3.forward };
            Mesh source = Keep(new Mesh { vertices = corners, triangles = new[] { 0, 1, 2 } });
            Mesh made = Keep(DeformableMesh.Build(source, new[] { 2, 0, 1 }, packed, moves: false));
            Assert.That(made.normals, Is.All.EqualTo(Vector3.zero));
        }

        [TestCase(65535, IndexFormat.UInt16)]
        [TestCase(65536, IndexFormat.UInt32)]
        public void AMeshOfMoreVerticesThanSixteenBitsCount_HasLongIndices(int count, IndexFormat format)
        {
            Mesh source = Keep(new Mesh { vertices = new Vector3[count], triangles = new[] { 0, 1, 2 } });
            Mesh made = Keep(DeformableMesh.Build(source, Enumerable.Range(0, count).ToArray(), true, moves: false));
            Assert.That((made.indexFormat, made.vertexCount), Is.EqualTo((format, count)));
        }

        private static TemplateKey.WingKey Key(WingSkeleton skeleton, int submesh) =>
            new TemplateKey.WingKey(new Wing { Part = WingPart.Submesh, Submesh = submesh, Skeleton = skeleton }, 7u);

        private static Vector4 Tangent(Vector3 along, bool isRight) => new Vector4(along.x, along.y, along.z, isRight ? 1f : -1f);

        private static Vector4[] Coordinates(Mesh mesh, int channel)
        {
            var all = new List<Vector4>();
            mesh.GetUVs(channel, all);
            return all.ToArray();
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }
    }
}
