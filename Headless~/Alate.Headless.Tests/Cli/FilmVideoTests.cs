using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Films as videos: the frames that were painted, and one line where there can be none.</summary>
public sealed class FilmVideoTests
{
    [TestCase("film.avi", "--video takes a file that ends in .mp4 or .webm, not 'film.avi'.")]
    [TestCase("mp4", "--video takes a file that ends in .mp4 or .webm, not 'mp4'.")]
    public void AnotherEnding_IsNamed(string file, string message)
    {
        using var run = new CommandRun();
        Assert.That(run.Run("film", "firefly", "--video", file, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors.Trim(), Does.EndWith(message));
        Assert.That(Directory.Exists(run.Out), Is.False);
    }

    [TestCase("--transparent goes into a video that ends in .webm, not 'film.mp4': H.264 has no opacity.", "--video", "film.mp4")]
    [TestCase("--transparent goes with one insect, not with --compare, whose words need a ground.", "--compare")]
    public void WhatCannotBeSeenThrough_IsNamed(string message, params string[] options)
    {
        using var run = new CommandRun();
        Assert.That(run.Run(["film", "firefly", "--transparent", "--out", run.Out, .. options]), Is.EqualTo(2));
        Assert.That(run.Errors.Trim(), Does.EndWith(message));
        Assert.That(Directory.Exists(run.Out), Is.False);
    }

    [TestCase("--compare")]
    [TestCase("--transparent")]
    public void AWallBehindInsects_IsBehindOne_AndNotSeenThrough(string option)
    {
        using var run = new CommandRun();
        Assert.That(run.Run("film", "firefly", "--backdrop", "dark", option, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors.Trim(),
            Does.EndWith("--backdrop is a wall behind one insect; it goes neither with --compare nor with --transparent."));
        Assert.That(Directory.Exists(run.Out), Is.False);
    }

    [Test]
    public void WithoutTheProgram_OneLineSaysWhatToDo_BeforeAnythingIsFlown()
    {
        using var run = new CommandRun();
        string path = Environment.GetEnvironmentVariable("PATH"), file = Path.Combine(run.Folder, "film.mp4");
        try
        {
            Environment.SetEnvironmentVariable("PATH", run.Folder);
            Assert.That(run.Run("film", "firefly", "--video", file, "--out", run.Out), Is.EqualTo(2));
        }
        finally
        {
            Environment.SetEnvironmentVariable("PATH", path);
        }

        Assert.That(run.Errors.Trim(), Does.StartWith("alate: --video needs the program ffmpeg").And.Not.Contain("\n"));
        Assert.That((File.Exists(file), Directory.Exists(run.Out)), Is.EqualTo((false, false)));
    }

    [TestCase("film.mp4")]
    [TestCase("film.WEBM")]
    [Explicit]
    [Category("Long")]
    public void AVideo_HasTheFramesThatWerePainted_AndTheSound(string name)
    {
        IgnoreWithoutTheProgram();
        Film film = Flown(false);
        Color32[][] frames = film.Draw(_ => { });
        using var folder = new TemporaryFolder();
        using var sound = new MemoryStream();
        Alate.Formats.WavFile.Write(sound, film.Sound(), BeatSound.Rate);
        FilmVideo.Write(folder.PathOf(name), film.Size, 12, frames, sound.ToArray());

        byte[] shown = Decoded(folder.PathOf(name), "-f", "rawvideo", "-pix_fmt", "rgba");
        int width = film.Size.x + film.Size.x % 2, height = film.Size.y + film.Size.y % 2;
        Assert.That(shown, Has.Length.EqualTo(4 * width * height * frames.Length), "even sides");
        double off = 0;
        for (int k = 0; k < frames.Length; k++)
        {
            for (int pixel = 0; pixel < frames[k].Length; pixel++)
            {
                int at = 4 * ((k * height + pixel / film.Size.x) * width + pixel % film.Size.x);
                off += Math.Abs(shown[at] - frames[k][pixel].r) + Math.Abs(shown[at + 2] - frames[k][pixel].b);
            }
        }

        Assert.That(off / (2.0 * frames.Length * frames[0].Length), Is.LessThan(3), "of 255, on average");
        double seconds = Decoded(folder.PathOf(name), "-f", "s16le", "-ac", "1", "-ar", "8000").Length / 16000.0;
        Assert.That(seconds, Is.EqualTo(0.5).Within(0.1), "six frames, twelve a second");
    }

    [Test, Explicit, Category("Long")]
    public void AVideoThatIsSeenThrough_HasTheOpacitiesOfItsFrames()
    {
        IgnoreWithoutTheProgram();
        Film film = Flown(true);
        Color32[][] frames = film.Draw(_ => { });
        using var folder = new TemporaryFolder();
        FilmVideo.Write(folder.PathOf("film.webm"), film.Size, 12, frames, null, isTransparent: true);

        // The program's own decoder leaves the opacity out.
        byte[] shown = Decoded(folder.PathOf("film.webm"), ["-c:v", "libvpx-vp9"], "-f", "rawvideo", "-pix_fmt", "rgba");
        int width = film.Size.x + film.Size.x % 2, height = film.Size.y + film.Size.y % 2;
        Assert.That(shown, Has.Length.EqualTo(4 * width * height * frames.Length));
        double off = 0;
        for (int k = 0; k < frames.Length; k++)
        {
            for (int pixel = 0; pixel < frames[k].Length; pixel++)
            {
                int at = 4 * ((k * height + pixel / film.Size.x) * width + pixel % film.Size.x);
                off += Math.Abs(shown[at + 3] - frames[k][pixel].a);
            }
        }

        Assert.That(off / (frames.Length * frames[0].Length), Is.LessThan(3), "of 255, on average");
        Assert.That(frames[0].Count(pixel => pixel.a == 0), Is.GreaterThan(frames[0].Length / 3));
        Assert.That(frames[0].Count(pixel => pixel.a == 255), Is.GreaterThan(frames[0].Length / 50));
    }

    private static void IgnoreWithoutTheProgram()
    {
        string[] programs = Environment.GetEnvironmentVariable("PATH").Split(Path.PathSeparator);
        if (!programs.Any(place => File.Exists(Path.Combine(place, "ffmpeg"))))
            Assert.Ignore("ffmpeg is not installed.");
    }

    private static Film Flown(bool isTransparent) => Film.Fly(new FilmPlan
    {
        Flight = FlightPlan.Cruise(InsectCatalogue.Find("firefly"), InsectVariant.Standard),
        Beats = 1,
        Frames = 6,
        Rate = 12,
        Width = 241,
        IsTransparent = isTransparent,
    });

    private static byte[] Decoded(string file, params string[] form) => Decoded(file, [], form);

    private static byte[] Decoded(string file, string[] decoder, params string[] form)
    {
        using var process = Process.Start(new ProcessStartInfo("ffmpeg", ["-v", "error", .. decoder, "-i", file, .. form, "-"])
        {
            RedirectStandardOutput = true,
        });
        using var content = new MemoryStream();
        process.StandardOutput.BaseStream.CopyTo(content);
        process.WaitForExit();
        return content.ToArray();
    }
}
