using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Alate.Benchmarks;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Determinism
{
    /// <summary>
    /// Results equal to the last bit whatever the workers, the order of creation, the lanes and the instruction set. The held hashes
    /// are those of <see cref="SceneHashes"/>: after a change of the physics by intent, put there what <c>bench --hash</c> prints.
    /// </summary>
    public sealed class SceneHashTests
    {
        // Bodies, patterns, the showcase's camera, the sound and the wake, which is computed apart: no state depends on them.
        private static readonly Regex s_Looks = new Regex(@"Catalogue/Bodies/|Showcase/|Sound/|Wake/|(Body|Pattern)\.cs$"),
            s_Library = new Regex(
            @"(?<![\w.])(math|Math|MathF|Mathf)\.(sin|cos|sincos|tan|exp|exp2|exp10|pow|log|log2|log10|atan2?|asin|acos|[st]anh|cosh"
            + @"|Sin|Cos|SinCos|Tan|Exp|Pow|Log\w*|Atan2?|Asin|Acos|Cbrt)\("
            + @"|quaternion\.(AxisAngle|Euler\w*|Rotate[XYZ])\(|math\.slerp\(");

        [Test]
        public void ACrowd_HasTheHeldHash_InEveryOrderAndLane()
        {
            using var output = new StringWriter();

            Assert.That(SceneHashes.Run(output, "crowd"), Is.Zero, output.ToString());
            Assert.That(output.ToString(), Does.StartWith("crowd "));
        }

        // Eight workers also where there are fewer processors.
        [TestCase("DOTNET_PROCESSOR_COUNT=9", "DOTNET_EnableAVX2=0")]
        [TestCase("DOTNET_PROCESSOR_COUNT=9")]
        [Explicit]
        [Category("Long")]
        public void Scenes_HaveTheHeldHashes_InEveryOrderAndLane(params string[] variables)
        {
            string[] words = [Assembly.Load("Alate.Cli").Location, "bench", "--hash"];
            var start = new ProcessStartInfo("dotnet", words) { RedirectStandardOutput = true };
            foreach (string variable in variables)
                start.Environment[variable.Split('=')[0]] = variable.Split('=')[1];
            using var process = Process.Start(start);
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();

            Assert.That(process.ExitCode, Is.Zero, output);
            Assert.That(output.Split('\n').Count(line => line.Contains("0x")), Is.EqualTo(SceneHashes.Names.Count), output);
        }

        [Test]
        public void WhatMovesInsects_CallsNoLibraryForSinesAndPowers()
        {
            string root = PackageRoot.Find();
            IEnumerable<string> calls = from file in Directory.GetFiles(Path.Combine(root, "Runtime"), "*.cs", SearchOption.AllDirectories)
                                        let place = Path.GetRelativePath(root, file).Replace('\\', '/')
                                        where !s_Looks.IsMatch(place)
                                        from call in s_Library.Matches(File.ReadAllText(file))
                                        select $"{place}: {call.Value}";

            Assert.That(calls, Is.Empty, "Alate.Geometry.Elementary, Rotations and SoaMath give the same bits everywhere");
        }
    }
}
