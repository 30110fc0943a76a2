using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Editor;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Laws of the picture of a baked loop: its eye, its scale, and what lies between two frames.</summary>
public sealed class LoopPreviewLaws
{
    private static readonly Rect s_Area = new(10f, 20f, 300f, 180f);
    private InsectBake m_Bake;
    private LoopPreview m_Preview;

    [OneTimeSetUp]
    public void Bake()
    {
        ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
        InsectWings insect = InsectFactory.Create("firefly");
        m_Bake = InsectBaker.Bake(insect, [BakeMotion.Find("rest"), BakeMotion.Find("cruise")], new BakeSettings(12));
        m_Preview = new LoopPreview(m_Bake);
        Object.DestroyImmediate(insect.gameObject);
        ProjectShaders.Clear();
    }

    // Turned about the vertical by half a radian, then down by 0.45; the sphere about the bounds is 95 % of the smaller side.
    [Test]
    public void AJoint_IsSeenFromTheSideAndAbove_TheMiddleOfTheBoundsInTheMiddleOfTheWindow([Values(0, 5)] int frame)
    {
        float reach = m_Bake.Bounds.extents.magnitude, scale = 0.5f * 0.95f * s_Area.height / reach;
        BakedFrame baked = m_Bake.Clips[1].Frames[frame];
        Vector3[] drawn = [.. Chains(1, frame / 12f).SelectMany(line => line)];
        float3[] joints = [.. m_Bake.Wings.SelectMany(wing => Enumerable.Range(wing.FirstJoint, wing.RestJoints.Length))
            .Select(joint => baked.Joints[joint].position - (float3)m_Bake.Bounds.center)];

        Assert.That(drawn, Has.Length.EqualTo(joints.Length));
        for (int k = 0; k < drawn.Length; k++)
        {
            (float3 at, float turn, float down) = (joints[k], 0.5f, 0.45f);
            float right = math.cos(turn) * at.x + math.sin(turn) * at.z, ahead = math.cos(turn) * at.z - math.sin(turn) * at.x;
            float up = math.cos(down) * at.y - math.sin(down) * ahead;
            Assert.That(drawn[k].x, Is.EqualTo(s_Area.center.x + scale * right).Within(0.01f), $"joint {k}");
            Assert.That(drawn[k].y, Is.EqualTo(s_Area.center.y - scale * up).Within(0.01f), $"joint {k}");
        }
    }

    [Test]
    public void BetweenTwoFrames_JointsAreOnTheWay_FromTheLastToTheFirstToo([Values(0, 4, 11)] int frame)
    {
        Vector3[] from = All(frame / 12f), to = All((frame + 1) % 12 / 12f), between = All((frame + 0.25f) / 12f);
        for (int k = 0; k < from.Length; k++)
            Assert.That((between[k] - Vector3.Lerp(from[k], to[k], 0.25f)).magnitude, Is.LessThan(0.01f));
        Assert.That(from.Zip(to, Vector3.Distance).Max(), Is.GreaterThan(1f), "it moves");
        Vector3[] later = All((frame + 0.25f) / 12f - 3f);
        Assert.That(later.Zip(between, Vector3.Distance).Max(), Is.LessThan(0.01f), "a loop");
    }

    [Test]
    public void ARim_GoesThroughTheTipsOfItsWingsChains()
    {
        List<(Vector3[] points, bool isRim)> lines = m_Preview.Lines(s_Area, 1, 0.3f);
        int at = 0;
        foreach (BakedWing wing in m_Bake.Wings)
        {
            int chains = wing.RestJoints.Length / wing.JointsPerChain;
            Assert.That(lines.Skip(at).Take(chains + 1).Select(line => line.isRim),
                Is.EqualTo(Enumerable.Repeat(false, chains).Append(true)));
            Assert.That(lines[at + chains].points, Is.EqualTo(lines.Skip(at).Take(chains).Select(line => line.points[^1])));
            Assert.That(lines.Skip(at).Take(chains).Select(line => line.points.Length), Is.All.EqualTo(wing.JointsPerChain));
            at += chains + 1;
        }

        Assert.That(lines, Has.Count.EqualTo(at));
    }

    [Test]
    public void LinesAreTwoPixelsWide_ChainsWarm_RimsCold_OverADarkGround()
    {
        List<(Color Colour, Vector3[] Points)> drawn = [];
        DrawnInspector page;
        try
        {
            (DrawnLines.Calls, DrawnLines.Widths) = ([], []);
            page = DrawnInspector.Of(() =>
            {
                Rect area = UnityEditor.EditorGUILayout.GetControlRect(false, 180f);
                if (Event.current.type == EventType.Repaint)
                    m_Preview.Draw(area, 0, 0f);
            });
            drawn = DrawnLines.Calls;
            Assert.That(DrawnLines.Widths, Has.Count.EqualTo(drawn.Count).And.All.EqualTo(2f));
        }
        finally
        {
            (DrawnLines.Calls, DrawnLines.Widths) = (null, null);
        }

        List<(Vector3[] points, bool isRim)> lines = m_Preview.Lines(page.Controls.Single().Place, 0, 0f);
        Assert.That(drawn.Select(line => line.Points), Is.EqualTo(lines.Select(line => line.points)));
        Assert.That(drawn.Select(line => line.Colour.b > line.Colour.r), Is.EqualTo(lines.Select(line => line.isRim)));
        Assert.That(page.Controls.Single().Value, Is.EqualTo(new Color(0.16f, 0.16f, 0.16f).ToString()));
    }

    private IEnumerable<Vector3[]> Chains(int clip, float phase) =>
        m_Preview.Lines(s_Area, clip, phase).Where(line => !line.isRim).Select(line => line.points);

    private Vector3[] All(float phase) => [.. Chains(1, phase).SelectMany(line => line)];
}
