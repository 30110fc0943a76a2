using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>The tool and the inspector that edit skeletons in the scene view: when their session begins, and when it ends.</summary>
public sealed class WingSkeletonToolTests : SkeletonSessionFixture
{
    private readonly View m_Eye = new(new Vector3(3f, 9f, -2f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
    private WingSkeletonTool m_Tool;
    private SceneView m_View;
    private SceneEye m_Scene;

    [SetUp]
    public void TakeUp()
    {
        m_Scene = new SceneEye(m_Eye.Project, m_Eye.Through);
        m_View = Keep(ScriptableObject.CreateInstance<SceneView>());
        m_Tool = Keep(ScriptableObject.CreateInstance<WingSkeletonTool>());
        ChosenTargets.All.AddRange([Insect, m_View]);
    }

    [TearDown]
    public void PutDown()
    {
        m_Tool.OnWillBeDeactivated();
        ChosenTargets.All.Clear();
        m_Scene.Dispose();
        SceneViews.LastActive = null;
        DrawnLines.Calls = null;
        GUIUtility.hotControl = 0;
        Undo.ClearAll();
    }

    [Test]
    public void TheSession_LastsAsLongAsTheToolIsTaken_AndIsOfTheChosenInsects()
    {
        Assert.That(SkeletonSessions.Current, Is.Null);
        m_Tool.OnActivated();
        SkeletonSession session = SkeletonSessions.Current;
        Assert.That(session.Group.All.Select(editing => editing.Skeleton), Is.EqualTo(new[] { Right.Skeleton, Left.Skeleton }));
        Draw();
        Assert.That(SkeletonSessions.Current, Is.SameAs(session), "nothing has changed");
        m_Tool.OnWillBeDeactivated();
        Assert.That(SkeletonSessions.Current, Is.Null);
        m_Tool.OnActivated();
        Object.DestroyImmediate(m_Tool);
        Assert.That(SkeletonSessions.Current, Is.Null, "reloaded");
    }

    [Test]
    public void ItBeginsAnew_WhereWingsChange_OrAnotherSessionWasOpened_OrASkeletonIsGone()
    {
        m_Tool.OnActivated();
        SkeletonSession first = SkeletonSessions.Current;
        Insect.Wings.Remove(Left);
        Draw();
        Assert.That(SkeletonSessions.Current.Group.All, Has.Count.EqualTo(1));
        Assert.That(SkeletonSessions.Current, Is.Not.SameAs(first));
        Insect.Wings.Add(Left);
        Draw();
        Assert.That(SkeletonSessions.Current.Group.All, Has.Count.EqualTo(2));

        SkeletonSession other = SkeletonSessions.Open([]);
        Draw();
        Assert.That(SkeletonSessions.Current, Is.Not.SameAs(other));
        Assert.That(SkeletonSessions.Current.Group.All, Has.Count.EqualTo(2));
        SkeletonSession before = SkeletonSessions.Current;
        Object.DestroyImmediate(Left.Renderer.gameObject);
        Draw();
        Assert.That(SkeletonSessions.Current, Is.Not.SameAs(before));
        Assert.That(SkeletonSessions.Current.IsStale(), Is.False);
    }

    [Test]
    public void ItDrawsInSceneViewsAlone()
    {
        m_Tool.OnActivated();
        DrawnLines.Calls = [];
        Draw(Keep(ScriptableObject.CreateInstance<OtherWindow>()));
        Assert.That(DrawnLines.Calls, Is.Empty);
        Draw();
        Assert.That(DrawnLines.Calls, Is.Not.Empty);
    }

    [Test]
    public void SessionsAreSeen_WhenTheyBeginAndEnd_AndPanelsWhenTheyChange()
    {
        int changes = 0, repaints = SceneViews.Repaints;
        void Count() => changes++;
        SkeletonSessions.Changed += Count;
        m_Tool.OnActivated();
        Assert.That((changes, SceneViews.Repaints - repaints), Is.EqualTo((1, 1)));
        m_Tool.OnWillBeDeactivated();
        Assert.That((changes, SceneViews.Repaints - repaints), Is.EqualTo((2, 2)));
        SkeletonSessions.Changed -= Count;
        m_Tool.OnActivated();
        repaints = SceneViews.Repaints;
        Undo.IncrementCurrentGroup();
        Undo.RecordObject(Right.Skeleton, "x");
        Right.Skeleton.Hinge += Vector3.up;
        Undo.PerformUndo();
        Assert.That(SceneViews.Repaints, Is.EqualTo(repaints + 1), "undone");
    }

    [Test]
    public void AnInspectorThatEdits_DrawsItsSkeletonInSceneViews_UntilItIsClosed()
    {
        var editor = UnityEditor.Editor.CreateEditor(Right.Skeleton);
        try
        {
            Assert.That(InScenes(), Is.Zero);
            DrawnInspector.Press(editor, "Edit In Scene View");
            Assert.That(SkeletonSessions.Current.Group.All.Single().Skeleton, Is.SameAs(Right.Skeleton));
            Assert.That(InScenes(), Is.Positive);
            DrawnInspector.Press(editor, "Edit In Scene View");
            Assert.That((SkeletonSessions.Current == null, InScenes()), Is.EqualTo((true, 0)));
            DrawnInspector.Press(editor, "Edit In Scene View");
        }
        finally
        {
            Object.DestroyImmediate(editor);
        }

        Assert.That((SkeletonSessions.Current == null, InScenes()), Is.EqualTo((true, 0)), "closed");
    }

    [Test]
    public void AProblemThatIsPressed_IsFramedInTheViewThatWasActiveLast()
    {
        m_Tool.OnActivated();
        SceneViews.LastActive = m_View;
        SkeletonSession session = SkeletonSessions.Current;
        JointIndex[] joints = [new(1, 2), new(1, 3)];
        SkeletonPanel.Show(session, session.Group.All[1], joints);
        Assert.That(session.Group.Active, Is.SameAs(session.Group.All[1]));
        Assert.That(session.Group.Active.Selection.Living(), Is.EqualTo(joints));
        Assert.That(m_View.pivot, Is.EqualTo(session.SelectedBounds().center));
        Assert.That(m_View.size, Is.EqualTo(session.SelectedBounds().extents.magnitude));
    }

    private sealed class OtherWindow : EditorWindow
    {
    }

    private int InScenes()
    {
        DrawnLines.Calls = [];
        m_Scene.Send(new Event { type = EventType.Repaint }, _ => SceneViews.Draw(m_View));
        return DrawnLines.Calls.Count;
    }

    private void Draw(EditorWindow window = null) =>
        m_Scene.Send(new Event { type = EventType.Repaint }, _ => m_Tool.OnToolGUI(window == null ? m_View : window));
}
