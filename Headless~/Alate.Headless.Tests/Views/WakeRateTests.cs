using System;
using System.Diagnostics;
using System.Threading.Tasks;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Views;

/// <summary>States in a second, with a wake and without.</summary>
[Explicit]
[Category("Long")]
public sealed class WakeRateTests : ViewFixture
{
    [Test]
    public void AWake_LeavesThePageItsStates(
        [Values("monarch", "dragonfly")] string species, [Values(false, true)] bool isFast, [Values(false, true)] bool isCompared)
    {
        double without = 0.0, with = 0.0;
        int sheets = 0;
        Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say($"{{\"species\":\"{species}\",\"compare\":{(isCompared ? "true" : "false")}}}");
            await page.Read("scene");
            await page.Read("scene");
            if (isFast)
                await page.Say("{\"values\":{\"slow\":1}}");
            // By turns, and the best of each: other programs slow both.
            for (int turn = 0; turn < 2; turn++)
            {
                await page.Say("{\"wake\":false}");
                await Rate(page, 30);
                without = Math.Max(without, await Rate(page));
                await page.Say("{\"wake\":true}");
                await Rate(page, 60);
                with = Math.Max(with, await Rate(page));
                sheets = (await page.ReadState()).Sheets[0].Count;
            }
        });
        TestContext.Out.WriteLine($"{species}, fast {isFast}, four columns {isCompared}: {without:0.0} and {with:0.0} states/s, "
            + $"{sheets} sheets");
        Assert.That(sheets, Is.GreaterThan(0));
        Assert.That(with, Is.GreaterThan(0.9 * without));
    }

    [Test]
    public void Steps_TakeTheirTime([Values("monarch", "dragonfly", "fishfly")] string species)
    {
        using LiveFlight flight = LiveWakeTests.Start(species);
        LiveWakeTests.Beat(flight, 3.0);
        (long count, TimeSpan time) = flight.Wake.Steps;
        LiveWakeTests.Beat(flight, 3.0);
        count = flight.Wake.Steps.Count - count;
        time = flight.Wake.Steps.Time - time;
        TestContext.Out.WriteLine($"{species}: {time.TotalMilliseconds / count:0.00} ms a step, {count} steps");
        Assert.That(count, Is.InRange(70, 74));
    }

    private static async Task<double> Rate(ViewClient page, int states = 90)
    {
        await page.ReadState();
        long start = Stopwatch.GetTimestamp();
        for (int k = 0; k < states; k++)
            await page.ReadBinary();
        return states / Stopwatch.GetElapsedTime(start).TotalSeconds;
    }
}
