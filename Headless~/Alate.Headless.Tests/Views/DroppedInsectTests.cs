using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Alate.Cli;
using NUnit.Framework;
using OwnWing = Alate.Tests.Cli.OwnWing;

namespace Alate.Tests.Views;

/// <summary>Insect files that are dropped on the page with what they name.</summary>
public sealed class DroppedInsectTests : ViewFixture
{
    private const string k_File = """
        { "version": 1, "name": "mine", "displayName": "My moth", "like": "monarch",
          "wings": { "wing": { "mesh": "MESH", "skeleton": "wing.json" } } }
        """;

    private readonly string m_Mesh = OwnWing.Obj(), m_Skeleton = OwnWing.Skeleton();
    private readonly int m_Triangles = TestWings.Ellipse().triangles.Length;

    private static string Shapes(string mesh = "shapes/wing.obj") => k_File.Replace("MESH", mesh);

    [Test]
    public void AnInsectFile_FliesWithItsFiles_AndIsInTheListFromThenOn() => Fly(async () =>
    {
        await using ViewClient page = await ViewClient.Open(Server);
        await page.Read("scene");
        await page.Say("{\"files\":[\"wing.json\",\"mine.insect.json\",\"wing.obj\"]}");
        foreach (string text in new[] { m_Skeleton, Shapes(), m_Mesh })
            await page.Give(Encoding.UTF8.GetBytes(text));
        JsonElement known = (await page.Read("hello")).GetProperty("species"), scene = await page.Read("scene");

        Assert.That((known[0].GetProperty("name").GetString(), known.GetArrayLength()), Is.EqualTo(("mine", 8)), "before the seven others");
        Assert.That((scene.GetProperty("title").GetString(), scene.GetProperty("own").GetBoolean()), Is.EqualTo(("My moth", false)));
        int[] triangles = System.Runtime.InteropServices.MemoryMarshal.Cast<byte, int>(
            Convert.FromBase64String(scene.GetProperty("wings")[0].GetProperty("triangles").GetString())).ToArray();
        Assert.That(triangles, Has.Length.EqualTo(m_Triangles), "its own mesh");

        await page.Say("{\"species\":\"fishfly\"}");
        Assert.That((await page.Read("scene")).GetProperty("name").GetString(), Is.EqualTo("fishfly"));
        await page.Say("{\"species\":\"mine\"}");
        Assert.That((await page.Read("scene")).GetProperty("name").GetString(), Is.EqualTo("mine"));
    });

    [Test]
    public void AnotherPage_DoesNotKnowTheInsect() => Fly(async () =>
    {
        await using ViewClient page = await ViewClient.Open(Server), other = await ViewClient.Open(Server);
        await page.Say("{\"files\":[\"mine.json\"]}");
        await page.Give(Encoding.UTF8.GetBytes("{ \"version\": 1, \"name\": \"mine\", \"like\": \"firefly\" }"));
        await page.Read("scene");
        Assert.That((await page.Read("scene")).GetProperty("name").GetString(), Is.EqualTo("mine"));
        await other.Say("{\"species\":\"mine\"}");
        Assert.That((await other.Read("error")).GetProperty("message").GetString(), Does.Contain("Unknown species 'mine'"));
    });

    [TestCase("wing.obj", "wing.json", "mine.insect.json: it names 'shapes/wing.obj'. Drop that file together with it.", "other.obj")]
    [TestCase("../../wing.obj", "wing.json", "'../../wing.obj' lies outside of the folder of the insect file", "wing.obj")]
    [TestCase("/etc/wing.obj", "wing.json", "'/etc/wing.obj' lies outside of the folder of the insect file", "wing.obj")]
    [TestCase(
        "wing.obj", "wing.json", "wing.obj: it names '../../picture.mtl' outside of its folder", "wing.obj", "mtllib ../../picture.mtl\n")]
    [TestCase("wing.obj", "wing.json", "wing.obj: line 2", "wing.obj", "v 0 0 0\nf 1 2 9\n")]
    public void WhatIsMissingOrElsewhere_IsSaid_WithoutTheFolderOfTheServer(
        string mesh, string skeleton, string message, string given, string obj = null)
    {
        var insect = new DroppedFile("mine.insect.json", Encoding.UTF8.GetBytes(given == "other.obj" ? Shapes() : Shapes(mesh)));
        var files = new List<DroppedFile>
        {
            insect, new(skeleton, Encoding.UTF8.GetBytes(m_Skeleton)), new(given, Encoding.UTF8.GetBytes(obj ?? m_Mesh)),
        };
        int before = Folders();

        UserException problem = Assert.Throws<UserException>(() => DroppedInsect.Read(insect, files));
        Assert.That(problem.Message, Does.StartWith(message).Or.Contain(message));
        Assert.That(problem.Message, Does.Not.Contain(Path.GetTempPath()));
        Assert.That(Folders(), Is.EqualTo(before), "nothing is left");
    }

    [Test]
    public void WrongKeys_AreSaidByTheReader_AndTooManyFilesEndThePage() => Fly(async () =>
    {
        await using ViewClient page = await ViewClient.Open(Server);
        await page.Say("{\"files\":[\"mine.insect.json\"]}");
        await page.Give(Encoding.UTF8.GetBytes("{ \"version\": 1,\n \"name\": \"mine\", \"like\": \"firefly\", \"mass\": 3 }"));
        string message = (await page.Read("error")).GetProperty("message").GetString();
        Assert.That(message, Does.StartWith("mine.insect.json: line 2").And.Contain("mass"));

        await page.Say("{\"files\":[\"a.obj\",\"b.obj\"]}");
        await page.Give(Encoding.UTF8.GetBytes(m_Mesh));
        await page.Give(Encoding.UTF8.GetBytes(m_Mesh));
        message = (await page.Read("error")).GetProperty("message").GetString();
        Assert.That(message, Does.StartWith("Drop one wing, or one insect file (NAME.insect.json)"));

        await page.Say($"{{\"files\":[{string.Join(',', Enumerable.Repeat("\"x.obj\"", ViewRequest.MostFiles + 1))}]}}");
        await page.ReadClose();
        Assert.That(page.Reason, Is.EqualTo($"A message of this page names 1 to {ViewRequest.MostFiles} files."));
    });

    [Test]
    public void TheInsectFile_IsFoundByItsName()
    {
        static string Found(params string[] names) => DroppedInsect.Find(names.Select(name => new DroppedFile(name, [])).ToList())?.Name;

        Assert.That(Found("wing.json", "a.insect.json", "wing.obj"), Is.EqualTo("a.insect.json"));
        Assert.That(Found("a.json", "wing.obj"), Is.EqualTo("a.json"));
        Assert.That(Found("a.insect.json", "b.insect.json"), Is.Null);
        Assert.That(Found("wing.obj"), Is.Null);
    }

    private static int Folders() => Directory.GetDirectories(Path.GetTempPath(), "alate-dropped-*").Length;
}
