using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Inspectors
{
    /// <summary>The panel in the scene view as it is drawn: the same controls in layout and repaint, and what they do.</summary>
    public sealed class SkeletonPanelTests : SkeletonSessionFixture
    {
        private SkeletonSession m_Session;

        [SetUp]
        public void Open()
        {
            m_Session = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            m_Session.Place();
        }

        [TearDown]
        public void Close()
        {
            SkeletonSessions.Close(m_Session);
            Selection.objects = null;
            Undo.ClearAll();
        }

        [Test]
        public void EveryCommand_HasAButton_WithATooltipThatNamesItsKey()
        {
            DrawnInspector page = Draw();

            foreach (EditCommand command in SkeletonCommands.All)
            {
                Assert.That(page.Control(command.Name).Tooltip,
                    Does.StartWith(command.Tooltip).And.EndsWith(command.Shortcut == "" ? "." : $"({command.Shortcut})"));
            }
        }

        [Test]
        public void ButtonsDoTheirCommands_AndRefusalsAreShown_UntilTheNextCommand()
        {
            DrawnInspector page = Press("Remove Chain");
            Assert.That(page.HelpBoxes, Has.Member("Select a joint of the chain to remove."));

            m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(1, 1) });
            page = Press("Remove Chain");
            Assert.That(page.HelpBoxes, Is.Empty);
            Assert.That(Right.Skeleton.ChainCount, Is.EqualTo(4));
        }

        [Test]
        public void Problems_HaveButtons_ThatSelectTheirJoints()
        {
            Assert.That(Draw().Buttons, Has.No.Member("Select"));
            Right.Skeleton.Chains[2].joints[3] = Right.Skeleton.GetJoint(2, 2);
            m_Session.Place();

            DrawnInspector page = Press("Select");

            Assert.That(page.HelpBoxes.First(), Does.StartWith("Joint 3 of chain 2 lies at the same place"));
            Assert.That(m_Session.Group.Active.Selection.Living(), Is.EqualTo(new[] { new JointIndex(2, 3) }));
        }

        [Test]
        public void Weaknesses_AreListedToo()
        {
            m_Session.Group.Active.Do(
                "Slide", (draft, selected) => SlideCommands.By(draft, new[] { new JointIndex(0, 3), new JointIndex(0, 4) }, -0.15f));
            m_Session.Place();

            Assert.That(Draw().HelpBoxes, Has.Some.Contains("beside the joints"));
            Press("Select");
            Assert.That(m_Session.Group.Active.Selection.Living(), Is.EqualTo(m_Session.Overlay.Problems[0].Joints));
        }

        [Test]
        public void Counts_AreNotTouchedByDrawing_WhateverTheyAre()
        {
            Right.Skeleton.Chains = Right.Skeleton.Chains.Take(2).ToArray();
            string before = SkeletonText.Of(Right.Skeleton);

            DrawnInspector page = Draw();

            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
            Assert.That(page.Controls.Any(control => control.Text == "Chains"), Is.False);
            Assert.That(Press("Mend").HelpBoxes, Is.Empty);
            Assert.That(Draw().Control("Chains").Value, Is.EqualTo("3"));
        }

        [Test]
        public void Fields_ChangeWhatTheySay_OfTheSkeletonThatIsChosen()
        {
            Put("Chains", 6);
            Assert.That((Right.Skeleton.ChainCount, Right.Skeleton.JointsPerChain), Is.EqualTo((6, 5)));
            Put("Joints", 4);
            Assert.That((Right.Skeleton.ChainCount, Right.Skeleton.JointsPerChain), Is.EqualTo((6, 4)));
            Assert.That((Draw().Control("Chains").Value, Draw().Control("Joints").Value), Is.EqualTo(("6", "4")));

            Assert.That(Draw().Control("Skeleton").Value, Is.EqualTo("1  Right Wing"));
            Put("Skeleton", 1);
            Assert.That(m_Session.Group.Active.Skeleton, Is.SameAs(Left.Skeleton));
            Put("Chains", 4);
            Assert.That((Left.Skeleton.ChainCount, Right.Skeleton.ChainCount), Is.EqualTo((4, 6)));

            Press("Show beat (K)");
            Put("Phase", 0.25f);
            Assert.That(m_Session.Overlay.Phase, Is.EqualTo(0.25f));
            Assert.That(m_Session.Overlay.Colours, Is.Null);
            foreach (RigColourMode mode in System.Enum.GetValues(typeof(RigColourMode)))
            {
                Put("Colours", 1 + (int)mode);
                Assert.That(m_Session.Overlay.Colours, Is.EqualTo(mode));
            }

            Put("Colours", 0);
            Assert.That(m_Session.Overlay.Colours, Is.Null);
            bool labels = m_Session.ShowsLabels;
            Press("Labels");
            Assert.That(m_Session.ShowsLabels, Is.Not.EqualTo(labels));
        }

        [Test]
        public void TheOverlay_IsThereWhileASkeletonIsEdited()
        {
            var overlay = new SkeletonOverlay();
            Assert.That(overlay.visible, Is.True);
            Assert.That(DrawnInspector.Of(overlay.OnGUI).Control("Chains").Value, Is.EqualTo("5"));
            SkeletonSessions.Close(m_Session);
            Assert.That(overlay.visible, Is.False);
            Assert.That(DrawnInspector.Of(overlay.OnGUI).Controls, Is.Empty);
        }

        [Test]
        public void Switches_SwitchTheSession()
        {
            Press("Symmetric (Shift+M)");
            Assert.That(m_Session.IsSymmetric);
            Press("Free");
            Assert.That(m_Session.Mode, Is.EqualTo(DragMode.Free));
            DrawnInspector page = Press("Show beat (K)");
            Assert.That(m_Session.Overlay.ShowsBeat);
            Assert.That(page.Controls.Any(control => control.Text == "Phase"));
        }

        [Test]
        public void Symmetry_NeedsAnotherSide()
        {
            Left.Skeleton = Right.Skeleton;
            Open();

            Assert.That(Draw().Control("Symmetric (Shift+M)").Enabled, Is.False);
        }

        [Test]
        public void Colours_ComeWithALegend()
        {
            m_Session.Overlay.Colours = RigColourMode.JointMass;
            m_Session.Place();

            DrawnInspector page = Draw();

            Assert.That(page.Controls.Any(control => control.Kind == ControlKind.Label && control.Value.EndsWith("% of the mass")));
        }

        [Test]
        public void InsectWithoutSkeletons_IsOfferedThem()
        {
            Right.Skeleton = null;
            Left.Skeleton = null;
            Open();
            Selection.activeGameObject = Insect.gameObject;

            DrawnInspector page = Draw();

            Assert.That(page.HelpBoxes, Is.EqualTo(new[] { "None of the selected insects has a wing with a skeleton." }));
            Assert.That(page.Buttons, Is.EqualTo(new[] { "Lay Out 'Monarch'…" }));
        }

        [Test]
        public void AssetOfAPackage_RefusesActs_AndSaysWhatHelps_UntilItMayBeChanged()
        {
            ProjectAssets.AddToPackage("Packages/com.example.wings/Wing.asset", Right.Skeleton);
            try
            {
                m_Session.Place();
                m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(1, 1) });
                Assert.That(Press("Add Joint Row").HelpBoxes, Has.Some.StartWith("'Right Wing' is read-only: check it out"));
                Assert.That(Right.Skeleton.JointsPerChain, Is.EqualTo(5));
            }
            finally
            {
                ProjectAssets.Clear();
            }

            m_Session.Place();
            Assert.That(Press("Add Joint Row").HelpBoxes, Is.Empty);
            Assert.That(Right.Skeleton.JointsPerChain, Is.EqualTo(6));
        }

        [Test]
        public void ManyProblems_AreCutShort_AndCounted()
        {
            for (int i = 0; i < 5; i++)
                Right.Skeleton.Chains[i].joints[2] = Right.Skeleton.Chains[i].joints[3] = Right.Skeleton.GetJoint(i, 1);
            m_Session.Place();
            int all = Right.Skeleton.Validate().Count + m_Session.Overlay.Problems.Count;

            DrawnInspector page = Draw();

            Assert.That(all, Is.GreaterThan(6));
            Assert.That(page.Buttons.Count(text => text == "Select"), Is.EqualTo(6));
            Assert.That(page.Controls.Any(control => control.Text == $"and {all - 6} more"));
        }

        [Test]
        public void Keys_WorkInThePanelToo_ButNotWhileTextIsTyped()
        {
            Assert.That(Key(KeyCode.K), Is.EqualTo(EventType.Used));
            Assert.That(m_Session.Overlay.ShowsBeat);

            EditorGUIUtility.editingTextField = true;
            try
            {
                Assert.That(Key(KeyCode.K), Is.EqualTo(EventType.KeyDown));
                Assert.That(m_Session.Overlay.ShowsBeat);
            }
            finally
            {
                EditorGUIUtility.editingTextField = false;
            }
        }

        [Test]
        public void AssetOfTheProject_CanBeChanged()
        {
            string path = "Assets/Alate Test Locked.asset";
            AssetDatabase.CreateAsset(Right.Skeleton, path);
            try
            {
                Open();
                m_Session.Select(m_Session.Group.Active, new[] { new JointIndex(1, 1) });
                Assert.That(Press("Add Joint Row").HelpBoxes, Is.Empty);
            }
            finally
            {
                AssetDatabase.DeleteAsset(path);
            }
        }

        private EventType Key(KeyCode key)
        {
            EventType left = EventType.Ignore;
            DrawnInspector.Of(() =>
            {
                Event drawn = Event.current, sent = new Event { type = EventType.KeyDown, keyCode = key };
                Event.current = drawn.type == EventType.Repaint ? sent : drawn;
                SkeletonPanel.Draw(m_Session);
                left = sent.type;
                Event.current = drawn;
            });
            return left;
        }

        private DrawnInspector Draw() => DrawnInspector.Of(() => SkeletonPanel.Draw(m_Session));

        private void Put(string label, object value) => DrawnInspector.Put(() => SkeletonPanel.Draw(m_Session), label, value);

        private DrawnInspector Press(string text) => DrawnInspector.Press(() => SkeletonPanel.Draw(m_Session), text);
    }
}
