using System;
using System.Linq;
using System.Net.WebSockets;
using System.Text.Json;
using System.Threading.Tasks;
using Alate.Cli;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Views;

/// <summary>The server of <c>view --scene</c>, with pages without a browser.</summary>
public sealed class SampleServerTests
{
    private ViewServer m_Server;

    [SetUp]
    public void Start()
    {
        var view = new SampleView(SampleScene.Find("monarch")) { Patience = TimeSpan.FromSeconds(1) };
        m_Server = ViewServer.Start(view, 0, ThreeSource.Public).GetAwaiter().GetResult();
    }

    [TearDown]
    public void Stop()
    {
        m_Server.Simulation.RunUntil(m_Server.Stop());
        Assert.That(Application.isPlaying, Is.False, "the sample plays on");
    }

    [Test]
    public void APage_GetsTheSample_ItsStatesAndItsPanel_AndAnotherOne() => Serve(async () =>
    {
        await using ViewClient page = await ViewClient.Open(m_Server);
        JsonElement hello = await page.Read("hello");
        Assert.That(hello.GetProperty("scene").GetString(), Is.EqualTo("monarch"));
        Assert.That(hello.GetProperty("scenes").EnumerateArray().Select(scene => scene.GetProperty("name").GetString()),
            Is.EqualTo(SampleScene.All.Select(scene => scene.Name)));
        Assert.That(hello.GetProperty("scenes")[5].GetProperty("title").GetString(), Is.EqualTo("Your own wing"));
        Assert.That(new SampleState(await page.ReadBinary()).Draws, Is.Not.Empty);
        Assert.That((await page.Read("panel")).GetProperty("paused").GetBoolean(), Is.False);

        await page.Say("{\"scene\":\"desert\"}");
        Assert.That((await page.Read("error")).GetProperty("message").GetString(), Does.Contain("no scene 'desert'"));
        await page.Say("{\"scene\":\"comparison\"}");
        Assert.That((await page.Read("hello")).GetProperty("scene").GetString(), Is.EqualTo("comparison"));
        var first = new SampleState(await page.ReadBinary());
        Assert.That((first.Sequence, first.Meshes.All(mesh => mesh.IsWhole)), Is.EqualTo((1u, true)));
    });

    [Test]
    public void ASecondPage_IsToldToWait_AndOneThatIsLoadedAgainGetsAPlace() => Serve(async () =>
    {
        await using (ViewClient page = await ViewClient.Open(m_Server))
        {
            await page.ReadBinary();
            await using ViewClient other = await ViewClient.Open(m_Server);
            Assert.That((await other.ReadClose(), other.Reason),
                Is.EqualTo((WebSocketCloseStatus.PolicyViolation, "The scene plays on another page; close that one first.")));
        }

        await using ViewClient again = await ViewClient.Open(m_Server);
        Assert.That(new SampleState(await again.ReadBinary()).Sequence, Is.EqualTo(1));
    });

    [TestCase("{\"dance\":true}", "has no 'dance'")]
    [TestCase("x", "none of this page's")]
    public void APageThatBreaksTheRules_IsClosed(string message, string reason) => Serve(async () =>
    {
        await using ViewClient page = await ViewClient.Open(m_Server);
        await page.Say(message);
        Assert.That(await page.ReadClose(), Is.EqualTo(WebSocketCloseStatus.InvalidPayloadData));
        Assert.That(page.Reason, Does.Contain(reason));
    });

    [Test]
    public void AServerWithoutAPage_HasItsSampleAtHand_AndEndsIt()
    {
        m_Server.Simulation.RunUntil(m_Server.Simulation.Do(() => { }));
        Assert.That(Application.isPlaying, "it is made before a page asks");
    }

    private void Serve(Func<Task> clients)
    {
        var run = Task.Run(clients);
        m_Server.Simulation.RunUntil(run);
        run.GetAwaiter().GetResult();
    }
}
