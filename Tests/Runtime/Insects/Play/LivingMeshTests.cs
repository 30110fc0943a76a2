using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>The mesh that is shown while the wings live is the authored one, but for the wings that move in it.</summary>
    public sealed class LivingMeshTests : FlockFixture
    {
        private const int k_BodyVertices = 4;

        /// <summary>Half a step of each of three signed bytes.</summary>
        private const float k_Byte = 0.5f * 1.7321f / 127f;

        // A wing that is stretched by a tenth, pointing anywhere.
        [UnityTest]
        public IEnumerator TheBounds_HoldAllPlacesThatAWingCanReach()
        {
            InsectWings insect = Keep(InsectFactory.Create("swallowtail").gameObject).GetComponent<InsectWings>();
            yield return Frames(3);
            foreach (LiveMesh mesh in insect.Live.meshes)
            {
                Vector3[] rest = mesh.template.Source.vertices;
                Mesh copy = Keep(mesh.template.CreateCopy(moves: false));
                Bounds bounds = copy.bounds;
                foreach (RiggedPart shape in mesh.template.Shapes)
                {
                    Vector3 hinge = shape.Rig.Frame.origin;
                    float reach = 1.1f * shape.Selection.vertices.Max(vertex => Vector3.Distance(hinge, rest[vertex]));
                    for (int axis = 0; axis < 3; axis++)
                    {
                        Assert.That(bounds.max[axis], Is.GreaterThanOrEqualTo(hinge[axis] + 0.9999f * reach));
                        Assert.That(bounds.min[axis], Is.LessThanOrEqualTo(hinge[axis] - 0.9999f * reach));
                    }
                }
            }
        }

        [UnityTest]
        public IEnumerator InAMeshOfBodyAndWings_OnlyTheWingsMove([Values(WingPart.Submesh, WingPart.ConnectedPart)] WingPart part)
        {
            Mesh whole = Keep(Insect(IndexFormat.UInt16));
            InsectWings insect = Hatch(made => Compose(made, whole, part));
            yield return Frames(20);
            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);

            Mesh shown = Shown(insect, 0);
            Assert.That(Shown(insect, 1), Is.SameAs(shown));
            Vector2[] source = shown.uv;
            Vector3[] rest = whole.vertices, now = shown.vertices;
            float moved = 0f;
            for (int v = 0; v < now.Length; v++)
            {
                int authored = Mathf.RoundToInt(source[v].x);
                float move = (now[v] - rest[authored]).magnitude;
                if (authored < k_BodyVertices)
                    Assert.That(move, Is.Zero, "the body moved");
                moved = Mathf.Max(moved, move);
            }

            Assert.That(moved, Is.GreaterThan(0.1f));
            insect.enabled = false;
            Assert.That(Shown(insect, 0), Is.SameAs(whole));
        }

        [UnityTest]
        public IEnumerator BothWingsOfOneMesh_AreMirrorImages()
        {
            Mesh whole = Keep(Insect(IndexFormat.UInt16));
            InsectWings insect = Hatch(made => Compose(made, whole, WingPart.Submesh));
            yield return Frames(30);

            for (int joint = 0; joint < 5; joint++)
            {
                Vector3 right = insect.JointPosition(0, 2, joint), left = insect.JointPosition(1, 2, joint);
                Assert.That((Vector3.Scale(left, new Vector3(-1f, 1f, 1f)) - right).magnitude, Is.LessThan(1e-4f));
            }
        }

        [UnityTest]
        public IEnumerator EverythingElseOfTheMesh_IsThatOfTheAuthoredOne(
            [Values(IndexFormat.UInt16, IndexFormat.UInt32)] IndexFormat format)
        {
            Mesh whole = Keep(Insect(format));
            InsectWings insect = Hatch(made => Compose(made, whole, WingPart.Submesh));
            yield return Frames(3);

            Mesh shown = Shown(insect, 0);
            Vector2[] uv = shown.uv;
            int[] authored = System.Array.ConvertAll(uv, t => Mathf.RoundToInt(t.x));
            Assert.That(shown.vertexCount, Is.EqualTo(whole.vertexCount));
            Assert.That(shown.indexFormat, Is.EqualTo(format));
            Assert.That(shown.subMeshCount, Is.EqualTo(3));
            for (int submesh = 0; submesh < 3; submesh++)
                Assert.That(System.Array.ConvertAll(shown.GetIndices(submesh), v => authored[v]), Is.EqualTo(whole.GetIndices(submesh)));

            Color32[] colours = whole.colors32, shownColours = shown.colors32;
            var second = new List<Vector4>();
            var shownSecond = new List<Vector4>();
            whole.GetUVs(3, second);
            shown.GetUVs(3, shownSecond);
            for (int v = 0; v < authored.Length; v++)
            {
                Assert.That(shownColours[v], Is.EqualTo(colours[authored[v]]));
                Assert.That(shownSecond[v], Is.EqualTo(second[authored[v]]));
            }
        }

        [UnityTest]
        public IEnumerator NormalsAndTangents_TurnWithTheWing_AndStayUnit()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.tangents = System.Array.ConvertAll(mesh.vertices, _ => new Vector4(1f, 0f, 0f, -1f));
            InsectWings insect = Hatch(made => Filter(made, 0).sharedMesh = mesh);
            yield return Frames(23);

            Vector3[] normals = Shown(insect, 0).normals;
            Vector4[] tangents = Shown(insect, 0).tangents;
            float turned = 0f;
            for (int v = 0; v < normals.Length; v++)
            {
                var tangent = (Vector3)tangents[v];
                Assert.That(normals[v].magnitude, Is.EqualTo(1f).Within(k_Byte));
                Assert.That(tangent.magnitude, Is.EqualTo(1f).Within(k_Byte));
                // Each is off by as much; which pose is seen depends on where the frame falls between two steps.
                Assert.That(Vector3.Dot(normals[v], tangent), Is.EqualTo(0f).Within(2f * k_Byte));
                Assert.That(tangents[v].w, Is.EqualTo(-1f));
                turned = Mathf.Max(turned, Vector3.Angle(normals[v], Vector3.up));
            }

            Assert.That(turned, Is.GreaterThan(3f));
        }

        [UnityTest]
        public IEnumerator AMeshWithoutNormalsOrTextureCoordinates_Lives()
        {
            Mesh mesh = Keep(new Mesh { name = "plain" });
            mesh.vertices = WingMesh.vertices;
            mesh.triangles = WingMesh.triangles;
            InsectWings insect = Hatch(made => Filter(made, 0).sharedMesh = mesh);
            yield return Frames(10);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready), insect.Problem.Message);
            foreach (Vector3 normal in Shown(insect, 0).normals)
                Assert.That(normal.magnitude, Is.EqualTo(1f).Within(k_Byte));
        }

        [UnityTest]
        public IEnumerator Tangents_AreLeftAtRest_WhereNoMaterialReadsThem([Values] bool normalMap)
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.tangents = System.Array.ConvertAll(mesh.vertices, _ => new Vector4(1f, 0f, 0f, -1f));
            var material = new Material(Shader.Find("Standard"));
            if (normalMap)
                material.EnableKeyword("_NORMALMAP");
            InsectWings insect = Hatch(made =>
            {
                Filter(made, 0).sharedMesh = mesh;
                Filter(made, 0).GetComponent<MeshRenderer>().sharedMaterial = material;
            });
            yield return Frames(23);

            float turned = 0f;
            foreach (Vector4 tangent in Shown(insect, 0).tangents)
                turned = Mathf.Max(turned, Vector3.Angle(tangent, Vector3.right));
            Object.DestroyImmediate(material);
            Assert.That(turned, normalMap ? Is.GreaterThan(3f) : Is.Zero);
        }

        [UnityTest]
        public IEnumerator TheLivingMesh_IsNeverSaved_AndTheAuthoredOneNeverTouched()
        {
            Vector3[] before = WingMesh.vertices;
            Bounds bounds = WingMesh.bounds;
            InsectWings insect = Hatch();
            yield return Frames(20);

            Assert.That(Shown(insect, 0).hideFlags & HideFlags.DontSave, Is.EqualTo(HideFlags.DontSave));
            Assert.That(WingMesh.vertices, Is.EqualTo(before));
            Assert.That(WingMesh.bounds, Is.EqualTo(bounds));
        }

        // A square body, then a right and a left wing; the texture coordinates number the vertices.
        private static Mesh Insect(IndexFormat format)
        {
            SurfaceMesh wing = TestWings.Ellipse();
            int count = wing.positions.Length;
            var positions = new List<Vector3> { new Vector3(-0.1f, 0f, -1f), new Vector3(-0.1f, 0f, 0.5f), new Vector3(0.1f, 0f, 0.5f),
                new Vector3(0.1f, 0f, -1f) };
            positions.AddRange(System.Array.ConvertAll(wing.positions, p => p + new Vector3(0.2f, 0.1f, 0f)));
            positions.AddRange(System.Array.ConvertAll(wing.positions, p => new Vector3(-p.x - 0.2f, p.y + 0.1f, p.z)));
            var mesh = new Mesh { name = "whole insect", indexFormat = format };
            mesh.SetVertices(positions);
            mesh.subMeshCount = 3;
            mesh.SetTriangles(new[] { 0, 1, 2, 0, 2, 3 }, 1);
            mesh.SetTriangles(System.Array.ConvertAll(wing.triangles, v => v + k_BodyVertices), 0);
            int[] left = System.Array.ConvertAll(wing.triangles, v => v + k_BodyVertices + count);
            System.Array.Reverse(left);
            mesh.SetTriangles(left, 2);
            mesh.SetNormals(positions.ConvertAll(_ => Vector3.up));
            var numbers = new Vector2[positions.Count];
            for (int v = 0; v < numbers.Length; v++)
                numbers[v] = new Vector2(v, 0.5f);
            mesh.uv = numbers;
            mesh.SetUVs(3, positions.ConvertAll(p => new Vector2(p.z, p.x)));
            mesh.colors32 = positions.ConvertAll(p => new Color32((byte)(100f + 50f * p.x), (byte)(100f + 50f * p.z), 7, 200)).ToArray();
            return mesh;
        }

        private void Compose(InsectWings insect, Mesh whole, WingPart part)
        {
            Wing right = insect.Wings[0], left = insect.Wings[1];
            left.Renderer.gameObject.SetActive(false);
            Filter(insect, 0).sharedMesh = whole;
            left.Renderer = right.Renderer;
            right.Part = left.Part = part;
            left.Submesh = 2;
            right.Point = new Vector3(0.7f, 0.1f, -0.2f);
            left.Point = new Vector3(-0.7f, 0.1f, -0.2f);
            right.Skeleton = Moved(1f);
            left.Skeleton = Moved(-1f);
        }

        private WingSkeleton Moved(float side)
        {
            WingSkeleton skeleton = Keep(TestWings.Fan());
            Vector3 Move(Vector3 joint) => new Vector3(side * (joint.x + 0.2f), joint.y + 0.1f, joint.z);
            skeleton.Hinge = Move(skeleton.Hinge);
            skeleton.SpanAxis = side * Vector3.right;
            skeleton.Chains = System.Array.ConvertAll(
                skeleton.Chains, chain => new JointChain(System.Array.ConvertAll(chain.joints, Move)));
            return skeleton;
        }
    }
}
