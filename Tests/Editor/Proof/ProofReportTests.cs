using System.IO;
using System.Linq;
using Alate.Proof;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Report, options and steps of a proof.</summary>
    public sealed class ProofReportTests
    {
        [Test]
        public void AReport_CountsItsLines_AndShowsEachInATableOfItsPipeline()
        {
            var report = new ProofReport { package = "1.2.3" };
            report.parts.Add(Part(
                "builtin", "golden", ProofLine.Of("a", true, "0.1", "0.2"), ProofLine.Of("b", false, "0.3", "0.2", "tip|root\nx")));
            report.parts.Add(Part("urp", "scenes", ProofLine.NotTried("c", "no device")));
            report.parts[1].pictures.Add("urp/Garden%2001%20s.png");
            string text = report.Markdown();

            Assert.That(report.Summary, Is.EqualTo("1 held, 1 differ, 1 not tried"));
            Assert.That(text, Does.StartWith("# Proof of Alate 1.2.3\n\n1 held, 1 differ, 1 not tried.\n"));
            Assert.That(text, Does.Contain("| golden | a | 🟢 held | 0.1 | 0.2 |  |\n"));
            Assert.That(text, Does.Contain("| golden | b | 🔴 **differs** | 0.3 | 0.2 | tip\\|root x |\n"));
            Assert.That(text, Does.Contain("| scenes | c | ⚪ not tried |  |  | no device |\n"));
            Assert.That(text.IndexOf("## builtin"), Is.LessThan(text.IndexOf("## urp")));
            Assert.That(text, Does.Contain("](urp/Garden%2001%20s.png)"));
        }

        [Test]
        public void APart_ComesBackFromItsFile()
        {
            string folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            try
            {
                ProofPart part = Part("urp", "golden", ProofLine.Of("a", false, "1", "2", "3"), ProofLine.NotTried("b"));
                part.Write(folder);
                part.Write(folder);
                var read = ProofPart.Read(ProofPart.PathOf(folder, "urp", "golden"));
                Assert.That(read.lines.Select(line => $"{line.what} {line.state} {line.measured} {line.allowed} {line.note}"),
                    Is.EqualTo(new[] { "a Differs 1 2 3", "b NotTried   " }));
                Assert.That(Directory.GetFiles(Path.Combine(folder, "urp")), Has.Length.EqualTo(1));
                File.WriteAllText(ProofPart.PathOf(folder, "urp", "golden"), "{\"step\": ");
                Assert.That(ProofPart.Read(ProofPart.PathOf(folder, "urp", "golden")), Is.Null);
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void Options_ThatCannotBe_AreToldByTheirValues()
        {
            string file = Path.GetTempFileName(), folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            string data = Path.Combine(folder, "Editor", "Proof", "Data~");
            try
            {
                Directory.CreateDirectory(data);
                File.WriteAllText(Path.Combine(data, "golden.bin"), "");
                ProofOptions With(string editor, string package, string output, params string[] pipelines) => new ProofOptions
                {
                    Editor = editor,
                    Package = package,
                    Out = output,
                    Pipelines = pipelines,
                    Contents = "/unity",
                };
                Assert.That(With(file, folder, "out", "builtin").FindProblem(), Is.Null);
                Assert.That(With("/none", folder, "out", "builtin").FindProblem(),
                    Is.EqualTo("There is no editor at '/none'; give the path of Unity's program."));
                Assert.That(With(file, "/none", "out", "builtin").FindProblem(),
                    Is.EqualTo("There is no package Alate in '/none'; its golden flights are missing."));
                Assert.That(With(file, folder, "out", "gl").FindProblem(),
                    Is.EqualTo("'gl' is no render pipeline; allowed are builtin, urp, hdrp."));
                Assert.That(With(file, folder, "out").FindProblem(),
                    Is.EqualTo("No render pipeline is named; allowed are builtin, urp, hdrp."));
                Assert.That(With(file, folder, "out", "urp").FindProblem(), Is.EqualTo(
                    "The editor in '/unity' comes without the package com.unity.render-pipelines.universal; leave out urp."));
                Assert.That(With(file, folder, "", "builtin").FindProblem(), Is.EqualTo("No folder is named for the report."));
            }
            finally
            {
                File.Delete(file);
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void Arguments_NameTheMethodThatIsThere()
        {
            var options = new ProofOptions { Out = "/out", Package = "/package" };
            foreach (ProofStep step in ProofStep.All.Where(step => !step.IsTests))
            {
                var arguments = step.Arguments("/project", options, "urp").ToList();
                string method = arguments[arguments.IndexOf("-executeMethod") + 1];
                int dot = method.LastIndexOf('.');
                System.Type type = typeof(ProofSteps).Assembly.GetType(method.Substring(0, dot));
                Assert.That(type?.GetMethod(method.Substring(dot + 1)), Is.Not.Null, method);
                Assert.That(ProofArguments.Find(arguments.ToArray(), ProofArguments.Pipeline), Is.EqualTo("urp"));
                Assert.That(ProofArguments.Find(arguments.ToArray(), ProofArguments.Out), Is.EqualTo("/out"));
            }

            string[] tests = ProofStep.All.Where(step => step.IsTests)
                .SelectMany(step => step.Arguments("/project", options, "urp")).ToArray();
            Assert.That(tests, Is.SupersetOf(new[] { "EditMode", "PlayMode" }));
            Assert.That(tests, Is.All.Not.EqualTo("-quit"));
        }

        private static ProofPart Part(string pipeline, string step, params ProofLine[] lines)
        {
            var part = new ProofPart { pipeline = pipeline, step = step };
            part.lines.AddRange(lines);
            return part;
        }
    }
}
