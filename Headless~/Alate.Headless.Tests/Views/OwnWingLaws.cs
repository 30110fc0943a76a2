using System;
using System.Linq;
using System.Text;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Views;

/// <summary>Files that are dropped on the page: what is taken, and what is said of it.</summary>
public sealed class OwnWingLaws
{
    private static readonly byte[] s_Mesh = Encoding.UTF8.GetBytes(Tests.Cli.OwnWing.Obj(side: WingSide.Right));

    [TestCase(59, 59)]
    [TestCase(60, 60)]
    [TestCase(61, 60)]
    [TestCase(90, 60)]
    public void ANameOfAWing_HasSixtyLettersAtMost(int letters, int told) =>
        Assert.That(Alate.Cli.OwnWing.Read(new string('w', letters) + ".obj", s_Mesh).Name, Is.EqualTo(new string('w', told)));

    [Test]
    public void ADroppedMesh_SaysHowSureItsSkeletonIs()
    {
        string remark = Alate.Cli.OwnWing.Read("wing.obj", s_Mesh).Remark;

        Assert.That(remark, Does.Match(@"^Hinge, leading edge and tip were found with confidence (1\.00|0\.\d\d)\.( \S.*)?$"));
    }

    [Test]
    public void AMeshOfMoreThanFortyThousandTriangles_IsNotTaken()
    {
        var text = new StringBuilder("v 0 0 0\n");
        for (int k = 0; k <= 40002; k++)
            text.Append(FormattableString.Invariant($"v {Math.Cos(k * 1e-4):0.0000000} 0 {Math.Sin(k * 1e-4):0.0000000}\n"));
        for (int k = 0; k <= 40000; k++)
            text.Append(FormattableString.Invariant($"f 1 {k + 2} {k + 3}\n"));

        Assert.That(() => Alate.Cli.OwnWing.Read("fan.obj", Encoding.UTF8.GetBytes(text.ToString())),
            Throws.TypeOf<UserException>().With.Message.EqualTo("fan.obj: the mesh has 40001 triangles; at most 40000 are taken."));
    }

    [TestCase(4001, 4000, "it has 16 million pixels; at most 16 million are taken.")]
    [TestCase(5000, 5000, "it has 25 million pixels; at most 16 million are taken.")]
    public void APictureOfMoreThanSixteenMillionPixels_IsNotTaken(int width, int height, string message) =>
        Assert.That(() => Alate.Cli.OwnWing.Read("wing.png", Header(width, height)),
            Throws.TypeOf<UserException>().With.Message.EqualTo("wing.png: " + message));

    [TestCase(new byte[] { 0xff, 0xfe, 0x00, 0x80, 0x81 })]
    [TestCase(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G' })]
    [TestCase(new byte[] { 0x89, (byte)'J', (byte)'N', (byte)'G', 0x0d })]
    public void BytesThatAreNoText_AreNeitherPictureNorMesh(byte[] content) =>
        Assert.That(() => Alate.Cli.OwnWing.Read("wing.dat", content), Throws.TypeOf<UserException>().With.Message
            .EqualTo("wing.dat: it is neither a PNG picture nor a text file with a mesh (OBJ)."));

    [Test]
    public void LimitsOfAWing_AreThoseOfTheManual()
    {
        string page = System.IO.File.ReadAllText(System.IO.Path.Combine(PackageRoot.Find(), "Documentation~", "live-view.md"));

        Assert.That(page, Does.Contain(FormattableString.Invariant(
            $"at most {Alate.Cli.OwnWing.MostTriangles:#,0} triangles or {Alate.Cli.OwnWing.MostPixels / 1e6:0.##} million pixels, ")
            + FormattableString.Invariant($"in a file of at most {PageSocket.LongestFile / 1048576.0:0.##} MB")));
    }

    // Signature, and the first chunk with its size.
    private static byte[] Header(int width, int height) =>
    [
        0x89, (byte)'P', (byte)'N', (byte)'G', 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, (byte)'I', (byte)'H', (byte)'D', (byte)'R',
        .. BitConverter.GetBytes(width).Reverse(), .. BitConverter.GetBytes(height).Reverse(), 8, 6, 0, 0, 0, 0, 0, 0, 0,
    ];
}
