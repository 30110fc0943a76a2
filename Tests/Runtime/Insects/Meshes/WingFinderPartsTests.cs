using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingFinderPartsTests : WingFinderFixture
    {
        [TestCase(false)]
        [TestCase(true)]
        public void OneMeshWithBothWings_IsTwoConnectedParts(bool split)
        {
            MeshSketch sketch = new MeshSketch().Wing(s_Fore, 1f, 0.5f).Wing(Mirror(s_Fore), -1f, 0.5f);
            m_Insect.Draw("Wings", split ? sketch.Split() : sketch);

            AssertFound("Wings Fore Right ConnectedPart", "Wings Fore Left ConnectedPart");
            AssertThePointsTellTheParts();
        }

        [Test]
        public void FourWingsInOneMeshWithTheBody_AreFoundByTheirShape()
        {
            MeshSketch sketch = m_Insect.Body();
            foreach (float side in new[] { -1f, 1f })
                sketch.Wing(Side(s_Hind, side), 0.8f * side, 0.4f).Wing(Side(s_Fore, side), side, 0.35f);
            m_Insect.Draw("Insect", sketch);

            AssertFound(
                "Insect Fore Right ConnectedPart", "Insect Fore Left ConnectedPart",
                "Insect Hind Right ConnectedPart", "Insect Hind Left ConnectedPart");
            AssertThePointsTellTheParts();
        }

        [Test]
        public void SubmeshesWhoseMaterialsAreCalledWing_AreWings()
        {
            MeshSketch sketch = m_Insect.Body().NextSubmesh().Wing(Mirror(s_Fore), -1f, 0.5f).NextSubmesh().Wing(s_Fore, 1f, 0.5f);
            m_Insect.Draw("Butterfly", sketch, "Body", "Wing Left", "WingRight");

            AssertFound("Butterfly Fore Right Submesh 2", "Butterfly Fore Left Submesh 1");
        }

        [Test]
        public void ASubmeshWithBothWings_IsTakenApart()
        {
            MeshSketch sketch = m_Insect.Body().NextSubmesh().Wing(Mirror(s_Fore), -1f, 0.5f).Wing(s_Fore, 1f, 0.5f);
            m_Insect.Draw("Butterfly", sketch, "Chitin", "M_Wings");

            AssertFound("Butterfly Fore Right ConnectedPart", "Butterfly Fore Left ConnectedPart");
            AssertThePointsTellTheParts();
        }

        [Test]
        public void SubmeshesOfAMeshOfWings_AreOneWingEach()
        {
            // Welded along the middle, so that the parts hang together; only the submeshes tell them.
            MeshSketch sketch = new MeshSketch().Wing(Vector3.zero, 1f, 0.5f).NextSubmesh().Wing(Vector3.zero, -1f, 0.5f);
            m_Insect.Draw("Wings", sketch, "Blue", "Blue");

            AssertFound("Wings Fore Right Submesh 0", "Wings Fore Left Submesh 1");
        }

        [Test]
        public void OneRendererASide_WithTwoWings_IsTwoWings()
        {
            foreach (float side in new[] { 1f, -1f })
                m_Insect.Draw("Wings" + side, Wing(side, s_Hind, 0.8f).Wing(Side(s_Fore, side), side, 0.35f));

            AssertFound(
                "Wings1 Fore Right ConnectedPart", "Wings-1 Fore Left ConnectedPart",
                "Wings1 Hind Right ConnectedPart", "Wings-1 Hind Left ConnectedPart");
            AssertThePointsTellTheParts();
        }

        [TestCase("Wing_A", "Wing_B")]
        [TestCase("Plane", "Plane.001")]
        public void MeshesThatAreNotReadable_AreToldByTheirBoxes(string right, string left)
        {
            m_Insect.Draw("Body", m_Insect.Body());
            m_Insect.Draw(right, Wing(1f, s_Fore, 1f));
            m_Insect.Draw(left, Wing(-1f, s_Fore, 1f));
            foreach (MeshFilter filter in m_Insect.Root.GetComponentsInChildren<MeshFilter>())
                filter.sharedMesh.UploadMeshData(true);

            AssertFound($"{right} Fore Right WholeMesh", $"{left} Fore Left WholeMesh");
        }

        [Test]
        public void BothWingsInAMeshThatIsNotReadable_AreToldByPointsOnItsSides()
        {
            MeshRenderer renderer = m_Insect.Draw("Wings", new MeshSketch().Wing(s_Fore, 1f, 0.5f).Wing(Mirror(s_Fore), -1f, 0.5f));
            Mesh readable = renderer.GetComponent<MeshFilter>().sharedMesh;
            Mesh unreadable = m_Insect.Mesh(new MeshSketch().Wing(s_Fore, 1f, 0.5f).Wing(Mirror(s_Fore), -1f, 0.5f));
            unreadable.UploadMeshData(true);
            renderer.GetComponent<MeshFilter>().sharedMesh = unreadable;

            AssertFound("Wings Fore Right ConnectedPart", "Wings Fore Left ConnectedPart");

            // After Read/Write has been turned on, the points lead to the wings.
            List<Wing> wings = WingFinder.Find(m_Insect.Root);
            renderer.GetComponent<MeshFilter>().sharedMesh = readable;
            AssertThePointsTellTheParts(wings);
        }
    }
}
