using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Renderers whose materials may read tangents.</summary>
    public sealed class MaterialTangentsLaws
    {
        private GameObject m_Holder;
        private MeshRenderer m_Renderer;

        [SetUp]
        public void MakeARenderer()
        {
            m_Holder = new GameObject("drawn");
            m_Renderer = m_Holder.AddComponent<MeshRenderer>();
        }

        [TearDown]
        public void EndIt()
        {
            foreach (Material material in m_Renderer.sharedMaterials)
                Object.DestroyImmediate(material);
            Object.DestroyImmediate(m_Holder);
        }

        [TestCase("Standard", null, false)]
        [TestCase("Standard", "_ALPHATEST_ON", false)]
        [TestCase("Standard", "_NORMALMAP", true)]
        [TestCase("Standard", "_PARALLAXMAP", true)]
        [TestCase("Standard", "_DETAIL_MULX2", true)]
        [TestCase("Standard", "_DETAIL_SCALED", true)]
        public void OfAShaderThatIsKnown_KeywordsTell(string shader, string keyword, bool areRead)
        {
            m_Renderer.sharedMaterials = new[] { Made(shader, keyword) };
            Assert.That(MaterialTangents.AreRead(m_Renderer), Is.EqualTo(areRead));
            m_Renderer.sharedMaterials = new[] { m_Renderer.sharedMaterial, Made(shader, null) };
            Assert.That(MaterialTangents.AreRead(m_Renderer), Is.EqualTo(areRead), "one of two");
        }

        [Test]
        public void WithoutAMaterial_OrWithAStrangersShader_TangentsMayBeRead()
        {
            m_Renderer.sharedMaterials = new Material[0];
            Assert.That(MaterialTangents.AreRead(m_Renderer));
            m_Renderer.sharedMaterials = new Material[] { null };
            Assert.That(MaterialTangents.AreRead(m_Renderer));
            m_Renderer.sharedMaterials = new[] { Made("Hidden/Internal-Colored", null) };
            Assert.That(MaterialTangents.AreRead(m_Renderer));
        }

        private static Material Made(string shader, string keyword)
        {
            var material = new Material(Shader.Find(shader));
            if (keyword != null)
                material.EnableKeyword(keyword);
            return material;
        }
    }
}
