using System;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Alate.Cli;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Views;

/// <summary>
/// The page of a sample scene in Chromium, against the real server. Skipped where Chromium, Node or its packages are missing.
/// </summary>
[Explicit]
[Category("Long")]
public sealed class SceneBrowserTests
{
    private TemporaryFolder m_Folder;

    [SetUp]
    public void Prepare()
    {
        WebTools.NeedChromium();
        WebTools.NeedNode();
        m_Folder = new TemporaryFolder();
    }

    [TearDown]
    public void Remove() => m_Folder?.Dispose();

    [Test]
    public void Page_DoesWhatItSays() =>
        Try("garden", "plays", "rate", "hand", "panel", "pause", "link", "scenes", "access", "phone", "memory");

    // The same moment in the page and by the painter of the films, which has the package's own light: no channel of the mean pixel is off
    // by 6 % of the range.
    [TestCase("garden")]
    [TestCase("insects")]
    [TestCase("meadow")]
    public void ThePicture_IsThePaintersPicture(string scene)
    {
        Color32[] painted = null;
        int2 size = default;
        Try(scene, async server =>
        {
            while (!File.Exists(m_Folder.PathOf("shown")))
                await Task.Delay(50);
            var canvas = PngFile.Read(File.ReadAllBytes(m_Folder.PathOf("canvas.png")));
            size = new int2(canvas.Width, canvas.Height);
            painted = await server.Simulation.Do(() => new SceneReader().Shot(Camera.main, size).Paint());
            File.WriteAllText(m_Folder.PathOf("painted"), "");
        }, "painter");
        Color32[] shown = PngFile.Read(File.ReadAllBytes(m_Folder.PathOf("canvas.png"))).Pixels;

        double Difference(Func<Color32, int> channel) =>
            shown.Zip(painted, (one, other) => Math.Abs(channel(one) - channel(other)) / 255.0).Average();
        double[] mean = [Difference(pixel => pixel.r), Difference(pixel => pixel.g), Difference(pixel => pixel.b)];
        TestContext.Out.WriteLine($"{scene}, {size.x} × {size.y}: red {mean[0]:P2}, green {mean[1]:P2}, blue {mean[2]:P2}");
        Assert.That(mean, Is.All.LessThan(0.06));
        Assert.That(painted.Distinct().Count(), Is.GreaterThan(500));
    }

    [Test]
    public void ThePageOfTheManual_IsThatOfToday()
    {
        Try("garden", "picture");
        ManualPage.Compare(m_Folder.PathOf("page.png"), "scene-view.png");
    }

    private void Try(string scene, params string[] cases) => Try(scene, _ => Task.CompletedTask, cases);

    private void Try(string scene, Func<ViewServer, Task> beside, params string[] cases)
    {
        ViewServer server = ViewServer.Start(new SampleView(SampleScene.Find(scene)), 0, ThreeSource.Find()).GetAwaiter().GetResult();
        Task<(int Code, string Output)> run = Task.Run(
            () => WebTools.Run("scene.mjs", [server.Address.ToString(), WebTools.Chromium, m_Folder.Root, .. cases]));
        server.Simulation.RunUntil(Task.WhenAny(run, Task.Run(() => beside(server))));
        server.Simulation.RunUntil(run);
        server.Simulation.RunUntil(server.Stop());
        TestContext.Out.Write(run.Result.Output);
        Assert.That(run.Result.Code, Is.Zero, string.Join('\n', run.Result.Output.Split('\n').Where(line => !line.StartsWith("ok"))));
    }
}
