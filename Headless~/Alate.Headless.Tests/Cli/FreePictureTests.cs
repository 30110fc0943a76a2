using System;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Frames of a film of a free flight.</summary>
public sealed class FreePictureTests
{
    [Test]
    public void AFilmOfAFreeFlight_LooksAheadInItsMiddle_AndItsTrailIsWhereTheInsectWas()
    {
        const int frames = 12, beats = 2;
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        var film = FreeStretch.Fly(
            new FilmPlan { Flight = FlightPlan.Cruise(monarch, InsectVariant.Flight), IsFree = true, Frames = frames, Beats = beats });
        FilmMoment[] moments = Enumerable.Range(0, beats * frames).Select(film.At).ToArray();
        float3 ahead = math.rotate(moments[frames * beats / 2].Turn, new float3(0f, 0f, 1f));

        Assert.That(Math.Atan2(ahead.x, ahead.z), Is.EqualTo(0.0).Within(0.02), "seen as if it looked ahead");
        for (int k = 1; k < moments.Length; k++)
        {
            double turned = moments[k].Turns - moments[k - 1].Turns;
            Assert.That(turned - Math.Floor(turned), Is.EqualTo(1.0 / frames).Within(0.02), "a beat has so many frames");
            Assert.That(math.length(moments[k].Way), Is.LessThan(0.05f), "the camera goes along");
            Assert.That(moments[k].Trail, Has.Count.InRange(3 * 8, (3 + beats) * frames));
        }

        // Dots stay where they are in the world: from frame to frame all move alike, as the camera does, and the last is a place of the
        // insect.
        for (int k = 1; k < moments.Length; k++)
        {
            float3 moved = moments[k].Trail[0] - moments[k - 1].Trail[0];
            for (int dot = 1; dot < moments[k - 1].Trail.Count; dot++)
                Assert.That(math.distance(moments[k].Trail[dot] - moments[k - 1].Trail[dot], moved), Is.LessThan(1e-4f));
            if (moments[k].Trail.Count > moments[k - 1].Trail.Count)
            {
                Assert.That(math.distance(moments[k].Trail[^1], moments[k - 1].Way + moved), Is.LessThan(1e-4f),
                    "the last dot is where the insect was a frame ago");
            }
        }
    }
}
