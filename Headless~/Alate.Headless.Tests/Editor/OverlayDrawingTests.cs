using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using Unity.StandIns;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests.Editor;

/// <summary>Meshes, rings and boxes that the tool draws over a wing under edit.</summary>
public sealed class OverlayDrawingTests : SkeletonSessionFixture
{
    private readonly View m_Eye = new(new Vector3(3f, 9f, -2f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
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
        m_Session = SkeletonSessions.Open(InsectTargets.Find([Insect]));
    }

    [TearDown]
    public void Close()
    {
        SkeletonSessions.Close(m_Session);
        m_Scene.Dispose();
        m_Gui.Dispose();
        GUIUtility.hotControl = 0;
        (DrawnMeshes.Calls, DrawnLines.Calls, DrawnLines.Rectangles) = (null, null, null);
        Undo.ClearAll();
    }

    [Test]
    public void ColoursAndBeat_AreDrawnOverTheWing_TheBeatWithItsEdges([Values] bool beat, [Values] bool colours)
    {
        m_Session.Overlay.ShowsBeat = beat;
        m_Session.Overlay.Colours = colours ? RigColourMode.Patch : null;
        DrawnMeshes.Calls = [];
        Send(EventType.Repaint, Vector2.zero);
        var wanted = new List<(Mesh, Color, bool)>();
        if (colours)
            wanted.Add((m_Session.Overlay.ColourMesh, Color.white, false));
        if (beat)
        {
            wanted.Add((m_Session.Overlay.BeatMesh, SkeletonColours.beat, false));
            wanted.Add((m_Session.Overlay.BeatMesh, SkeletonColours.beatEdges, true));
        }

        Assert.That(DrawnMeshes.Calls.Select(call => (call.Mesh, call.Material.GetColor("_Color"), call.Edges)), Is.EqualTo(wanted));
        Assert.That(DrawnMeshes.Calls.Select(call => call.Place), Is.All.EqualTo(Right.Renderer.transform.localToWorldMatrix));
        Assert.That(GL.wireframe, Is.False);
    }

    // Translucent, seen from both sides, hidden by what is before it, hiding nothing, a little nearer than the wing.
    [Test]
    public void TheMaterialOfOverlays_IsTranslucent_AndLiesJustOverTheWing()
    {
        m_Session.Overlay.Colours = RigColourMode.Patch;
        DrawnMeshes.Calls = [];
        Send(EventType.Repaint, Vector2.zero);
        Material material = DrawnMeshes.Calls.Single().Material;

        Assert.That((BlendMode)material.GetFloat("_SrcBlend"), Is.EqualTo(BlendMode.SrcAlpha));
        Assert.That((BlendMode)material.GetFloat("_DstBlend"), Is.EqualTo(BlendMode.OneMinusSrcAlpha));
        Assert.That((CullMode)material.GetFloat("_Cull"), Is.EqualTo(CullMode.Off));
        Assert.That((CompareFunction)material.GetFloat("_ZTest"), Is.EqualTo(CompareFunction.LessEqual));
        Assert.That((material.GetFloat("_ZWrite"), material.GetFloat("_ZBias")), Is.EqualTo((0f, -1f)));
    }

    [Test]
    public void AMaterial_IsMadeOnce_AndGoesWithTheTool_AndComesAgain()
    {
        m_Session.Overlay.Colours = RigColourMode.Patch;
        int before = Resources.FindObjectsOfTypeAll<Material>().Length;
        Send(EventType.Repaint, Vector2.zero);
        Send(EventType.Repaint, Vector2.zero);
        Assert.That(Resources.FindObjectsOfTypeAll<Material>(), Has.Length.EqualTo(before + 1));
        Assert.That(Resources.FindObjectsOfTypeAll<Material>().Count(material => material.hideFlags == HideFlags.HideAndDontSave),
            Is.EqualTo(1));
        m_Gui.Dispose();
        Assert.That(Resources.FindObjectsOfTypeAll<Material>(), Has.Length.EqualTo(before));
        DrawnMeshes.Calls = [];
        Send(EventType.Repaint, Vector2.zero);
        Assert.That(DrawnMeshes.Calls, Has.Count.EqualTo(1));
        DrawnMeshes.Calls.ForEach(call => Object.DestroyImmediate(call.Material));
    }

    [Test]
    public void WeaknessesOfTheActiveWing_AreRinged_WhereTheyAre()
    {
        m_Session.Select(m_Session.Group.Active, [new JointIndex(0, 4), new JointIndex(0, 3)]);
        m_Session.Group.Active.Do("Slide", (draft, selected) => SlideCommands.By(draft, selected, -0.15f));
        m_Session.Place();
        DrawnLines.Calls = [];
        Send(EventType.Repaint, new Vector2(-9000f, 0f));
        Vector3[] wanted = [.. m_Session.Overlay.Problems
            .Select(problem => Right.Renderer.transform.TransformPoint(problem.Position))];

        Assert.That(wanted, Is.Not.Empty);
        Vector3[] rings = [.. DrawnLines.Calls.Where(call => call.Colour == SkeletonColours.problem).Select(call => call.Points[0])];
        Assert.That(rings, Has.Length.EqualTo(wanted.Length));
        for (int k = 0; k < rings.Length; k++)
            Assert.That(Vector3.Distance(rings[k], wanted[k]), Is.LessThan(1e-4f));
    }

    [Test]
    public void ABox_IsDrawnBetweenThePressAndThePointer_InTheViewThatWasPressed([Values(1f, -1f)] float x, [Values(1f, -1f)] float y)
    {
        Vector2 from = new(-9000f, -9000f), to = from + new Vector2(30f * x, 20f * y);
        Send(EventType.MouseDown, from);
        Send(EventType.MouseDrag, to);
        DrawnLines.Rectangles = [];
        Send(EventType.Repaint, to);
        Assert.That(DrawnLines.Rectangles, Is.EqualTo(new[]
        {
            (Rect.MinMaxRect(Mathf.Min(from.x, to.x), Mathf.Min(from.y, to.y), Mathf.Max(from.x, to.x), Mathf.Max(from.y, to.y)),
                SkeletonColours.box, SkeletonColours.boxEdge),
        }));

        DrawnLines.Rectangles.Clear();
        SceneView other = Keep(ScriptableObject.CreateInstance<SceneView>());
        m_Scene.Send(new Event { type = EventType.Repaint, mousePosition = to }, _ => m_Gui.OnGUI(other, m_Session));
        Assert.That(DrawnLines.Rectangles, Is.Empty);
        Send(EventType.MouseUp, to);
        Send(EventType.Repaint, to);
        Assert.That(DrawnLines.Rectangles, Is.Empty, "let go");
    }

    [Test]
    public void TheJointUnderThePointer_IsLarger_WithinTwelvePixels([Values(11.5f, 12.5f)] float off)
    {
        Vector2 pixel = m_Eye.Project(Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(0, 4)));
        Vector2 away = pixel - (Vector2)m_Eye.Project(Right.Renderer.transform.TransformPoint(Right.Skeleton.GetJoint(0, 3)));
        DrawnLines.Calls = [];
        Send(EventType.Repaint, pixel + off * away.normalized);
        Assert.That(DrawnLines.Calls.Count(call => call.Colour == SkeletonColours.hovered), Is.EqualTo(off < 12f ? 1 : 0));
    }

    private void Send(EventType type, Vector2 pixel) => m_Scene.Send(
        new Event { type = type, mousePosition = pixel, clickCount = 1 }, _ => m_Gui.OnGUI(m_View, m_Session));
}
