using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEngine;

namespace Alate.Tests.Inspectors
{
    /// <summary>The skeleton's inspector as it is drawn.</summary>
    public sealed class WingSkeletonInspectorTests : SkeletonSessionFixture
    {
        private UnityEditor.Editor m_Editor;

        [TearDown]
        public void Close()
        {
            SkeletonMeshMemory.Set(Right.Skeleton, null);
            if (m_Editor != null)
                Object.DestroyImmediate(m_Editor);
            UnityEditor.Undo.ClearAll();
        }

        [Test]
        public void GoodSkeleton_IsSaidToBeUsable_AndShowsItsFields()
        {
            DrawnInspector page = Draw();

            Assert.That(page.Control("Size").Value, Is.EqualTo("5 chains of 5 joints"));
            Assert.That(page.HelpBoxes, Is.EqualTo(new[] { "This skeleton can be used." }));
            foreach (string label in new[] { "Mesh", "Hinge", "Span Axis", "Up Axis", "Chains" })
                Assert.That(page.Control(label).Tooltip, Is.Not.Empty, label);
        }

        [Test]
        public void WithItsMesh_TheRigIsShown()
        {
            SkeletonMeshMemory.Set(Right.Skeleton, Right.Renderer.GetComponent<MeshFilter>().sharedMesh);

            DrawnInspector page = Draw();

            Assert.That(page.Control("Rig").Value, Does.Match(@"^\d+ triangles, \d+ patches, heaviest joint [\d.]+ %$"));
            Assert.That(page.HelpBoxes, Has.Member("The rig has no weakness."));
        }

        [Test]
        public void UnreadableMesh_IsNamed_AndNoRigIsShown()
        {
            Mesh mesh = Right.Renderer.GetComponent<MeshFilter>().sharedMesh;
            SkeletonMeshMemory.Set(Right.Skeleton, mesh);
            mesh.UploadMeshData(true);

            DrawnInspector page = Draw();

            Assert.That(page.HelpBoxes, Has.Member($"Mesh '{mesh.name}' is not readable: turn on Read/Write in its import settings."));
            Assert.That(page.Controls.Any(control => control.Text == "Rig"), Is.False);
        }

        [Test]
        public void Weakness_IsSelectedInTheSceneView()
        {
            SkeletonMeshMemory.Set(Right.Skeleton, Right.Renderer.GetComponent<MeshFilter>().sharedMesh);
            SkeletonDraft.Read(Right.Skeleton, out SkeletonDraft draft);
            SlideCommands.By(draft, new[] { new JointIndex(0, 3), new JointIndex(0, 4) }, -0.15f).Draft.WriteTo(Right.Skeleton);
            Draw();

            DrawnInspector.Press(m_Editor, "Select");

            Assert.That(SkeletonSessions.Current.Group.Active.Skeleton, Is.SameAs(Right.Skeleton));
            Assert.That(SkeletonSessions.Current.Group.SelectedCount, Is.GreaterThan(0));
        }

        [Test]
        public void EditButton_BeginsAndEndsASession_AndClosingTheInspectorEndsIt()
        {
            Draw();
            DrawnInspector.Press(m_Editor, "Edit In Scene View");
            Assert.That(SkeletonSessions.Current.Group.Active.Skeleton, Is.SameAs(Right.Skeleton));
            DrawnInspector.Press(m_Editor, "Edit In Scene View");
            Assert.That(SkeletonSessions.Current, Is.Null);

            DrawnInspector.Press(m_Editor, "Edit In Scene View");
            Object.DestroyImmediate(m_Editor);
            Assert.That(SkeletonSessions.Current, Is.Null);
        }

        [Test]
        public void BrokenSkeleton_ListsItsProblems_AndNoRig()
        {
            SkeletonMeshMemory.Set(Right.Skeleton, Right.Renderer.GetComponent<MeshFilter>().sharedMesh);
            Right.Skeleton.Chains[2].joints = Right.Skeleton.Chains[2].joints.Take(4).ToArray();

            DrawnInspector page = Draw();

            Assert.That(page.HelpBoxes.First(), Is.EqualTo("Chain 2 has 4 joints but chain 0 has 5; all chains need the same number."));
            Assert.That(page.Controls.Any(control => control.Text == "Rig"), Is.False);
        }

        [Test]
        public void SeveralSkeletons_ShareAnInspector_WithoutTools()
        {
            m_Editor = UnityEditor.Editor.CreateEditor(new Object[] { Right.Skeleton, Left.Skeleton });

            var page = DrawnInspector.Of(m_Editor);

            Assert.That(page.Buttons, Is.Empty);
            Assert.That(page.Control("Size").Value, Is.EqualTo("5 chains of 5 joints"));
        }

        private DrawnInspector Draw()
        {
            m_Editor = UnityEditor.Editor.CreateEditor(Right.Skeleton);
            return DrawnInspector.Of(m_Editor);
        }
    }
}
