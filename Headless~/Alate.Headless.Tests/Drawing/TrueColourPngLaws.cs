using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Formats;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Pictures of 24 and 32 bits, read back by the decoder of the stand-ins, which knows nothing of the writer.</summary>
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

    // Frame by frame, taken out of the film as still pictures: each stands in the place of the one before.
    [Test]
    public void AFilmThatIsSeenThrough_HasItsFrames_WithTheirOpacities([Values(1, 3)] int count, [Values] bool repeats)
    {
        var random = new System.Random(6);
        Color32[][] frames = [.. Enumerable.Range(0, count).Select(_ => Enumerable.Range(0, 9 * 7).Select(_ => new Color32(
            (byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256))).ToArray())];
        byte[] film = TrueColourPng.WriteFilm(9, 7, frames, 25, repeats, ["a moth"], hasOpacity: true);
        List<(string Name, byte[] Content)> chunks = Chunks(film);

        Assert.That(chunks.FindAll(chunk => chunk.Name is "IDAT" or "fdAT").Select(chunk => Pixels(chunks[0].Content, chunk)),
            Is.EqualTo(frames));
        if (count == 1)
        {
            Assert.That(chunks.Select(chunk => chunk.Name), Is.EqualTo(new[] { "IHDR", "iTXt", "IDAT", "IEND" }));
            return;
        }

        Assert.That(chunks.Find(chunk => chunk.Name == "acTL").Content,
            Is.EqualTo(new byte[] { 0, 0, 0, (byte)count, 0, 0, 0, (byte)(repeats ? 0 : 1) }));
        List<byte[]> controls = [.. chunks.FindAll(chunk => chunk.Name == "fcTL").Select(chunk => chunk.Content)];
        Assert.That(controls.Select(control => control[4..]), Is.All.EqualTo(
            new byte[] { 0, 0, 0, 9, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 25, 0, 0 }), "the whole picture, for 1/25 s, in place");
        Assert.That(controls.Select(control => (int)control[3]), Is.EqualTo(Enumerable.Range(0, count).Select(k => Math.Max(2 * k - 1, 0))),
            "the control of the first frame, then that of each other one and its pixels");
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

    private static Color32[] Pixels(byte[] header, (string Name, byte[] Content) chunk)
    {
        using var still = new MemoryStream();
        still.Write(PngChunks.Signature);
        PngChunks.Write(still, "IHDR", header);
        PngChunks.Write(still, "IDAT", chunk.Content.AsSpan(chunk.Name == "fdAT" ? 4 : 0));
        PngChunks.Write(still, "IEND", []);
        return PngFile.Read(still.ToArray()).Pixels;
    }

    private static List<(string Name, byte[] Content)> Chunks(byte[] file)
    {
        var chunks = new List<(string, byte[])>();
        for (int at = 8; at < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            chunks.Add((Encoding.ASCII.GetString(file, at + 4, 4), file[(at + 8)..(at + 8 + length)]));
            at += 12 + length;
        }

        return chunks;
    }
}
