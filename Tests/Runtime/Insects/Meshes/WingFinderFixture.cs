using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>An insect without wings yet, and how what is found on it is told.</summary>
    public abstract class WingFinderFixture
    {
        protected static readonly Vector3 s_Fore = new Vector3(0.1f, 0.1f, 0.25f);
        protected static readonly Vector3 s_Hind = new Vector3(0.1f, 0.05f, -0.15f);

        protected InsectSketch m_Insect;

        [SetUp]
        public void MakeAnInsect() => m_Insect = new InsectSketch();

        [TearDown]
        public void EndIt() => m_Insect.Dispose();

        protected void AssertFound(params string[] wings)
        {
            List<string> found = WingFinder.Find(m_Insect.Root).ConvertAll(wing =>
                $"{wing.Renderer.name} {wing.Pair} {wing.Side} {wing.Part}" + (wing.Part == WingPart.Submesh ? $" {wing.Submesh}" : ""));
            Assert.That(found, Is.EqualTo(wings));
        }

        protected void AssertThePointsTellTheParts() => AssertThePointsTellTheParts(WingFinder.Find(m_Insect.Root));

        // All vertices of a part are on the side and in the pair that the wing is said to be.
        protected void AssertThePointsTellTheParts(List<Wing> wings)
        {
            foreach (Wing wing in wings)
            {
                Mesh mesh = wing.Renderer.GetComponent<MeshFilter>().sharedMesh;
                SurfaceMesh surface = MeshParts.Surface(mesh, MeshParts.Select(mesh, wing.Part, wing.Submesh, wing.Point));
                Vector3 hinge = wing.Pair == WingPair.Fore ? s_Fore : s_Hind;
                Assert.That(surface.triangles, Has.Length.EqualTo(6 * 24));
                Assert.That(surface.positions.Max(p => p.z), Is.EqualTo(hinge.z).Within(1e-5f));
                foreach (Vector3 p in surface.positions)
                    Assert.That(wing.Side == WingSide.Right ? p.x : -p.x, Is.GreaterThan(hinge.x - 1e-5f));
            }
        }

        protected static MeshSketch Wing(float side, Vector3 hinge, float length) =>
            new MeshSketch().Wing(Side(hinge, side), length * side, 0.4f);

        protected static Vector3 Side(Vector3 hinge, float side) => Vector3.Scale(hinge, new Vector3(side, 1f, 1f));

        protected static Vector3 Mirror(Vector3 hinge) => Side(hinge, -1f);
    }
}
