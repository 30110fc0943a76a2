using System;
using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Formats;
using NUnit.Framework;
using Unity.StandIns;

namespace Alate.Tests.Views;

/// <summary>Pictures of pages in the manual.</summary>
internal static class ManualPage
{
    /// <summary>
    /// Asserts that a picture of the manual shows a page as it is now. With ALATE_WRITE_FIGURES=1 it is written, in 255 colours.
    /// </summary>
    /// <param name="shown">Picture of the page.</param>
    /// <param name="name">File among the images of the manual.</param>
    public static void Compare(string shown, string name)
    {
        string path = Path.Combine(PackageRoot.Find(), "Documentation~", "images", name);
        var now = PngFile.Read(File.ReadAllBytes(shown));
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
            File.WriteAllBytes(path, IndexedPng.Write(now.Width, now.Height, [now.Pixels], 1, true, []));
        var told = PngFile.Read(File.ReadAllBytes(path));

        Assert.That((told.Width, told.Height), Is.EqualTo((now.Width, now.Height)));
        double off = told.Pixels.Zip(now.Pixels, (one, other) => Math.Abs(one.g - other.g) / 255.0).Average();
        TestContext.Out.WriteLine($"{name}: {off:P2} of the range");
        Assert.That(off, Is.LessThan(0.04), "ALATE_WRITE_FIGURES=1 writes it.");
        Assert.That(new FileInfo(path).Length, Is.LessThan(400_000));
    }
}
