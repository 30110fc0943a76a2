using System.Linq;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Inspectors
{
    /// <summary>The inspector as it is drawn: its controls, their tooltips, what its buttons do.</summary>
    public sealed class InsectWingsInspectorTests : InsectFixture
    {
        private UnityEditor.Editor m_Editor;

        [TearDown]
        public void Close()
        {
            if (m_Editor != null)
                UnityEngine.Object.DestroyImmediate(m_Editor);
            ProjectAssets.Clear();
            foreach (string section in new[] { "Live", "Gizmos", "Events", "Preset" })
                SessionState.EraseBool("Alate.InsectWings.Section." + section);
            EditorPrefs.DeleteKey("Alate.InsectWings.Gizmos");
        }

        [Test]
        public void Inspector_ShowsAllFields()
        {
            DrawnInspector page = Draw(Insect());

            foreach (string label in new[] { "Preset", "Wings", "Update Mode", "Start Phase", "Motion", "Air", "Quality" })
                Assert.That(page.Controls.Count(c => c.Text == label), Is.EqualTo(1), label);
            Assert.That(page.HelpBoxes, Is.Empty);
        }

        [Test]
        public void EveryField_HasATooltip()
        {
            InsectWings insect = Insect();
            insect.Wings[1].Part = WingPart.Submesh;
            insect.Motion.source = VelocitySource.Rigidbody;
            Open(insect);
            ExpandAll();

            var page = DrawnInspector.Of(m_Editor);

            var fields = page.Controls.Where(c => c.Kind == ControlKind.Field).ToList();
            Assert.That(fields, Has.Count.GreaterThan(30));
            foreach (DrawnControl field in fields)
                Assert.That(field.Tooltip, Is.Not.Empty, field.Text);
        }

        [Test]
        public void Wings_AreNamedByWhatTheyAre_AndShowTheFieldThatCounts()
        {
            InsectWings insect = Insect();
            insect.Wings[0].Part = WingPart.ConnectedPart;
            insect.Wings[1].Part = WingPart.Submesh;
            Open(insect);
            ExpandAll();

            var page = DrawnInspector.Of(m_Editor);

            var labels = page.Controls.Select(c => c.Text).ToList();
            int right = labels.IndexOf("Fore Right · wing Right"), left = labels.IndexOf("Fore Left · wing Left");
            Assert.That(right, Is.InRange(0, left - 1));
            Assert.That(labels.GetRange(right, left - right), Does.Contain("Point").And.Not.Contain("Submesh"));
            Assert.That(labels.GetRange(left, labels.Count - left), Does.Contain("Submesh").And.Not.Contain("Point"));
        }

        [Test]
        public void AWingAddedToAnEmptyList_Beats()
        {
            InsectWings insect = Insect();
            insect.Wings.Clear();
            Open(insect);

            m_Editor.serializedObject.FindProperty("m_Wings").InsertArrayElementAtIndex(0);
            m_Editor.serializedObject.ApplyModifiedProperties();

            Assert.That(insect.Wings, Has.Count.EqualTo(1));
            Assert.That(insect.Wings[0].AmplitudeScale, Is.EqualTo(1f), "Unity adds an entry of zeros, which holds the wing still");

            insect.Wings[0].AmplitudeScale = 0f;
            m_Editor.serializedObject.Update();
            m_Editor.serializedObject.FindProperty("m_StartPhase").floatValue = 10f;
            m_Editor.serializedObject.ApplyModifiedProperties();
            Assert.That(insect.Wings[0].AmplitudeScale, Is.Zero, "a wing that is to be still is not left so");
        }

        [Test]
        public void LevelsOfDetail_AreFourNamedFields_WhileTheyAreOn()
        {
            InsectWings insect = Insect();
            Open(insect);
            ExpandAll();
            Assert.That(DrawnInspector.Of(m_Editor).Control("Waves Only Below").Value, Is.EqualTo("0.03 of 0 to 1"));

            insect.Quality.levelOfDetail = false;

            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Not.Contain("Waves Only Below"));
        }

        [Test]
        public void TeleportThresholds_AreShownWhereJumpsAreHeeded()
        {
            InsectWings insect = Insect();
            Open(insect);
            ExpandAll();
            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Contain("Teleport Angle").And.Not.Contain("Body"));

            insect.Motion.onTeleport = TeleportResponse.Ignore;
            insect.Motion.source = VelocitySource.Rigidbody;

            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Contain("Body").And.Not.Contain("Teleport Angle"));
        }

        [Test]
        public void Problem_HasOneBox_AndItsButtonMendsIt()
        {
            InsectWings insect = Insect();
            insect.Wings[0].Renderer = null;

            DrawnInspector page = Draw(insect);
            Assert.That(page.HelpBoxes, Is.EqualTo(new[] { insect.FindProblem().Message }));

            page = DrawnInspector.Press(m_Editor, "Remove Wing");

            Assert.That(page.HelpBoxes, Is.Empty);
            Assert.That(insect.Wings, Has.Count.EqualTo(1));
            Undo.PerformUndo();
            Assert.That(DrawnInspector.Of(m_Editor).HelpBoxes.Count(), Is.EqualTo(1));
        }

        [Test]
        public void FixesOfAllSelectedInsects_ArePressedOnce_AndUndoneOnce()
        {
            InsectWings first = Insect(), good = Insect(), second = Insect();
            first.Wings[0].Renderer = null;
            second.Wings[1].Renderer = null;
            Open(first, good, second);
            Assert.That(DrawnInspector.Of(m_Editor).HelpBoxes.Single(), Does.EndWith("One more of the selected insects has a problem."));

            var page = DrawnInspector.Press(m_Editor, "Remove Wing");

            Assert.That(page.HelpBoxes, Is.Empty);
            Assert.That(new[] { first, good, second }.Select(insect => insect.Wings.Count), Is.EqualTo(new[] { 1, 2, 1 }));
            Undo.PerformUndo();
            Assert.That(new[] { first, good, second }.Select(insect => insect.Wings.Count), Is.All.EqualTo(2));
        }

        [Test]
        public void FindWings_AnswersBelowTheBox()
        {
            InsectWings insect = Without(Bare());
            Open(insect);
            m_Editor.serializedObject.FindProperty("m_Wings").isExpanded = true;

            var page = DrawnInspector.Press(m_Editor, "Find Wings");

            Assert.That(insect.Wings, Has.Count.EqualTo(2));
            Assert.That(page.Controls.Select(c => c.Text), Does.Contain("Found 2 wings."));
            Assert.That(page.Control("Fore Left · wing Left").Kind, Is.EqualTo(ControlKind.Foldout));
        }

        [Test]
        public void UnreadableMesh_OfAModel_IsMendedByTheImporter()
        {
            InsectWings insect = Insect();
            for (int w = 0; w < 2; w++)
            {
                MeshOf(insect.Wings[w]).UploadMeshData(true);
                ProjectAssets.AddModel($"Assets/wing{w}.fbx", MeshOf(insect.Wings[w]));
            }

            Open(insect);
            var page = DrawnInspector.Press(m_Editor, "Make Mesh Readable");

            Assert.That(page.HelpBoxes, Is.Empty);
            Assert.That(insect.Wings.All(wing => MeshOf(wing).isReadable), Is.True);
        }

        [TestCase("Packages/com.other/wing.fbx", "read-only package")]
        [TestCase(null, "UploadMeshData")]
        public void UnreadableMesh_ThatHasNoImporter_SaysWhatToDo(string path, string advice)
        {
            InsectWings insect = Insect();
            MeshOf(insect.Wings[0]).UploadMeshData(true);
            if (path != null)
                ProjectAssets.AddModel(path, MeshOf(insect.Wings[0]));

            DrawnInspector page = Draw(insect);

            Assert.That(page.Control("Make Mesh Readable").Enabled, Is.False);
            Assert.That(page.Control("Make Mesh Readable").Tooltip, Does.Contain(advice));
            Assert.That(page.Controls.Count(c => c.Kind == ControlKind.Label && c.Text.Contains(advice)), Is.EqualTo(1));
        }

        [Test]
        public void ChangesOfInstancesOfPrefabs_AreOverrides()
        {
            InsectWings insect = Without(Bare());
            PrefabInstances.Declare(insect);
            Open(insect);

            DrawnInspector.Press(m_Editor, "Find Wings");

            Assert.That(PrefabInstances.HasOverrides(insect), Is.True);
        }

        [Test]
        public void Gizmos_HaveATogglePerLayer_ThatStays()
        {
            Open(Insect());
            var page = DrawnInspector.Press(m_Editor, "Gizmos");
            Assert.That(page.Control("Patch Loads").Value, Is.EqualTo("off"));

            page = DrawnInspector.Press(m_Editor, "Patch Loads");

            Assert.That(page.Control("Patch Loads").Value, Is.EqualTo("on"));
            Assert.That(page.Control("Chains").Value, Is.EqualTo("on"));
            Assert.That(Alate.Editor.GizmoSettings.Layers.HasFlag(Alate.Editor.GizmoLayers.Loads), Is.True);
            DrawnInspector.Press(m_Editor, "Patch Loads");
            Assert.That(Alate.Editor.GizmoSettings.Layers.HasFlag(Alate.Editor.GizmoLayers.Loads), Is.False);
        }

        [Test]
        public void Foldouts_StayAsTheyWereLeft_InTheNextInspector()
        {
            Open(Insect());
            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Not.Contain("On Wing Beat"));
            DrawnInspector.Press(m_Editor, "Events");

            Open(Insect());

            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Contain("On Wing Beat"));
        }

        [Test]
        public void PresetButtons_AreThoseOfOneInsect()
        {
            InsectWings one = Insect(), other = Insect();
            Assert.That(Draw(one).Buttons, Does.Contain("Save 'Monarch' As Preset…"));

            Open(one, other);

            Assert.That(DrawnInspector.Of(m_Editor).Buttons.Any(text => text.StartsWith("Save")), Is.False);
        }

        [Test]
        public void Preset_CanBeTuned_BelowItsField()
        {
            InsectWings insect = Insect();
            Open(insect);
            Assert.That(DrawnInspector.Of(m_Editor).Controls.Select(c => c.Text), Does.Not.Contain("Tune Preset"));
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());

            var page = DrawnInspector.Press(m_Editor, "Tune Preset");

            foreach (string group in new[] { "Size", "Beat", "Wave", "Stiffness", "Substeps Per Beat", "Options" })
                Assert.That(page.Control(group).Enabled, Is.True);
        }

        [Test]
        public void PresetInAPackage_IsShown_ButCannotBeTuned()
        {
            InsectWings insect = Insect();
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            ProjectAssets.AddToPackage("Packages/com.alate.insect-wings/Monarch.asset", insect.Preset);
            Open(insect);

            var page = DrawnInspector.Press(m_Editor, "Tune Preset");

            Assert.That(page.Control("Beat").Enabled, Is.False);
            Assert.That(page.Controls.Count(c => c.Text.Contains("cannot be changed")), Is.EqualTo(1));
        }

        [Test]
        public void ManyInsects_WithDifferentWings_CanBeEditedTogether()
        {
            InsectWings few = Insect(), more = Insect();
            few.Wings.RemoveAt(1);
            more.Wings[0].Side = WingSide.Left;
            more.StartPhase = 90f;
            Open(few, more);
            ExpandAll();

            var page = DrawnInspector.Of(m_Editor);
            Assert.That(page.Control("Start Phase").Value, Is.EqualTo("—"));

            m_Editor.serializedObject.FindProperty("m_StartPhase").floatValue = 45f;
            m_Editor.serializedObject.ApplyModifiedProperties();

            Assert.That(few.StartPhase, Is.EqualTo(45f));
            Assert.That(more.StartPhase, Is.EqualTo(45f));
            Assert.That(more.Wings, Has.Count.EqualTo(2));
        }

        private DrawnInspector Draw(InsectWings insect)
        {
            Open(insect);
            return DrawnInspector.Of(m_Editor);
        }

        private void Open(params InsectWings[] insects)
        {
            if (m_Editor != null)
                UnityEngine.Object.DestroyImmediate(m_Editor);
            m_Editor = UnityEditor.Editor.CreateEditor(insects.ToArray<Object>());
            Expand(false);
        }

        private void ExpandAll() => Expand(true);

        private void Expand(bool open)
        {
            foreach (string path in new[] { "m_Wings", "m_Motion", "m_Air", "m_Quality" })
                m_Editor.serializedObject.FindProperty(path).isExpanded = open;
            SerializedProperty wings = m_Editor.serializedObject.FindProperty("m_Wings");
            for (int w = 0; w < wings.arraySize; w++)
                wings.GetArrayElementAtIndex(w).isExpanded = open;
        }
    }
}
