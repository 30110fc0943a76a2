using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Inspectors
{
    /// <summary>Events of the scene view, as the tool receives them.</summary>
    public sealed class SkeletonSceneTests : SkeletonSessionFixture
    {
        private readonly View m_Eye = new View(new Vector3(3f, 9f, -2f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
        private SkeletonSceneGui m_Gui;
        private SceneView m_View;
        private SceneEye m_Scene;
        private SkeletonSession m_Session;

        [SetUp]
        public void Open()
        {
            m_Gui = new SkeletonSceneGui();
            m_View = Keep(ScriptableObject.CreateInstance<SceneView>());
            m_Scene = new SceneEye(m_Eye.Project, m_Eye.Through);
            m_Session = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
        }

        [TearDown]
        public void Close()
        {
            SkeletonSessions.Close(m_Session);
            m_Scene.Dispose();
            m_Gui.Dispose();
            GUIUtility.hotControl = 0;
            ShownMenu.Clear();
            Undo.ClearAll();
        }

        [Test]
        public void Everything_IsDrawn_WhateverIsShown([Values] bool beat, [Values] bool colours, [Values] bool valid)
        {
            m_Session.Overlay.ShowsBeat = beat;
            m_Session.Overlay.Colours = colours ? RigColourMode.Delay : (RigColourMode?)null;
            if (!valid)
                Right.Skeleton.Chains = Right.Skeleton.Chains.Take(2).ToArray();

            Assert.That(() => Send(EventType.Repaint, Pixel(1, 1)), Throws.Nothing);
        }

        [Test]
        public void JointsAndHingesThatAreNowhere_AreLeftOut()
        {
            Right.Skeleton.Chains[2].joints[3] = new Vector3(float.NaN, 0f, 0f);
            Right.Skeleton.Chains[4].joints[4] = Vector3.positiveInfinity;
            Right.Skeleton.Hinge = new Vector3(0f, float.NaN, 0f);
            m_Session.Group.SelectAll();

            Assert.That(() => Send(EventType.Repaint, Pixel(1, 1)), Throws.Nothing);
            Assert.That(() => Click(Pixel(1, 1)), Throws.Nothing);
            Command(EventType.ExecuteCommand, "FrameSelected");
            Assert.That(float.IsNaN(m_View.pivot.x + m_View.size), Is.False);
        }

        [Test]
        public void EmptySkeleton_AndNoSkeleton_AreDrawnToo()
        {
            Right.Skeleton.Chains = null;
            Assert.That(() => Send(EventType.Repaint, Vector2.zero), Throws.Nothing);

            m_Session = SkeletonSessions.Open(new SkeletonTarget[0]);
            Assert.That(() => Send(EventType.Repaint, Vector2.zero), Throws.Nothing);
            Assert.That(() => Click(Vector2.zero), Throws.Nothing);
        }

        [Test]
        public void Click_SelectsAJoint_AndTakesTheEvent()
        {
            Event down = Send(EventType.MouseDown, Pixel(2, 2));
            Assert.That(down.type, Is.EqualTo(EventType.Used));
            Assert.That(GUIUtility.hotControl, Is.Not.Zero);
            Send(EventType.MouseUp, Pixel(2, 2));

            Assert.That(GUIUtility.hotControl, Is.Zero);
            Assert.That(m_Session.Group.Active.Selection.Living(), Is.EqualTo(new[] { new JointIndex(2, 2) }));
        }

        [Test]
        public void Drag_MovesTheJoint_AndIsOneStepOfUndo()
        {
            Click(Pixel(2, 2));
            string before = SkeletonText.Of(Right.Skeleton);
            Vector2 from = Pixel(2, 2);

            Send(EventType.MouseDown, from);
            for (int k = 1; k <= 10; k++)
                Send(EventType.MouseDrag, from + k * new Vector2(5f, 3f));
            Send(EventType.MouseUp, from + new Vector2(50f, 30f));

            Assert.That(Vector2.Distance(Pixel(2, 2), from + new Vector2(50f, 30f)), Is.LessThan(0.5f));
            Undo.PerformUndo();
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void Drag_WithShift_StaysOnTheChain()
        {
            var path = new JointPath((Vector3[])Right.Skeleton.Chains[2].joints.Clone());
            Vector2 from = Pixel(2, 2);

            Send(EventType.MouseDown, from);
            Send(EventType.MouseDrag, from + new Vector2(20f, 60f), EventModifiers.Shift);
            Send(EventType.MouseUp, from);

            Vector3 moved = Right.Skeleton.GetJoint(2, 2);
            float along = Vector3.Distance(moved, Right.Skeleton.GetJoint(2, 0));
            Assert.That(Vector3.Distance(path.At(along), moved), Is.LessThan(1e-5f));
            Assert.That(along, Is.Not.EqualTo(path.DistanceOf(2)).Within(1e-4f));
        }

        [Test]
        public void Drag_WithCtrl_StaysOnTheMesh()
        {
            Right.Skeleton.Chains[2].joints[2].y = 0.15f;
            Vector2 from = Pixel(2, 2);

            Send(EventType.MouseDown, from);
            Send(EventType.MouseDrag, Pixel(2, 1), EventModifiers.Control);
            Send(EventType.MouseUp, from);

            Assert.That(Right.Skeleton.GetJoint(2, 2).y, Is.EqualTo(0f).Within(1e-5f));
        }

        [Test]
        public void PressOnAnotherHandle_IsLeftToIt()
        {
            Event.current = new Event { type = EventType.Layout };
            m_Gui.OnGUI(m_View, m_Session);
            HandleUtility.nearestControl = 4711;
            Event.current = new Event { type = EventType.MouseDown, mousePosition = Pixel(2, 2), clickCount = 1 };
            m_Gui.OnGUI(m_View, m_Session);

            Assert.That(Event.current.type, Is.EqualTo(EventType.MouseDown));
            Assert.That(m_Session.Group.SelectedCount, Is.Zero);
            Event.current = null;
        }

        [Test]
        public void ClosedSession_LeavesNoMeshAndNoNativeMemory()
        {
            SkeletonSessions.Close(m_Session);
            int meshes = Resources.FindObjectsOfTypeAll<Mesh>().Length, allocations = NativeMemoryLedger.LiveCount;
            m_Session = SkeletonSessions.Open(InsectTargets.Find(new[] { Insect }));
            m_Session.Overlay.ShowsBeat = true;
            m_Session.Overlay.Colours = RigColourMode.Patch;
            Send(EventType.Repaint, Pixel(1, 1));
            Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.Length.EqualTo(meshes + 2));
            Assert.That(NativeMemoryLedger.LiveCount, Is.GreaterThan(allocations));

            SkeletonSessions.Close(m_Session);

            Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.Length.EqualTo(meshes));
            Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(allocations));
        }

        [Test]
        public void BoxOverNothing_SelectsWhatItHolds()
        {
            var corner = new Vector2(-9000f, -9000f);
            Send(EventType.MouseDown, corner);
            Send(EventType.MouseDrag, -corner);
            Send(EventType.Repaint, -corner);
            Send(EventType.MouseUp, -corner);

            Assert.That(m_Session.Group.SelectedCount, Is.EqualTo(50));
        }

        [Test]
        public void AltAndOtherButtons_AreLeftToTheSceneView()
        {
            Assert.That(Send(EventType.MouseDown, Pixel(2, 2), EventModifiers.Alt).type, Is.EqualTo(EventType.MouseDown));
            Assert.That(Send(EventType.MouseDown, Pixel(2, 2), button: 2).type, Is.EqualTo(EventType.MouseDown));
            Assert.That(Send(EventType.MouseDown, new Vector2(-9000f, 0f), button: 1).type, Is.EqualTo(EventType.MouseDown));
            Assert.That(m_Session.Group.SelectedCount, Is.Zero);
        }

        [Test]
        public void RightClickOnAJoint_OpensTheMenu_AboutThatJoint()
        {
            Send(EventType.MouseDown, Pixel(3, 1), button: 1);

            Assert.That(ShownMenu.Lines.Where(line => line != ""), Is.EqualTo(SkeletonCommands.All.Select(command => command.Title)));
            ShownMenu.Choose("Select Chain (D)");
            Assert.That(m_Session.Group.Active.Selection.Living(), Is.EqualTo(Enumerable.Range(0, 5).Select(j => new JointIndex(3, j))));
        }

        [Test]
        public void RightClickThatTheCameraTook_OpensTheMenuToo()
        {
            Send(EventType.Used, Pixel(3, 1), button: 1);
            Assert.That(Send(EventType.ContextClick, Pixel(3, 1), button: 1).type, Is.EqualTo(EventType.Used));

            ShownMenu.Choose("Select Row (Shift+D)");
            Assert.That(m_Session.Group.Active.Selection.Living(), Is.EqualTo(Enumerable.Range(0, 5).Select(i => new JointIndex(i, 1))));
            Assert.That(Send(EventType.ContextClick, new Vector2(-9000f, 0f), button: 1).type, Is.EqualTo(EventType.ContextClick));
        }

        [Test]
        public void RightClick_OpensOneMenu_WhereBothItsEventsArrive()
        {
            Send(EventType.MouseDown, Pixel(3, 1), button: 1);
            ShownMenu.Clear();

            Assert.That(Send(EventType.ContextClick, Pixel(3, 1), button: 1).type, Is.EqualTo(EventType.Used));

            Assert.That(ShownMenu.Lines, Is.Empty);
        }

        [Test]
        public void WhileTheMouseIsDown_OtherButtonsAndCommandsWait()
        {
            Click(Pixel(2, 2));
            Vector2 from = Pixel(2, 2), to = from + new Vector2(50f, 30f);
            Send(EventType.MouseDown, from);
            Send(EventType.MouseDrag, to);

            Send(EventType.MouseDown, Pixel(3, 1), button: 1);
            Send(EventType.MouseUp, Pixel(3, 1), button: 1);
            Command(EventType.ExecuteCommand, "SelectAll");
            Command(EventType.ExecuteCommand, "Delete");

            Assert.That(ShownMenu.Lines, Is.Empty);
            Assert.That(m_Session.Group.SelectedCount, Is.EqualTo(1));
            Assert.That(Right.Skeleton.JointsPerChain, Is.EqualTo(5));
            Send(EventType.MouseDrag, from);
            Assert.That(Vector2.Distance(Pixel(2, 2), from), Is.LessThan(0.5f), "still dragging");
        }

        [Test]
        public void Drawing_LeavesTheHandlesOfOthersAsTheyWere()
        {
            Handles.color = Color.magenta;
            Send(EventType.Repaint, Pixel(1, 1));
            Assert.That(Handles.color, Is.EqualTo(Color.magenta));
        }

        [Test]
        public void Keys_AreTaken_WhereTheyMeanSomething()
        {
            Click(Pixel(2, 2));

            Assert.That(Key(KeyCode.J).type, Is.EqualTo(EventType.Used));
            Assert.That(Right.Skeleton.JointsPerChain, Is.EqualTo(6));
            Assert.That(Key(KeyCode.W).type, Is.EqualTo(EventType.KeyDown));
        }

        [Test]
        public void Escape_LetsGoOfTheMouse()
        {
            string before = SkeletonText.Of(Right.Skeleton);
            Send(EventType.MouseDown, Pixel(2, 2));
            Send(EventType.MouseDrag, Pixel(2, 2) + new Vector2(60f, 0f));

            Key(KeyCode.Escape);

            Assert.That(GUIUtility.hotControl, Is.Zero);
            Assert.That(SkeletonText.Of(Right.Skeleton), Is.EqualTo(before));
        }

        [Test]
        public void Framing_ShowsTheSelectedJoints()
        {
            Click(Pixel(0, 4));

            Assert.That(Command(EventType.ValidateCommand, "FrameSelected").type, Is.EqualTo(EventType.Used));
            Assert.That(Command(EventType.ExecuteCommand, "FrameSelected").type, Is.EqualTo(EventType.Used));

            Vector3 tip = Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(0, 4));
            Assert.That(Vector3.Distance(m_View.pivot, tip), Is.LessThan(1e-3f));
            Assert.That(Command(EventType.ValidateCommand, "Copy").type, Is.EqualTo(EventType.ValidateCommand));
        }

        [Test]
        public void SelectAll_IsOnlyDone_WhenTheCommandIsExecuted()
        {
            Command(EventType.ValidateCommand, "SelectAll");
            Assert.That(m_Session.Group.SelectedCount, Is.Zero);
            Command(EventType.ExecuteCommand, "SelectAll");
            Assert.That(m_Session.Group.SelectedCount, Is.EqualTo(50));
        }

        private void Click(Vector2 pixel)
        {
            Send(EventType.MouseDown, pixel);
            Send(EventType.MouseUp, pixel);
        }

        private Event Send(EventType type, Vector2 pixel, EventModifiers modifiers = EventModifiers.None, int button = 0) =>
            Send(new Event { type = type, mousePosition = pixel, modifiers = modifiers, button = button, clickCount = 1 });

        private Event Key(KeyCode key) => Send(new Event { type = EventType.KeyDown, keyCode = key });

        private Event Command(EventType type, string name) => Send(new Event { type = type, commandName = name });

        private Event Send(Event sent)
        {
            m_Scene.Send(sent, now => m_Gui.OnGUI(m_View, m_Session));
            return sent;
        }

        private Vector2 Pixel(int chain, int joint) =>
            m_Eye.Project(Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(chain, joint)));
    }
}
