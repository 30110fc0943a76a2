using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Proof;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Golden tracks: what is told of one that differs, and their file.</summary>
    public sealed class GoldenComparisonTests
    {
        private const float k_Allowed = 0.01f;

        private static readonly string[] s_Things = { "root", "middle", "tip" };

        [Test]
        public void EqualTracks_AreHeldToTheLastBit()
        {
            List<ProofLine> lines = GoldenComparison.Lines(Tracks(), Tracks());
            Assert.That(lines.Select(line => line.state), Is.All.EqualTo(ProofState.Held));
            Assert.That(lines.Select(line => line.measured), Is.All.EqualTo("equal to the last bit"));
        }

        [TestCase(0.005f, 1)]
        [TestCase(0.02f, 2)]
        [TestCase(float.NaN, 2)]
        [TestCase(float.PositiveInfinity, 2)]
        public void AJointThatIsElsewhere_TurnsItsOwnLine(float by, int state)
        {
            List<GoldenTrack> computed = Tracks();

            // The second track, third of four samples, the middle, across.
            computed[1].Values[3 * (2 * s_Things.Length + 1) + 1] += by;
            List<ProofLine> lines = GoldenComparison.Lines(Tracks(), computed);

            Assert.That(lines.Select(line => (int)line.state), Is.EqualTo(new[] { 1, state, 1 }));
            Assert.That(lines[1].note, Does.StartWith("worst: middle, 75 % of the time"));
            Assert.That(lines[1].note.EndsWith("; 1 of 3 beyond"), Is.EqualTo(state == 2));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void TheLastBitOfEachNumber_Counts(int axis)
        {
            List<GoldenTrack> computed = Tracks();
            ref float number = ref computed[1].Values[3 * (2 * s_Things.Length + 1) + axis];
            number = BitConverter.Int32BitsToSingle(BitConverter.SingleToInt32Bits(number) ^ 1);
            List<ProofLine> lines = GoldenComparison.Lines(Tracks(), computed);

            Assert.That(lines.Select(line => line.measured == "equal to the last bit"), Is.EqualTo(new[] { true, false, true }));
            Assert.That((int)lines[1].state, Is.EqualTo(1));
        }

        [Test]
        public void TheFirstPlaceOfATrack_CountsAsAnyOther()
        {
            List<GoldenTrack> computed = Tracks();
            computed[0].Values[0] += 0.5f * k_Allowed;
            ProofLine line = GoldenComparison.Lines(Tracks(), computed)[0];

            Assert.That(line.measured, Is.Not.EqualTo("equal to the last bit"));
            Assert.That(line.note, Does.StartWith("worst: root, 25 % of the time"));
        }

        [Test]
        public void ADistance_IsThatInSpace()
        {
            List<GoldenTrack> computed = Tracks();
            computed[0].Values[0] += 0.003f;
            computed[0].Values[1] -= 0.004f;
            string measured = GoldenComparison.Lines(Tracks(), computed)[0].measured;
            Assert.That(float.Parse(measured, System.Globalization.CultureInfo.InvariantCulture), Is.EqualTo(0.005f).Within(1e-5f));
        }

        // The farthest is told wherever it stands among others that are off, and these are counted.
        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        public void OfSeveralThatAreOff_TheFarthestIsTold_AndAllThingsBeyondAreCounted(int worst)
        {
            (int sample, int thing)[] off = { (0, 2), (1, 0), (2, 2), (3, 0) };
            List<GoldenTrack> computed = Tracks();
            for (int k = 0; k < off.Length; k++)
                computed[0].Values[3 * (off[k].sample * s_Things.Length + off[k].thing) + 2] += k == worst ? 0.05f : 0.02f;
            computed[0].Values[3] += 0.5f * k_Allowed;
            ProofLine line = GoldenComparison.Lines(Tracks(), computed)[0];

            int time = 25 * (off[worst].sample + 1);
            Assert.That(line.note, Is.EqualTo($"worst: {s_Things[off[worst].thing]}, {time} % of the time; 2 of 3 beyond"));
            Assert.That(float.Parse(line.measured, System.Globalization.CultureInfo.InvariantCulture), Is.EqualTo(0.05f).Within(1e-5f));
            Assert.That((line.allowed, (int)line.state), Is.EqualTo(("0.01", 2)));
        }

        [Test]
        public void WhatIsJustAllowed_IsHeld()
        {
            var golden = new GoldenTrack("a", new[] { "x" }, 0.25f, new float[6]);
            var computed = new GoldenTrack("a", new[] { "x" }, 0.25f, new[] { 0f, 0f, 0f, 0f, 0.25f, 0f });
            ProofLine line = GoldenComparison.Lines(new[] { golden }, new[] { computed })[0];
            Assert.That((line.state, line.note), Is.EqualTo((ProofState.Held, "worst: x, 100 % of the time")));
        }

        [Test]
        public void AFirstDifferenceInTheSignOfZero_IsPassedOver_ForOneThatHasALength()
        {
            var golden = new GoldenTrack("a", new[] { "x", "y" }, 0.25f, new float[6]);
            var computed = new GoldenTrack("a", new[] { "x", "y" }, 0.25f, new[] { -0f, 0f, 0f, 0.1f, 0f, 0f });
            Assert.That(GoldenComparison.Lines(new[] { golden }, new[] { computed })[0].note, Does.StartWith("worst: y"));
        }

        [Test]
        public void ATrackThatIsMissing_OrOfAnotherLength_Differs()
        {
            List<GoldenTrack> computed = Tracks();
            computed.RemoveAt(0);
            computed[1] = new GoldenTrack(computed[1].Name, s_Things, k_Allowed, new float[9]);
            List<ProofLine> lines = GoldenComparison.Lines(Tracks(), computed);
            Assert.That(lines.Select(line => (int)line.state), Is.EqualTo(new[] { 2, 1, 2 }));
            Assert.That(lines[0].measured, Is.EqualTo("no such track"));
            Assert.That(lines[2].measured, Is.EqualTo("1 samples of 3 things"));
        }

        [Test]
        public void AFile_GivesBackWhatWasWritten()
        {
            IReadOnlyList<GoldenTrack> read = GoldenFile.Read(new MemoryStream(Bytes()));
            Assert.That(read.Select(track => track.Name), Is.EqualTo(Tracks().Select(track => track.Name)));
            Assert.That(read[2].Values, Is.EqualTo(Tracks()[2].Values));
            Assert.That(read[2].Things, Is.EqualTo(s_Things));
            Assert.That(read[2].Allowed, Is.EqualTo(k_Allowed));
            Assert.That(read[2].Samples, Is.EqualTo(4));
        }

        [Test]
        public void AFileThatIsNone_OrCutShort_IsRefused()
        {
            byte[] whole = Bytes();
            Assert.That(() => GoldenFile.Read(new MemoryStream(new byte[40])), Throws.TypeOf<InvalidDataException>());
            Assert.That(() => GoldenFile.Read(new MemoryStream(whole, 0, whole.Length - 1)),
                Throws.TypeOf<InvalidDataException>().With.Message.EqualTo("The file of golden flights is cut short."));
            whole[8] = whole[9] = whole[10] = 0x7F;
            Assert.That(() => GoldenFile.Read(new MemoryStream(whole)),
                Throws.TypeOf<InvalidDataException>().With.Message.Contains("count of"));
        }

        // Counts of tracks, things and values are read up to their limits, and not beyond.
        [TestCase(0, 1000)]
        [TestCase(1, 100_000)]
        [TestCase(2, 10_000_000)]
        public void ACount_IsWithinItsLimits(int which, int most)
        {
            foreach (int count in new[] { -1, most + 1, most })
            {
                var stream = new MemoryStream();
                using (var writer = new BinaryWriter(stream, System.Text.Encoding.UTF8, true))
                {
                    writer.Write(0x44474C41);
                    writer.Write(1);
                    writer.Write(which == 0 ? count : 1);
                    writer.Write("track");
                    writer.Write(which == 1 ? count : 0);
                    writer.Write(0f);
                    if (which == 2)
                        writer.Write(count);
                }

                stream.Position = 0;
                string told = count == most
                    ? "The file of golden flights is cut short."
                    : $"The file of golden flights has a count of {count}; allowed are 0 to {most}.";
                if (which == 1 && count == most)
                    continue;
                Assert.That(() => GoldenFile.Read(stream), Throws.TypeOf<InvalidDataException>().With.Message.EqualTo(told));
            }
        }

        [TestCase(0)]
        [TestCase(4)]
        public void AnotherMark_OrVersion_IsRefused(int at)
        {
            byte[] bytes = Bytes();
            bytes[at]++;
            Assert.That(() => GoldenFile.Read(new MemoryStream(bytes)), Throws.TypeOf<InvalidDataException>().With.Message.EqualTo(
                "The file of golden flights is not one, or of another version."));
        }

        [Test]
        public void AStream_StaysOpen_ForWhatFollows()
        {
            var stream = new MemoryStream();
            GoldenFile.Write(stream, Tracks());
            GoldenFile.Write(stream, Tracks());
            stream.Position = 0;
            Assert.That(GoldenFile.Read(stream).Count, Is.EqualTo(3));
            Assert.That(GoldenFile.Read(stream).Count, Is.EqualTo(3));
        }

        private static byte[] Bytes()
        {
            var stream = new MemoryStream();
            GoldenFile.Write(stream, Tracks());
            return stream.ToArray();
        }

        // Four samples of three things each.
        private static List<GoldenTrack> Tracks() => Enumerable.Range(1, 3).Select(Track).ToList();

        private static GoldenTrack Track(int number) => new GoldenTrack(
            $"track {number}", s_Things, k_Allowed, Enumerable.Range(0, 36).Select(k => 0.1f * number * k).ToArray());
    }
}
