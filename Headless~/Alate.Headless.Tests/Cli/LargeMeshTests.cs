using System;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Editor.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Meshes of more triangles than a wing needs.</summary>
public sealed class LargeMeshTests
{
    private static readonly string[] s_Numbers = ["--length", "30mm", "--mass", "100mg", "--frequency", "12Hz"];

    private CommandRun m_Run;

    [SetUp]
    public void Begin() => m_Run = new CommandRun();

    [TearDown]
    public void RemoveFolder() => m_Run.Dispose();

    [Test]
    public void ASmallerMesh_IsOfVerticesOfTheWholeOne_AndKeepsItsShape([Values(200, 1000)] int triangles)
    {
        string file = m_Run.Write("wing.obj", Wing(60, true));
        Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", file, .. s_Numbers, "--triangles", $"{triangles}"]), Is.Zero);
        ObjMesh whole = Read(file), smaller = Read(Path.Combine(m_Run.Out, "wing.obj"));

        Assert.That(smaller.TriangleCount, Is.InRange(triangles / 2, triangles));
        for (int vertex = 0; vertex < smaller.Positions.Length; vertex++)
        {
            int known = Array.IndexOf(whole.Positions, smaller.Positions[vertex]);
            Assert.That(known, Is.GreaterThanOrEqualTo(0));
            Assert.That(smaller.Uvs[vertex], Is.EqualTo(whole.Uvs[known]));
        }

        Assert.That(Area(smaller), Is.EqualTo(Area(whole)).Within(0.01f * Area(whole)));
        Assert.That(m_Run.Output, Does.Contain($"{smaller.TriangleCount} triangles"));
    }

    [Test]
    public void AMeshOfNoMore_StaysAsItIs()
    {
        string file = m_Run.Write("wing.obj", Wing(20, false));
        Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", file, .. s_Numbers, "--triangles", "800"]), Is.Zero, m_Run.Errors);

        Assert.That(File.ReadAllBytes(Path.Combine(m_Run.Out, "wing.obj")), Is.EqualTo(File.ReadAllBytes(file)));
    }

    [Test]
    public void ThePictureOfAWing_IsMeshedWithAsMany()
    {
        string picture = Path.Combine(m_Run.Folder, "wing.png");
        File.WriteAllBytes(picture, PngOf.Picture(
            DrawnWing.Scalloped().In(200).Draw(DrawnKind.Silhouette)));
        Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", picture, .. s_Numbers, "--triangles", "640"]), Is.Zero, m_Run.Errors);

        Assert.That(Read(Path.Combine(m_Run.Out, "wing.obj")).TriangleCount, Is.EqualTo(640));
    }

    [Test]
    public void MoreThanAWingTakes_AreRefused_WithTheWayOut()
    {
        string file = m_Run.Write("wing.obj", Wing(320, false)), skeleton = m_Run.Write("wing.json", OwnWing.Skeleton());
        string found = $"{file} has 204800 triangles; at most 200000 are taken.";

        Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", file, .. s_Numbers]), Is.EqualTo(2));
        Assert.That(m_Run.Errors.Trim(), Is.EqualTo($"alate: {found} --triangles N writes a smaller mesh; 5000 show all of most wings."));
        Assert.That(m_Run.Run("fly", "--mesh", file, "--skeleton", skeleton, "--species", "monarch", "--out", m_Run.Out), Is.EqualTo(2));
        Assert.That(m_Run.Errors.Trim(), Does.EndWith($"alate: {found} 'insect new --triangles N' writes a smaller mesh."));
        Assert.That(Directory.Exists(m_Run.Out), Is.False);
    }

    [Test]
    public void ABodyOfMore_IsRefused_WithItsLine()
    {
        m_Run.Write("body.obj", Wing(320, false));
        string insect = m_Run.Write(
            "own.insect.json",
            "{\n\"version\": 1, \"name\": \"own\", \"like\": \"monarch\",\n"
            + "\"body\": { \"mesh\": \"body.obj\", \"meshUnitMillimetres\": 1 }\n}");

        Assert.That(m_Run.Run("fly", insect, "--out", m_Run.Out), Is.EqualTo(2));
        Assert.That(m_Run.Errors, Does.Contain("line 3, body.mesh: body.obj has 204800 triangles; at most 200000 are taken."));
    }

    [Test]
    public void FewerThanTheMarginHas_AreRefused()
    {
        // Each triangle has corners of its own, as along seams.
        ObjMesh whole = Read(m_Run.Write("whole.obj", Wing(10, false)));
        var loose = new StringBuilder();
        foreach (int vertex in whole.Triangles)
        {
            Vector3 place = whole.Positions[vertex];
            loose.Append(FormattableString.Invariant($"v {place.x} {place.y} {place.z}\n"));
        }

        for (int k = 1; k < whole.Triangles.Length; k += 3)
            loose.Append($"f {k} {k + 1} {k + 2}\n");
        string file = m_Run.Write("wing.obj", loose.ToString());
        Assert.That(m_Run.Run(["insect", "new", m_Run.Out, "--wing", file, .. s_Numbers, "--triangles", "60"]), Is.EqualTo(2));
        Assert.That(m_Run.Errors, Does.Contain("No fewer than 198 triangles are left of 200 where margins and seams stay as they are"));
    }

    private static ObjMesh Read(string file)
    {
        using var text = new StreamReader(file);
        return ObjReader.Read(text);
    }

    // A leaf of 2 n² triangles, a little domed, along X.
    private static string Wing(int n, bool hasUvs)
    {
        var text = new StringBuilder();
        for (int i = 0; i <= n; i++)
        {
            for (int j = 0; j <= n; j++)
            {
                double x = (double)i / n, chord = 0.1 + 0.3 * Math.Sin(Math.PI * x), z = chord * (0.3 - (double)j / n);
                text.Append(FormattableString.Invariant($"v {x} {0.1 * x * (1 - x)} {z}\n"));
                if (hasUvs)
                    text.Append(FormattableString.Invariant($"vt {x} {0.5 + z}\n"));
            }
        }

        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                int a = i * (n + 1) + j + 1, b = a + n + 1;
                text.Append($"f {Corner(a)} {Corner(b)} {Corner(b + 1)}\nf {Corner(a)} {Corner(b + 1)} {Corner(a + 1)}\n");
            }
        }

        return text.ToString();

        string Corner(int vertex) => hasUvs ? $"{vertex}/{vertex}" : $"{vertex}";
    }

    private static float Area(ObjMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Sum(k => 0.5f * Vector3.Cross(
        mesh.Positions[mesh.Triangles[3 * k + 1]] - mesh.Positions[mesh.Triangles[3 * k]],
        mesh.Positions[mesh.Triangles[3 * k + 2]] - mesh.Positions[mesh.Triangles[3 * k]]).magnitude);
}
