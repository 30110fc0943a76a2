using System;
using System.IO;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>
    /// The text of recordings: what is read has the bits that were written, and what is no recording is told in one line.
    /// </summary>
    public sealed class RecordingTextTests
    {
        private const string k_Small = "alate flight 1\npackage 0.1.0\ninsect monarch\nmodel 0000abcd\nstart 0 0 0\nstep 0.02\nwind 0 0 0\n"
            + "gravity 0 -9.81 0\naid 0\ngo 0 0 1 -\nfly 9\nend 10\n";

        [Test]
        public void ARecording_IsReadToTheBit([Values(1u, 2u, 3u)] uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var recording = new FlightRecording
            {
                Package = "1.2.3",
                Insect = "monarch",
                Key = random.NextUInt(),
                Options = "--pilot wander --seed 7",
                Start = new FlightStart
                {
                    settled = seed == 1,
                    condition = seed == 1 ? new FlightCondition(0.3f, -0f) : default,
                    heading = random.NextFloat(),
                    phase = seed == 1 ? 0f : 12.3f
                },
            };
            recording.Wings.Add(new RecordedPlace
            {
                hinge = random.NextFloat3(),
                axes = new float3x3(
                random.NextFloat3(), random.NextFloat3(), random.NextFloat3())
            });
            var step = new RecordedStep { length = 0.02f, count = 1, gravity = new float3(0f, -9.81f, 0f) };
            for (int k = 0; k < 400; k++)
            {
                if (random.NextInt(4) == 0)
                {
                    step.velocity = math.asfloat(new uint3(random.NextUInt(), random.NextUInt(), random.NextUInt()) & 0x7EFFFFFFu)
                        * new float3(1f, -1f, 0f);
                }
                if (random.NextInt(9) == 0)
                    step.heading = random.NextBool() ? float.NaN : random.NextFloat(-4f, 4f);
                if (random.NextInt(20) == 0)
                    (step.wind, step.aid, step.count) = (random.NextFloat3(), random.NextFloat(), random.NextInt(1, 4));
                if (random.NextInt(25) == 0)
                    step.isUnguarded = !step.isUnguarded;
                if (random.NextInt(30) == 0)
                    step.length = random.NextFloat(1e-4f, 0.05f);
                if (random.NextInt(30) == 0)
                {
                    recording.Pushes.Add(new RecordedPush
                    {
                        step = k,
                        rotation = random.NextQuaternionRotation(),
                        velocity = random.NextFloat3(),
                        spin = random.NextFloat3(),
                        turn = random.NextFloat()
                    });
                }
                recording.Steps.Add(step);
            }

            string text = RecordingText.Write(recording);
            FlightRecording read = RecordingReader.Read(new StringReader(text));

            Assert.That(read.Steps, Is.EqualTo(recording.Steps));
            Assert.That(
                read.Steps.Select(at => math.asuint(at.velocity)), Is.EqualTo(recording.Steps.Select(at => math.asuint(at.velocity))),
                "signs of zeros");
            Assert.That(read.Pushes, Is.EqualTo(recording.Pushes));
            Assert.That(read.Wings, Is.EqualTo(recording.Wings));
            Assert.That((read.Package, read.Insect, read.Key, read.Options),
                Is.EqualTo((recording.Package, recording.Insect, recording.Key, recording.Options)));
            Assert.That(read.Start, Is.EqualTo(recording.Start));
            Assert.That(read.Seconds, Is.EqualTo(recording.Steps.Sum(at => at.count * (double)at.length)).Within(1e-9));
            Assert.That(RecordingText.Write(read), Is.EqualTo(text));
        }

        [Test]
        public void StepsWithoutAChange_AreOneLine()
        {
            FlightRecording recording = RecordingReader.Read(new StringReader(k_Small));
            Assert.That(recording.Steps, Has.Count.EqualTo(10));
            Assert.That(RecordingText.Write(recording), Is.EqualTo(k_Small));
        }

        [TestCase("", "no recording")]
        [TestCase("time_s,x_m\n", "no recording")]
        [TestCase("alate flight 2\nsomething new\n", "another version, 'alate flight 2'; this one reads 1")]
        [TestCase("alate flight 1\nmodel 1\n", "cut off at line 3")]
        [TestCase("alate flight 1\nmodel 1\nend 0\n", "which insect starts how")]
        [TestCase("alate flight 1\nmodel 1\nstart 0 0 0\nend 0\n", "no step")]
        public void WhatIsNoRecording_IsSaidInOneLine(string text, string said) => AssertRefused(text, said);

        [TestCase("fly 9", "fly 8", "Line 12: there are 9 steps")]
        [TestCase("end 10", "end ten", "Line 12")]
        [TestCase("end 10\n", "end 10\ngo 0 0 0 -\n", "Line 13: nothing follows")]
        [TestCase("model 0000abcd", "model moth", "Line 4: 'moth' is no key")]
        [TestCase("start 0 0 0", "start 0 0", "Line 5: '0 0' are not 3 numbers")]
        [TestCase("go 0 0 1 -", "go 0 0 NaN -", "Line 10: '0 0 NaN' are not 3 numbers")]
        [TestCase("go 0 0 1 -", "go 0 0 1e99 -", "Line 10")]
        [TestCase("go 0 0 1 -\n", "", "Line 10: steps need a command")]
        [TestCase("step 0.02", "step 0", "Line 6: a step needs")]
        [TestCase("step 0.02", "step 1.01", "Line 6: a step needs up to 1 s and a whole number of times from 1 to 1000")]
        [TestCase("step 0.02", "step -0.02", "Line 6: a step needs")]
        [TestCase("step 0.02", "step 0.02 0", "Line 6: a step needs")]
        [TestCase("step 0.02", "step 0.02 1001", "Line 6: a step needs")]
        [TestCase("step 0.02", "step 0.02 1 1", "Line 6")]
        [TestCase("step 0.02", "step 0.02 1.5", "Line 6: a step needs")]
        [TestCase("step 0.02\n", "", "Line 9: a command needs the length of a step")]
        [TestCase("fly 9", "fly 2000000000", "Line 11: a recording has at most")]
        [TestCase("fly 9", "fly -1", "Line 11: '-1' is no number of steps")]
        [TestCase("aid 0", "aid help", "Line 9: 'help' is not a number")]
        [TestCase("aid 0", "sail 0", "Line 9: 'sail' is no line of a recording")]
        public void AWrongLine_IsNamed(string right, string wrong, string said) => AssertRefused(k_Small.Replace(right, wrong), said);

        [Test]
        public void ALongWord_IsShortened() =>
            Assert.That(Refusal(k_Small.Replace("aid 0", new string('x', 9999))).Length, Is.LessThan(120));

        [Test]
        public void EveryCut_IsSeen()
        {
            string[] lines = k_Small.TrimEnd().Split('\n');
            for (int count = 0; count < lines.Length; count++)
                AssertRefused(string.Concat(lines.Take(count).Select(line => line + "\n")), "");
        }

        private static void AssertRefused(string text, string said) => Assert.That(Refusal(text), Does.Contain(said).And.Not.Contain("\n"));

        private static string Refusal(string text) =>
            Assert.Throws<FormatException>(() => RecordingReader.Read(new StringReader(text))).Message;
    }
}
