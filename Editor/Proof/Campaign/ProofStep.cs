using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Alate.Proof
{
    /// <summary>One start of an editor in the project of a proof, and the claims that it decides.</summary>
    internal sealed class ProofStep
    {
        /// <summary>Has Burst compile a job before it runs for the first time, not beside it.</summary>
        private const string k_Synchronous = "--burst-force-sync-compilation";

        private readonly string m_Method, m_Platform;
        private readonly Func<string, IEnumerable<string>> m_Claims;

        private ProofStep(string name, string method, string platform, Func<string, IEnumerable<string>> claims)
        {
            Name = name;
            m_Method = method;
            m_Platform = platform;
            m_Claims = claims;
        }

        /// <summary>All steps in their order; without the first none of the others can succeed.</summary>
        public static readonly ProofStep[] All =
        {
            Call(ProofSteps.ImportName, nameof(ProofSteps.Import), _ => new[] { ProofSteps.Imports, "the render pipeline is set" }),
            Tests("edit-tests", "EditMode"),
            Tests("play-tests", "PlayMode"),
            Call(ProofSteps.GoldenName, nameof(ProofSteps.Golden), GoldenClaims),
            Call(ProofSteps.TimesName, nameof(ProofSteps.Times), _ => FrameTimes.Claims()),
            Call(ProofSteps.ScenesName, nameof(ProofSteps.Scenes), SceneClaims),
            Call(ProofSteps.PlayerName, nameof(ProofSteps.Player), _ => new[] { PlayerProof.Builds, PlayerProof.Starts }),
        };

        /// <summary>Name of the step and of its files.</summary>
        public string Name { get; }

        /// <summary>True for a run of the package's tests.</summary>
        public bool IsTests => m_Platform != null;

        /// <summary>Claims that it decides.</summary>
        /// <param name="package">Folder of the package.</param>
        public IEnumerable<string> Claims(string package) => m_Claims(package);

        /// <summary>Path of what the editor writes: the lines of a method, or the results of the tests.</summary>
        public string ResultIn(string folder, string pipeline) =>
            IsTests ? Path.Combine(folder, pipeline, Name + ".xml") : ProofPart.PathOf(folder, pipeline, Name);

        /// <summary>Path of the editor's log.</summary>
        public string LogIn(string folder, string pipeline) => Path.Combine(folder, pipeline, Name + ".log");

        /// <summary>Arguments of the editor.</summary>
        /// <param name="project">Folder of the project.</param>
        /// <param name="options">Options of the proof.</param>
        /// <param name="pipeline">Its render pipeline.</param>
        public IEnumerable<string> Arguments(string project, ProofOptions options, string pipeline)
        {
            string[] start = new[] { "-batchmode", "-projectPath", project, "-logFile", LogIn(options.Out, pipeline) };
            return start.Concat(IsTests
                ? new[] { "-runTests", "-testPlatform", m_Platform, "-testResults", ResultIn(options.Out, pipeline) }
                : new[]
                {
                    "-executeMethod", $"{typeof(ProofSteps).FullName}.{m_Method}", ProofArguments.Out, options.Out,
                    ProofArguments.Pipeline, pipeline, ProofArguments.Package, options.Package, k_Synchronous,
                });
        }

        private static ProofStep Call(string name, string method, Func<string, IEnumerable<string>> claims) =>
            new ProofStep(name, method, null, claims);

        private static ProofStep Tests(string name, string platform) =>
            new ProofStep(name, null, platform, _ => new[] { TestResults.Claim });

        private static IEnumerable<string> GoldenClaims(string package)
        {
            using (FileStream file = File.OpenRead(ProofSteps.GoldenPath(package)))
                return GoldenFile.Read(file).Select(track => track.Name).ToList();
        }

        private static IEnumerable<string> SceneClaims(string package) =>
            Directory.GetFiles(Path.Combine(package, "Samples~"), "*.unity", SearchOption.AllDirectories)
                .Select(Path.GetFileNameWithoutExtension).OrderBy(name => name, StringComparer.Ordinal).Select(SceneTour.Claim);
    }
}
