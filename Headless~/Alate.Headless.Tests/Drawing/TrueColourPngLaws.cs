using System;
using System.Linq;
using System.Text;
using Alate.Formats;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Still pictures of 24 bits, read back by the decoder of the stand-ins, which knows nothing of the writer.</summary>
public sealed class TrueColourPngLaws
{
    // Noise, slopes and plain rows: each kind is packed by other filters.
    [Test]
    public void APicture_IsReadAsItWasWritten()
    {
        Arbitrary<(int Width, int Height, int Seed)> sizes = Gen.Choose(1, 40).SelectMany(width => Gen.Choose(1, 20)
            .SelectMany(height => Gen.Choose(0, 1 << 20).Select(seed => (width, height, seed)))).ToArbitrary();
        Prop.ForAll(sizes, size =>
        {
            var random = new System.Random(size.Seed);
            int[] kinds = [.. Enumerable.Range(0, size.Height).Select(_ => random.Next(4))];
            Color32[] pixels = [.. Enumerable.Range(0, size.Width * size.Height).Select(k =>
            {
                int x = k % size.Width, y = k / size.Width;
                return kinds[y] switch
                {
                    0 => new Color32((byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256), 255),
                    1 => new Color32((byte)(7 * x + 3 * y), (byte)(250 - 5 * x), (byte)(11 * y), 255),
                    2 => new Color32(247, 244, 236, 255),
                    _ => new Color32((byte)(x * x), (byte)(3 * x), (byte)(x ^ y), 255),
                };
            })];
            var read = PngFile.Read(TrueColourPng.Write(size.Width, size.Height, pixels, []));
            return (read.Width, read.Height) == (size.Width, size.Height) && read.Pixels.SequenceEqual(pixels);
        }).Check(FixedRuns.Of());
    }

    [Test]
    public void WhatAPictureSays_StandsInTheFile_AndNothingWhereItSaysNothing()
    {
        byte[] said = TrueColourPng.Write(2, 1, new Color32[2], ["A monarch", "3 °"]),
            silent = TrueColourPng.Write(2, 1, new Color32[2], []);

        Assert.That(Encoding.UTF8.GetString(said), Does.Contain("Description\0\0\0\0\0A monarch\n3 °"));
        Assert.That(Encoding.Latin1.GetString(silent), Does.Not.Contain("iTXt"));
    }

    // A filter leaves one number a row of a slope: without one the rows of such a picture hardly pack.
    [Test]
    public void Slopes_PackToLittle()
    {
        const int k_Side = 200;
        Color32[] slope = [.. Enumerable.Range(0, k_Side * k_Side).Select(k =>
            new Color32((byte)(k % k_Side + k / k_Side / 2), (byte)(k % k_Side / 3 + k / k_Side), (byte)(255 - k % k_Side), 255))];

        Assert.That(TrueColourPng.Write(k_Side, k_Side, slope, []), Has.Length.LessThan(3 * k_Side * k_Side / 20));
    }
}
