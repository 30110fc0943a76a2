using System;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Limits of typed and read input: it is taken at them, and refused beyond them in one line that says what is allowed.</summary>
public sealed class InputLaws
{
    [TestCase("triangles", 0)]
    [TestCase("Triangles", 0)]
    [TestCase("1", 1)]
    [TestCase("1000000", 1000000)]
    [TestCase("0", null)]
    [TestCase("1000001", null)]
    [TestCase("-1", null)]
    [TestCase("1.5", null)]
    public void Elements_AreTrianglesOrANumberOfPatches(string typed, int? patches)
    {
        if (patches != null)
        {
            Assert.That(FlyOptions.Patches(typed), Is.EqualTo(patches));
        }
        else
        {
            Assert.That(() => FlyOptions.Patches(typed), Throws.TypeOf<UserException>().With.Message
                .EqualTo($"--elements takes 'triangles' or a number of patches from 1 to 1000000, not '{typed}'."));
        }
    }

    [TestCase("1,2\n", ", line 1: '1,2' is no place; X,Y,Z in metres, each up to 1000, are needed.")]
    [TestCase("1,2,3\n\n1,2,x\n", ", line 3: '1,2,x' is no place; X,Y,Z in metres, each up to 1000, are needed.")]
    [TestCase("1,2,3\n0,-1001,0\n", ", line 2: '0,-1001,0' is no place; X,Y,Z in metres, each up to 1000, are needed.")]
    [TestCase("1,2,3,4\n", ", line 1: '1,2,3,4' is no place; X,Y,Z in metres, each up to 1000, are needed.")]
    [TestCase("0,0,nan\n", ", line 1: '0,0,nan' is no place; X,Y,Z in metres, each up to 1000, are needed.")]
    [TestCase("\n \n", " has 0 places; 1 to 1000 are needed.")]
    [TestCase(null, " has 1001 places; 1 to 1000 are needed.")]
    public void PlacesOfAFile_AreThreeNumbersEach_UpToAThousandOfAThousandMetres(string text, string message)
    {
        using var run = new CommandRun();
        string path = run.Write("places.txt", text ?? string.Concat(Enumerable.Repeat("0,0,1\n", 1001)));

        Assert.That(run.Run("fly", "monarch", "--free", "--points", path, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors.Trim(), Is.EqualTo($"alate: {path}{message}"));
    }

    [Test]
    public void AFile_MayBeAsLargeAsIsSaid_AndNotEmpty()
    {
        using var run = new CommandRun();
        string path = run.Write("file", "");
        Refused(1, "it is empty, or no regular file.");
        using (FileStream file = File.OpenWrite(path))
            file.SetLength((2L << 20) + 1);
        Refused(2L << 20, "it is larger than 2 MiB.");
        using (FileStream file = InputFile.Open(path, (2L << 20) + 1))
            Assert.That(file.Length, Is.EqualTo((2L << 20) + 1));
        Assert.That(() => InputFile.Open(run.Folder, 1),
            Throws.TypeOf<UserException>().With.Message.EqualTo($"Cannot read '{run.Folder}': it is a folder."));
        string none = Path.Combine(run.Folder, "none");
        Assert.That(() => InputFile.Open(none, 1),
            Throws.TypeOf<UserException>().With.Message.EqualTo($"Cannot read '{none}': there is no such file."));

        void Refused(long most, string why) =>
            Assert.That(() => InputFile.Open(path, most),
                Throws.TypeOf<UserException>().With.Message.EqualTo($"Cannot read '{path}': {why}"));
    }

    [TestCase(60, 60)]
    [TestCase(61, 61)]
    [TestCase(500, 61)]
    public void AQuotedValue_IsCutAtSixtyLetters_NotWithinOne(int length, int shown)
    {
        Assert.That(Quote.Of(new string('a', length)), Has.Length.EqualTo(2 + shown));
        Assert.That(Quote.Of(new string('a', 59) + "\U0001F98B\U0001F98B"), Is.EqualTo($"'{new string('a', 59)}…'"));
        Assert.That(QuotedMessage.Words(new string('b', length) + " " + new string('c', 300)).Split(' ').Select(word => word.Length),
            Is.EqualTo(new[] { Math.Min(length, 261), 261 }));
        Assert.That(QuotedMessage.Values($"not '{new string('d', length)}'."), Has.Length.EqualTo(7 + shown));
    }

    [Test]
    public void Bytes_AreCutWhereALetterEnds_WithRoomForThreeDots([Values(3, 4, 5, 6, 7, 8, 20)] int most)
    {
        foreach (string text in new[] { "abcdefgh", "éééé", "蝶蝶蝶", "a\U0001F98Bb" })
        {
            string cut = QuotedMessage.Bytes(text, most);
            int whole = System.Text.Encoding.UTF8.GetByteCount(text);
            Assert.That(System.Text.Encoding.UTF8.GetByteCount(cut), Is.LessThanOrEqualTo(most));
            Assert.That(cut == text, Is.EqualTo(whole <= most));
            Assert.That(cut, whole <= most ? Is.EqualTo(text) : Does.EndWith("…").And.Not.Contain("\uFFFD"));
            if (whole > most)
            {
                string kept = cut[..^1];
                Assert.That(text, Does.StartWith(kept));
                int next = char.IsHighSurrogate(text[kept.Length]) ? 2 : 1;
                Assert.That(System.Text.Encoding.UTF8.GetByteCount(text[..(kept.Length + next)]) + 3, Is.GreaterThan(most),
                    "no letter more would fit");
            }
        }
    }

    [Test]
    public void AFileToWrite_IsNoFolder_AndHasAName()
    {
        using var temporary = new TemporaryFolder();
        foreach (string folder in new[] { temporary.Root, temporary.PathOf("none") + "/" })
        {
            Assert.That(() => OutputFile.Check(folder),
                Throws.TypeOf<UserException>().With.Message.EqualTo($"Cannot write '{folder}': it is a folder, not a file."));
        }

        OutputFile.Check(temporary.PathOf("a.txt"));
        Assert.That(temporary.Content, Is.Empty, "the trial is gone");
    }

    [TestCase(null, "Cannot write into")]
    [TestCase("--compare", "--free flies with the variant flight; it takes neither --compare, --variant nor --speed.")]
    [TestCase("--variant=standard", "--free flies with the variant flight; it takes neither --compare, --variant nor --speed.")]
    [TestCase("--speed=1", "--free flies with the variant flight; it takes neither --compare, --variant nor --speed.")]
    public void AFreeFilm_TakesItsOwnVariantAndSpeedAlone(string option, string message)
    {
        using var run = new CommandRun();
        string below = Path.Combine(run.Write("taken", ""), "below");
        string[] words = ["film", "monarch", "--free", "--out", below];

        Assert.That(run.Run(option == null ? words : [.. words, .. option.Split('=')]), Is.EqualTo(2));
        Assert.That(run.Errors, Does.StartWith($"alate: {message}"));
    }

    // A flight has one step at least.
    [TestCase(0.0, 0.05)]
    [TestCase(0.01, 0.05)]
    [TestCase(2.0, 2.0)]
    [TestCase(null, 10.0)]
    public void AFreeFlight_IsAtLeastAStepLong(double? typed, double seconds)
    {
        var options = new FreeOptions();
        var command = new System.CommandLine.Command("fly");
        options.AddTo(command);
        FreePlan plan = options.Plan(command.Parse(["--free", "--step", "0.05"]), "monarch", typed, null);

        Assert.That((plan.Seconds, plan.Steps), Is.EqualTo((seconds, (int)System.Math.Round(seconds / 0.05))));
    }

    [Test]
    public void FilesThatWereRead_AreNotedUntilTheNotesEnd()
    {
        using (ReadFiles.Begin())
        {
            ReadFiles.Add("a");
            ReadFiles.Add("b");
            ReadFiles.Add("a");
            Assert.That(ReadFiles.Paths, Is.EqualTo(new[] { "a", "b" }));
        }

        ReadFiles.Add("c");
        Assert.That(ReadFiles.Paths, Is.Empty);
    }

    [Test]
    public void AGust_IsToldAlongThreeAxes()
    {
        var options = new FreeOptions();
        var command = new System.CommandLine.Command("fly");
        options.AddTo(command);

        Assert.That(options.Plan(command.Parse(["--free", "--gust", "1,-2,3"]), "monarch", null, null).Gust,
            Is.EqualTo(new Unity.Mathematics.float3(1f, -2f, 3f)));
        Assert.That(options.Plan(command.Parse(["--free"]), "monarch", null, null).Gust, Is.EqualTo(default(Unity.Mathematics.float3)));
    }

    // Behind a command nothing holds files back any more.
    [Test]
    public void AFolder_IsHeldWhileACommandRuns_AndWrittenAtOnceOtherwise()
    {
        using var temporary = new TemporaryFolder();
        using (var held = HeldFolders.Begin())
        {
            using (var folder = OutputFolder.Prepare(temporary.Root))
            {
                folder.Write("a.txt", stream => stream.WriteByte(1));
                folder.Commit();
            }

            Assert.That(temporary.Content.Any(name => name == "a.txt"), Is.False);
            held.Commit();
            Assert.That(temporary.Content, Is.EqualTo(new[] { "a.txt" }));
        }

        using (var run = new CommandRun())
            Assert.That(run.Run("species", "--json", temporary.PathOf("b.json")), Is.Zero);
        using (var folder = OutputFolder.Prepare(temporary.Root))
        {
            folder.Write("c.txt", stream => stream.WriteByte(1));
            folder.Commit();
            Assert.That(temporary.Content, Is.EqualTo(new[] { "a.txt", "b.json", "c.txt" }));
        }

        using (HeldFolders.Begin())
        {
            using var folder = OutputFolder.Prepare(temporary.Root);
            folder.Write("d.txt", stream => stream.WriteByte(1));
            folder.Commit();
        }

        Assert.That(temporary.Content, Is.EqualTo(new[] { "a.txt", "b.json", "c.txt" }), "what was held and not committed is gone");
    }

    // Files of runs that are no more go; what may still be written stays.
    [Test]
    public void UnfinishedFiles_OfRunsThatAreNoMore_AreSweptAway()
    {
        using var temporary = new TemporaryFolder();
        string own = UnfinishedFiles.Suffix(3), machine = own[1..9], run = own.Split('-')[2][..16];
        string Name(string of, int process, string by) => $"a.txt.{of}-{process}-{by}.part";
        string other = new(run.Reverse().ToArray()), stranger = machine == "00000000" ? "11111111" : "00000000";
        DateTime now = DateTime.Now;
        (string Name, DateTime Written, bool Stays)[] files =
        [
            ("b.txt" + own, now, true), (Name(machine, Environment.ProcessId, other + "1"), now, false),
            (Name(stranger, 1, run + "1"), now.AddHours(-23), true), (Name(stranger, 1, run + "2"), now.AddHours(-25), false),
            (Name(machine, 999999999, run + "3"), now, false), ("a.part", now.AddYears(-1), true),
                (Name(machine, 999999999, "short"), now, true),
        ];
        foreach ((string name, DateTime written, _) in files)
            File.SetLastWriteTime(temporary.File(name, ""), written);
        UnfinishedFiles.Sweep(temporary.Root);

        Assert.That(temporary.Content, Is.EquivalentTo(files.Where(file => file.Stays).Select(file => file.Name)));
        Assert.That(() => UnfinishedFiles.Sweep(temporary.PathOf("none")), Throws.Nothing);
        Assert.That(UnfinishedFiles.Suffix(4), Is.Not.EqualTo(own));
    }

    [Test]
    public void Mounts_PutAWingOnItsHinge_AndMirrorTheLeftOne()
    {
        float3 hinge = new(1f, 2f, 3f), place = new(0.5f, 0.25f, -0.75f);
        WingMount right = new(hinge, 2f, WingSide.Right), left = right with { Side = WingSide.Left };

        Assert.That((right.ToBody(place), left.ToBody(place)), Is.EqualTo((new float3(2f, 2.5f, 1.5f), new float3(-2f, 2.5f, 1.5f))));
        Assert.That((right.DirectionToBody(place), left.DirectionToBody(place)), Is.EqualTo((place, new float3(-0.5f, 0.25f, -0.75f))));
        // Axes of turns are mirrored the other way: cross products of mirrored directions.
        Assert.That((right.AxisToBody(place), left.AxisToBody(place)), Is.EqualTo((place, new float3(0.5f, -0.25f, 0.75f))));
    }
}
