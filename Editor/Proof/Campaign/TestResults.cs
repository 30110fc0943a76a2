using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;

namespace Alate.Proof
{
    /// <summary>Results of Unity's test runner, a file in the format of NUnit 3.</summary>
    internal static class TestResults
    {
        public const string Claim = "the package's tests pass";

        /// <summary>Line of a results file; null where there is none.</summary>
        public static ProofLine Read(string path)
        {
            if (!File.Exists(path))
                return null;
            try
            {
                XElement run = XDocument.Load(path).Root;
                int total = Count(run, "total"), failed = Count(run, "failed");
                int passed = Count(run, "passed"), skipped = Count(run, "skipped");
                string first = run?.Descendants("test-case").FirstOrDefault(test => (string)test.Attribute("result") == "Failed")
                    ?.Attribute("fullname")?.Value ?? "";
                string measured = FormattableString.Invariant($"{passed} of {total} passed, {skipped} skipped");
                string note = failed == 0 ? "" : $"{failed} failed, first {first}";
                return ProofLine.Of(Claim, failed == 0 && passed > 0, measured, "0 failed", note);
            }
            catch (XmlException problem)
            {
                return ProofLine.Of(Claim, false, "no results", "0 failed", problem.Message);
            }
        }

        private static int Count(XElement run, string name) =>
            int.TryParse(run?.Attribute(name)?.Value, NumberStyles.Integer, CultureInfo.InvariantCulture, out int count) ? count : 0;
    }
}
