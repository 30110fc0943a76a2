using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Meshes cut out of skinned ones: blend shapes between frames, settings of a renderer, shares of bones.</summary>
    public sealed class SkinnedCutLaws : SkinnedWingFixture
    {
        // Frames at 20, 50 and 100 move by 1, 4 and 7: from nothing up to the first, between two a mixture, behind the last the last.
        [TestCase(0f, 0f)]
        [TestCase(10f, 0.5f)]
        [TestCase(20f, 1f)]
        [TestCase(30f, 2f)]
        [TestCase(50f, 4f)]
        [TestCase(60f, 4.6f)]
        [TestCase(100f, 7f)]
        [TestCase(150f, 7f)]
        [TestCase(-10f, -0.5f)]
        public void BetweenFramesOfABlendShape_DifferencesAreMixed(float weight, float share)
        {
            SkinnedMeshRenderer source = m_Insect.Skin("Wing", Wing(1f), p => SkinnedSketch.One(0));
            Mesh mesh = source.sharedMesh;
            (Vector3[] positions, Vector3[] normals, Vector4[] tangents) = (mesh.vertices, mesh.normals, mesh.tangents);
            foreach ((float at, float size) in new[] { (20f, 1f), (50f, 4f), (100f, 7f) })
            {
                mesh.AddBlendShapeFrame(
                    "bend", at, All(mesh, size * Vector3.up), All(mesh, size * Vector3.right), All(mesh, size * Vector3.back));
            }

            mesh.AddBlendShapeFrame("at once", 0f, All(mesh, Vector3.forward), null, null);
            mesh.AddBlendShapeFrame("other", 100f, All(mesh, 2f * Vector3.forward), null, null);
            source.SetBlendShapeWeight(0, weight);
            source.SetBlendShapeWeight(1, 5f);
            source.SetBlendShapeWeight(2, 25f);

            var shape = new BlendedShape(mesh, source);

            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                Near(shape.positions[vertex], positions[vertex] + share * Vector3.up + 1.5f * Vector3.forward);
                Near(shape.normals[vertex], normals[vertex] + share * Vector3.right);
                Near(shape.tangents[vertex], (Vector3)tangents[vertex] + share * Vector3.back);
                Assert.That(shape.tangents[vertex].w, Is.EqualTo(tangents[vertex].w));
            }

            mesh.normals = null;
            mesh.tangents = null;
            shape = new BlendedShape(mesh, source);
            Assert.That((shape.normals.Length, shape.tangents.Length), Is.EqualTo((0, 0)));
            Mesh cut = WingMeshCut.Cut(mesh, shape, new[] { mesh.triangles }, Matrix4x4.identity);
            Assert.That((cut.normals.Length, cut.tangents.Length, cut.vertexCount), Is.EqualTo((0, 0, positions.Length)));
            Object.DestroyImmediate(cut);
        }

        [Test]
        public void AllThatARendererIsSetTo_IsCopied([Values] bool first)
        {
            Renderer from = m_Insect.Skin("from", Wing(1f), p => SkinnedSketch.One(0));
            var holder = new GameObject("to");
            holder.transform.SetParent(m_Insect.Root);
            Renderer to = holder.AddComponent<MeshRenderer>();
            from.gameObject.layer = first ? 3 : 0;
            from.gameObject.tag = first ? "EditorOnly" : "Untagged";
            from.enabled = first;
            from.forceRenderingOff = first;
            from.shadowCastingMode = first ? ShadowCastingMode.Off : ShadowCastingMode.ShadowsOnly;
            from.receiveShadows = !first;
            from.lightProbeUsage = first ? LightProbeUsage.UseProxyVolume : LightProbeUsage.Off;
            from.lightProbeProxyVolumeOverride = first ? m_Insect.Root.gameObject : null;
            from.reflectionProbeUsage = first ? ReflectionProbeUsage.Off : ReflectionProbeUsage.Simple;
            from.probeAnchor = first ? m_Insect.Root : null;
            from.motionVectorGenerationMode = first ? MotionVectorGenerationMode.ForceNoMotion : MotionVectorGenerationMode.Camera;
            from.allowOcclusionWhenDynamic = !first;
            from.renderingLayerMask = first ? 5u : 6u;
            from.rendererPriority = first ? 7 : 0;
            from.sortingLayerID = first ? 8 : 0;
            from.sortingOrder = first ? 9 : 0;

            RendererSettings.Copy(from, to);

            Assert.That(Settings(to), Is.EqualTo(Settings(from)));
            Assert.That(to.HasPropertyBlock(), Is.False);
        }

        private static object[] Settings(Renderer renderer) => new object[]
        {
            renderer.gameObject.layer, renderer.gameObject.tag, renderer.enabled, renderer.forceRenderingOff, renderer.shadowCastingMode,
            renderer.receiveShadows, renderer.lightProbeUsage, renderer.lightProbeProxyVolumeOverride, renderer.reflectionProbeUsage,
            renderer.probeAnchor, renderer.motionVectorGenerationMode, renderer.allowOcclusionWhenDynamic, renderer.renderingLayerMask,
            renderer.rendererPriority, renderer.sortingLayerID, renderer.sortingOrder,
        };

        // Of 50 rows with 6 corners a column, the last h rows of vertices have 6 h − 3: 57 of 300 are below a fifth, 63 above.
        [TestCase(10, "Wing Right: forewing_r")]
        [TestCase(11, "Fore Wing Right: forewing_r, Hind Wing Right: hindwing_r")]
        [TestCase(40, "Fore Wing Right: forewing_r, Hind Wing Right: hindwing_r")]
        [TestCase(41, "Wing Right: hindwing_r")]
        public void AConnectedPart_IsTwoWings_WhereEitherPairOfBonesHasAFifthOfIt(int hindRows, string wings)
        {
            using (var insect = new SkinnedSketch())
            {
                insect.Bone("forewing_r");
                insect.Bone("hindwing_r");
                MeshSketch sheet = new MeshSketch().Sheet(new Vector3(0.1f, 0f, 0f), Vector3.right, 0.5f * Vector3.back, 2, 50);
                SkinnedMeshRenderer source = insect.Skin(
                    "Wings", sheet, p => SkinnedSketch.One(p.z < -0.5f * (50.5f - hindRows) / 50f ? 1 : 0));

                m_Result = SkinnedWingConversion.Convert(source, insect.Root);

                IEnumerable<string> found = m_Result.Wings.Select(wing => $"{wing.name}: {wing.transform.parent.name}");
                Assert.That(string.Join(", ", found), Is.EqualTo(wings));
                Assert.That(TriangleCount(), Is.EqualTo(600));
            }
        }

        // Colours of 32 bits, of four floats, and none; texture coordinates in each of the eight places, with two numbers to four.
        [TestCase(2)]
        [TestCase(3)]
        [TestCase(4)]
        public void ACutMesh_HasWhatItsVerticesHad(int numbers)
        {
            SkinnedMeshRenderer source = m_Insect.Skin("Wing", Wings(), p => SkinnedSketch.One(0));
            Mesh mesh = source.sharedMesh;
            if (numbers == 3)
                mesh.colors = Array.ConvertAll(mesh.vertices, p => new Color(p.x, 3f * p.y, -p.z, 0.3f));
            for (int channel = 0; channel < 8; channel++)
                Write(mesh, channel, numbers, Array.ConvertAll(mesh.vertices, p => new Vector4(p.x + channel, p.z, p.y, 1f + p.z)));
            int[] corners = mesh.triangles.Skip(mesh.triangles.Length / 2).ToArray();
            int[] kept = corners.Distinct().OrderBy(vertex => vertex).ToArray();
            var matrix = Matrix4x4.TRS(Vector3.up, Quaternion.Euler(0f, 90f, 0f), 2f * Vector3.one);

            Mesh cut = WingMeshCut.Cut(mesh, new BlendedShape(mesh, source), new[] { new int[0], corners }, matrix);

            Vector3[] places = Array.ConvertAll(kept, vertex => matrix.MultiplyPoint3x4(mesh.vertices[vertex]));
            Assert.That(cut.vertices, Is.EqualTo(places));
            Assert.That(cut.subMeshCount, Is.EqualTo(2));
            Assert.That(cut.GetTriangles(0), Is.Empty);
            Assert.That(Array.ConvertAll(cut.GetTriangles(1), vertex => kept[vertex]), Is.EqualTo(corners));
            Near(cut.bounds.min, places.Aggregate(Vector3.Min));
            Near(cut.bounds.max, places.Aggregate(Vector3.Max));
            Assert.That(cut.HasVertexAttribute(VertexAttribute.Color), Is.EqualTo(numbers == 3));
            if (numbers == 3)
                Assert.That(cut.colors, Is.EqualTo(Array.ConvertAll(kept, vertex => mesh.colors[vertex])));
            for (int channel = 0; channel < 8; channel++)
            {
                Assert.That(cut.GetVertexAttributeDimension(VertexAttribute.TexCoord0 + channel), Is.EqualTo(numbers));
                List<Vector4> before = Read(mesh, channel), after = Read(cut, channel);
                Assert.That(after, Is.EqualTo(kept.Select(vertex => before[vertex])));
            }

            Object.DestroyImmediate(cut);
        }

        private static void Write(Mesh mesh, int channel, int numbers, Vector4[] values)
        {
            if (numbers == 4)
                mesh.SetUVs(channel, values);
            else if (numbers == 3)
                mesh.SetUVs(channel, Array.ConvertAll(values, value => (Vector3)value));
            else
                mesh.SetUVs(channel, Array.ConvertAll(values, value => (Vector2)value));
        }

        private static List<Vector4> Read(Mesh mesh, int channel)
        {
            var all = new List<Vector4>();
            mesh.GetUVs(channel, all);
            return all;
        }

        private static Vector3[] All(Mesh mesh, Vector3 move) => Array.ConvertAll(mesh.vertices, _ => move);

        private static void Near(Vector3 found, Vector3 wanted) => Assert.That((found - wanted).magnitude, Is.LessThan(1e-5f));
    }
}
