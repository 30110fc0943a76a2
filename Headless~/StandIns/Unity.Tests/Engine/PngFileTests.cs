using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;

namespace Unity.Tests.Engine;

public sealed class PngFileTests
{
    // Grey alone has fewer than 8 bits a channel.
    private static readonly object[] s_Kinds =
    [
        .. from colourType in new[] { 0, 2, 4, 6 }
        from depth in new[] { 1, 2, 4, 8, 16 }
        where depth >= 8 || colourType == 0
        from isInterlaced in new[] { false, true }
        select new object[] { colourType, depth, isInterlaced },
    ];

    [TestCaseSource(nameof(s_Kinds))]
    public void EveryKind_IsRead(int colourType, int depth, bool isInterlaced)
    {
        var sample = new PngSample { ColourType = colourType, Depth = depth, IsInterlaced = isInterlaced };

        var png = PngFile.Read(sample.Write());

        for (int k = 0; k < png.Pixels.Length; k++)
        {
            byte Channel(int channel)
            {
                int value = sample.Sample(k % 13, k / 13, channel);
                return (byte)(depth == 16 ? value >> 8 : value * 255 / sample.Most);
            }

            bool isGrey = colourType is 0 or 4;
            byte alpha = colourType is 4 or 6 ? Channel(sample.Channels - 1) : (byte)255;
            Assert.That(
                png.Pixels[k], Is.EqualTo(new Color32(Channel(0), Channel(isGrey ? 0 : 1), Channel(isGrey ? 0 : 2), alpha)), $"pixel {k}");
        }
    }

    [TestCase(1, 2)]
    [TestCase(2, 4)]
    [TestCase(4, 11)]
    [TestCase(8, 200)]
    public void Palette_IsLookedUp(int depth, int colours)
    {
        byte[] palette = new byte[3 * colours];
        new System.Random(depth).NextBytes(palette);
        var sample = new PngSample { ColourType = 3, Depth = depth, Palette = palette, Transparency = [7] };

        var png = PngFile.Read(sample.Write());

        for (int k = 0; k < png.Pixels.Length; k++)
        {
            int index = sample.Sample(k % 13, k / 13, 0);
            var colour = new Color32(palette[3 * index], palette[3 * index + 1], palette[3 * index + 2], index == 0 ? (byte)7 : (byte)255);
            Assert.That(png.Pixels[k], Is.EqualTo(colour));
        }
    }

    [Test]
    public void ColourKey_IsTransparent()
    {
        var sample = new PngSample { ColourType = 0, Transparency = [0, 37] };

        var png = PngFile.Read(sample.Write());

        for (int k = 0; k < png.Pixels.Length; k++)
            Assert.That(png.Pixels[k].a, Is.EqualTo(sample.Sample(k % 13, k / 13, 0) == 37 ? 0 : 255));
    }

    [Test]
    public void EveryTruncation_IsRefused()
    {
        byte[] whole = new PngSample().Write();
        for (int length = 0; length < whole.Length; length++)
            Assert.That(() => PngFile.Read(whole.AsMemory(0, length)), Throws.TypeOf<FormatException>(), $"{length} bytes");
    }

    [Test]
    public void EveryChangedByte_IsRefused()
    {
        byte[] whole = new PngSample().Write();
        for (int k = 0; k < whole.Length; k++)
        {
            byte[] changed = (byte[])whole.Clone();
            changed[k] ^= 0x10;
            Assert.That(() => PngFile.Read(changed), Throws.TypeOf<FormatException>(), $"byte {k}");
        }
    }

    [Test]
    public void PixelsThatAreMissing_AreSaid()
    {
        using var file = new MemoryStream();
        byte[] whole = new PngSample().Write();
        file.Write(whole, 0, 33);
        PngSample.WriteChunk(file, "IDAT", [0x78, 0x9C, 0x03, 0x00, 0x00, 0x00, 0x00, 0x01]);
        PngSample.WriteChunk(file, "IEND", []);

        Assert.That(() => PngFile.Read(file.ToArray()), Throws.TypeOf<FormatException>().With.Message.Contains("missing"));
    }

    [Test]
    public void Texture_BecomesWhatWasEncoded()
    {
        var texture = new Texture2D(5, 4);
        var pixels = new Color32[20];
        for (int k = 0; k < 20; k++)
            pixels[k] = new Color32((byte)k, (byte)(2 * k), (byte)(255 - k), (byte)(12 * k));
        texture.SetPixels32(pixels);

        var copy = new Texture2D(2, 2);
        Assert.That(copy.LoadImage(texture.EncodeToPNG()), Is.True);

        Assert.That((copy.width, copy.height), Is.EqualTo((5, 4)));
        Assert.That(copy.GetPixels32(), Is.EqualTo(pixels));
    }

    [Test]
    public void Texture_RefusesWhatIsNoPicture_AndCanBecomeUnreadable()
    {
        var texture = new Texture2D(2, 2);

        Assert.That(texture.LoadImage([1, 2, 3]), Is.False);
        Assert.That(texture.LoadImage(new PngSample().Write(), true), Is.True);
        Assert.That(texture.isReadable, Is.False);
        Assert.That(() => texture.GetPixels32(), Throws.TypeOf<UnityException>());
    }
}
