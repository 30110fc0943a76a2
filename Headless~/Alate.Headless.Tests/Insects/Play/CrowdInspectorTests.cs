using System.Collections;
using System.Linq;
using NUnit.Framework;
using StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>
    /// Inspectors of crowds and spawners in play. Not among those of flights, whose parts are made without the package's shader and kept.
    /// </summary>
    public sealed class CrowdInspectorTests : CrowdFixture
    {
        private UnityEditor.Editor m_Editor;

        [TearDown]
        public void CloseInspector() => Object.DestroyImmediate(m_Editor);

        [UnityTest]
        public IEnumerator ASpawnersInspector_TellsWhatKeepsItFromPlacing()
        {
            CrowdScene scene = Scene = new CrowdScene("monarch", 3, "cruise");
            CrowdSpawnerTold(scene, out Alate.Crowds.CrowdSpawner spawner);
            yield return Frames(3);
            var page = DrawnInspector.Of(m_Editor);
            Assert.That(page.HelpBoxes, Is.Empty);
            spawner.Loop = "dive";
            page = DrawnInspector.Of(m_Editor);
            Assert.That((page.HelpBoxes.Single(), page.Control(page.HelpBoxes.Single()).Value), Is.EqualTo((spawner.Problem, "Warning")));
            Assert.That(page.Controls.Count(control => control.Kind == ControlKind.Field), Is.GreaterThan(4), "its fields");
        }

        [UnityTest]
        public IEnumerator ACrowdsInspector_TellsWhatIsDrawn_FrameByFrame_OrWhatKeepsItFromThat()
        {
            CrowdScene scene = Scene = new CrowdScene("monarch", 3, "cruise");
            Alate.Crowds.InsectCrowd crowd = scene.Crowd;
            for (int k = 0; k < 3; k++)
                scene.Place(k, Alate.Crowds.CrowdPose.At(default, Unity.Mathematics.quaternion.identity));
            m_Editor = UnityEditor.Editor.CreateEditor(crowd);
            yield return Frames(3);
            var page = DrawnInspector.Of(m_Editor);
            Assert.That(m_Editor.RequiresConstantRepaint(), Is.True);
            Assert.That(page.HelpBoxes.Single(), Is.EqualTo(
                $"3 of 3 drawn, over all cameras, 0 live, {crowd.DrawCalls} draw calls, {crowd.Triangles / 1000} thousand triangles"));
            Assert.That(page.Control(page.HelpBoxes.Single()).Value, Is.EqualTo("Info"));
            LogAssert.Expect(LogType.Warning, "'crowd': No baked insect is assigned.");
            crowd.Insect = null;
            yield return null;
            page = DrawnInspector.Of(m_Editor);
            Assert.That((page.HelpBoxes.Single(), page.Control(page.HelpBoxes.Single()).Value), Is.EqualTo((crowd.Problem, "Warning")));
            Assert.That(page.Controls.Count(control => control.Kind == ControlKind.Field), Is.GreaterThan(4), "its fields");
        }

        private void CrowdSpawnerTold(CrowdScene scene, out Alate.Crowds.CrowdSpawner spawner)
        {
            spawner = scene.Crowd.gameObject.AddComponent<Alate.Crowds.CrowdSpawner>();
            m_Editor = UnityEditor.Editor.CreateEditor(spawner);
        }
    }
}
